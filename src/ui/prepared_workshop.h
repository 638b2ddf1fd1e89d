// PreparedWorkshop: what a workshop would make of the panels that are shown: names, passports, and the
// verdicts of the document's tolerance sheet. The window's tables, lists, names and colours are all about one
// of these.
//
// Threads: plain values; made on a worker. Units: millimetres and degrees, as core/workshop has them. Indices
// are of the iterate's panels.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/design/solve_session.h"
#include "core/mesh/closest_point.h"
#include "core/mesh/polygon_mesh.h"
#include "core/workshop/congruence.h"
#include "core/workshop/contract.h"
#include "core/workshop/panel_passport.h"
#include "core/workshop/tolerance_sheet.h"
#include "core/workshop/workshop_model.h"

namespace planewright::ui {

struct WorkshopJob {
  std::uint64_t layer = 0;  // whose panels they are
  std::shared_ptr<const Iterate> iterate;
  std::vector<int> numbers;  // #P, as the document tells them
  std::vector<std::pair<int, std::string>> given_names;
  WorkshopContract contract;
  std::string title;
  std::shared_ptr<const PolygonMesh> mesh;            // distances are measured from it,
  std::shared_ptr<const ReferenceSurface> reference;  // or from this, where it is not null
  bool thorough =
      true;  // false: a state on the way, of which classes and (unless limited) distances are left out
};

struct PreparedWorkshop {
  WorkshopJob job;
  std::shared_ptr<const ReferenceSurface> surface;  // that distances were measured from; null: none were
  std::shared_ptr<const WorkshopModel> model;
  std::vector<PanelPassport> passports;  // #P
  std::vector<CongruenceClass> classes;  // empty: not thorough
  std::vector<int> class_of_panel;       // #P, or empty
  ToleranceVerdicts verdicts;
};

// before: an earlier one, of which everything is kept that depends on nothing that has changed; may be null.
// Fails as make_workshop_model() and ReferenceSurface::create() do.
Result<PreparedWorkshop> prepare_workshop(const WorkshopJob& job, const PreparedWorkshop* before = nullptr);

}  // namespace planewright::ui
