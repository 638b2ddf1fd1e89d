// Clustering of a mesh's faces by variational shape approximation (Cohen-Steiner, Alliez and Desbrun, 2004):
// K connected regions, each with a proxy plane, so that the faces differ little from their region's proxy.
//
// Lloyd iterations fit the proxies to the regions and grow the regions again from their best faces. Region
// growing may raise the error; such an iteration is not kept, so that the error falls from one kept to the
// next. Teleports then leave bad minima: the region whose merging costs least goes, a new one starts at the
// worst face of the worst region, and the result is kept if the error fell. Regions may have any shape that
// is connected; make_regions() (regions.h) makes panels of them.
//
// Frame and units: those of FaceGraph; errors have no unit and do not change with the model's scale or place.
// Indices: 0-based. Threads: pure; the same input gives the same bits. Ties go to the lower index.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/cluster/face_graph.h"
#include "core/cluster/proxy.h"

namespace planewright {

enum class SeedKind {
  Random,    // K faces drawn by std::mt19937, the same on every platform
  Farthest,  // each the face that differs most in place and normal from those before
  Given      // ClusterOptions::given
};

struct ClusterOptions {
  int panels = 50;  // K; with a target the most that may be used
  // Stop at the least number of regions found that meets these (all that are given), each a root mean square
  // over the area: |n_T - n|, about radians; |(x - c) . n| as a share of the square root of the area.
  std::optional<double> target_normal, target_distance;
  ClusterMetric metric;
  SeedKind seeds = SeedKind::Farthest;
  std::uint32_t seed_number = 1;  // Random
  std::vector<int> given;         // Given: `panels` distinct faces
  int iterations = 30;            // Lloyd iterations at most, each time
  int teleports = 30;             // tries at most
};

struct Clustering {
  std::vector<int> region_of_face;  // #F
  std::vector<Proxy> proxies;       // #K
  std::vector<double> errors;       // #K, by the metric
  double error = 0.0;               // their sum
  double normal_error = 0.0;        // root mean squares, as the targets above
  double distance_error = 0.0;
  bool target_met = true;  // false: a target was given, and `panels` regions do not meet it
  bool stopped = false;    // ended by the stop token: valid, but not the best
  int iterations = 0;      // in all
  int teleports = 0;       // that were kept

  int regions() const { return static_cast<int>(proxies.size()); }
};

struct ClusterProgress {
  int iteration;  // counted from 1
  double error;
  bool teleport;  // the first after one that was kept: errors fall from here again
  std::span<const int> region_of_face;
  std::span<const Proxy> proxies;
};
// Hears of every iteration that was kept, on the caller's thread; the spans live until it returns.
class ClusterObserver {
 public:
  virtual ~ClusterObserver() = default;
  virtual void on_iteration(const ClusterProgress& progress) = 0;
};

// start: a clustering of the same graph to go on from: its regions stay, new ones start at the worst faces of
// the worst regions, those too many are merged where that costs least; then a few iterations. Teleports are
// left out, so that a slider shows its result at once. Refused (ErrorCode::Usage): panels below 1, above the
// number of faces, or below that of components, each with both numbers; given seeds that are not `panels`
// distinct faces, or leave a component without one; a metric as by check_metric(); a target that is not
// positive; a start of another mesh.
// A stop is obeyed between iterations, and leaves a whole clustering.
Result<Clustering> cluster(const FaceGraph& graph, const ClusterOptions& options,
                           ClusterObserver* observer = nullptr, std::stop_token stop = {},
                           const Clustering* start = nullptr);

// The clustering that region_of_face means: 0..K-1, each region with a face and connected. Refused
// (ErrorCode::Refused) otherwise, naming region or face.
Result<Clustering> clustering_of(const FaceGraph& graph, std::vector<int> region_of_face,
                                 const ClusterMetric& metric);

}  // namespace planewright
