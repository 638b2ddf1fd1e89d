// ViewPreparer: turns iterates into what the window shows, on a thread of its own.
//
// Measuring 10,000 panels (planarity, displacement), offsetting them by a thickness and building
// beams takes longer than a frame may; so a worker takes the newest iterate of each layer, and the window's
// thread picks up arrays that are ready to upload. Iterates of a layer that arrive while one is being
// prepared replace each other; the last one of a solve is never replaced by an earlier one. The same worker
// makes the ghost's arrays from the mesh being designed on, before anything else, and looks for bad places:
// of a view at once where that is quick, else when nothing else is waiting.
//
// Threads: submit() and the takes from the window's thread; neither waits for the worker's computing.
// Units: model units; positions relative to the scene's origin.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/design/solve_session.h"
#include "core/diagnose/planarity.h"
#include "core/edit/element_names.h"
#include "core/layers/parallel_offset.h"
#include "ui/mesh_view.h"
#include "ui/prepared_findings.h"
#include "ui/render/panel_arrays.h"

namespace planewright::ui {

struct PrepareJob {
  std::shared_ptr<const Iterate> iterate;
  std::shared_ptr<const ElementIds> ids = {};     // of the mesh that it is of
  Vector3d scene_origin = Vector3d::Zero();       // model coordinates of the scene's 0
  bool final = false;                             // the outcome of a solve
  std::uint64_t layer = 0;                        // whose state it is; jobs of other layers do not replace it
  std::uint64_t number = 0;                       // of the job: tells views of the same state apart
  double thickness = 0.0;                         // of the panels, along their normals; 0: none
  std::shared_ptr<const Iterate> neighbour = {};  // the layer that beams lead to; null: none
  FindingSettings thresholds = {};                // of the findings
};

// One quad per panel edge between two layers, or between the two sides of thick panels.
struct PreparedBeams {
  render::PanelArrays arrays;  // scene coordinates; none where refused
  int count = 0;
  double planarity = 0.0;  // the largest, model units
  double twist = 0.0;      // the largest, radians
  int most_twisted = -1;   // panel edge of the iterate's complex
  std::string refused;     // why there are none
};

struct PreparedThickness {
  render::PanelArrays back;  // the panels' other side, scene coordinates
  PreparedBeams sides;       // between the two
  std::vector<ParallelOffset::Blunted> blunted;
  std::vector<ParallelOffset::Residual> residuals;
  double largest_residual = 0.0;  // model units
};

struct PreparedView {
  std::shared_ptr<const Iterate> iterate;
  std::shared_ptr<const ElementIds> ids;  // as the job had them
  bool final = false;
  std::uint64_t layer = 0, number = 0;
  double thickness_wanted = 0.0;  // as the job had it
  Points points;                  // #X x 3, scene coordinates
  render::PanelArrays panels;     // of these points, for the renderer
  Planarity planarity;
  Displacement displacement;
  std::shared_ptr<const PreparedThickness> thickness;        // null: none wanted
  std::shared_ptr<const PreparedBeams> beams;                // to the neighbour; null: none wanted
  Vector3d low = Vector3d::Zero(), high = Vector3d::Zero();  // bounding box, scene coordinates
  std::uint64_t fingerprint = 0;  // of the points' bits: equal states have equal fingerprints
  double milliseconds = 0.0;      // spent preparing

  std::uint64_t ticket() const { return iterate->ticket; }
  const TangentComplex& complex() const { return *iterate->complex; }
};

// `before`: the geometry of an earlier view; kept where the panels are the same.
PreparedView prepare_view(const PrepareJob& job, std::shared_ptr<const render::PanelGeometry> before = {});

struct PreparedGhost {
  std::shared_ptr<const MeshView> mesh;
  render::GhostArrays arrays;
};

class ViewPreparer {
 public:
  // `wake`: called on the worker when a view is ready.
  explicit ViewPreparer(std::function<void()> wake);
  ~ViewPreparer();
  ViewPreparer(const ViewPreparer&) = delete;
  ViewPreparer& operator=(const ViewPreparer&) = delete;

  void submit(PrepareJob job);
  void submit(std::shared_ptr<const MeshView> mesh);
  // The newest view of some layer that was not taken yet, or null.
  std::shared_ptr<const PreparedView> take();
  std::shared_ptr<const PreparedGhost> take_ghost();
  // The newest findings of some layer that were not taken yet, or null; of views that take() gave or gives.
  std::shared_ptr<const PreparedFindings> take_findings();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace planewright::ui
