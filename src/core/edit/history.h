// History: what a design was after each step, and which of these moments is the present one.
//
// Moments share their meshes, numbers and results, so that going back restores the very same ones. Threads:
// one thread.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/design/clustered_mesh.h"
#include "core/design/layer_settings.h"
#include "core/edit/element_names.h"
#include "core/mesh/polygon_mesh.h"
#include "core/workshop/contract.h"

namespace planewright {

// What is shown of a design: the states that solves came to. Whoever shows them says what they are.
class ShownResults {
 public:
  virtual ~ShownResults() = default;
};

struct Moment {
  std::uint64_t number = 0;  // given by the history: of no other moment, nor of this one before it changed
  std::string what;          // the step that led here: "Flip edge 1042"
  std::string merge_key;     // of that step, see History::merge()
  std::shared_ptr<const PolygonMesh> mesh;
  std::shared_ptr<const ElementIds> ids;  // of the mesh's elements
  Design design;
  WorkshopContract contract;
  SharedClusters clusters;                      // of the mesh; null: none are known
  std::shared_ptr<const ShownResults> results;  // may be null
};

class History {
 public:
  // Forgets everything; `opened` is the moment that no step led to.
  void begin(Moment opened);

  const Moment& present() const { return moments_[done_]; }
  int steps() const { return static_cast<int>(moments_.size()) - 1; }
  int done() const { return static_cast<int>(done_); }  // steps 0..done()-1 are in force
  const std::string& step_name(int step) const { return moments_[static_cast<std::size_t>(step) + 1].what; }

  // A step from the present to `next`. Steps that were taken back are gone. Follows the present step as part
  // of it if both have the same key, not empty, and no end_merge() lies between; and if that leads to what
  // was before, neither is left.
  void step(Moment next);
  void end_merge() { merging_ = false; }
  bool merging() const { return merging_; }
  // The clusters of the present moment from now on; no step.
  void set_clusters(SharedClusters clusters);
  // Shown at the present moment from now on; no step.
  void set_results(std::shared_ptr<const ShownResults> results) {
    moments_[done_].results = std::move(results);
  }

  // Clamped to the steps there are.
  void go_to(int done);

 private:
  std::vector<Moment> moments_{Moment{}};  // one more than steps
  std::size_t done_ = 0;
  bool merging_ = false;
  std::uint64_t next_number_ = 1;
};

}  // namespace planewright
