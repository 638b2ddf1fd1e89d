#include "core/cluster/regions.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/cluster/border_anchors.h"
#include "core/cluster/partition.h"
#include "core/cluster/region_shape.h"

namespace planewright {
namespace {

class Builder {
 public:
  Builder(const FaceGraph& graph, const RegionOptions& options, Regions& regions)
      : graph_(graph),
        regions_(regions),
        shapes_(graph, regions.region_of_face),
        faces_(faces_of_regions(regions.region_of_face, regions.count())),
        tolerance_(options.border_tolerance / std::sqrt(static_cast<double>(regions.count()))),
        is_corner_(static_cast<size_t>(graph.vertices.rows()), 0) {}

  void build() {
    for (int r = 0; r < regions_.count(); ++r) loops_.push_back(shapes_.of(faces_[r]).loops.front());
    for (size_t v = 0; v < is_corner_.size(); ++v)
      is_corner_[v] = shapes_.is_corner(static_cast<int>(v)) ? 1 : 0;
    // Anchors are told apart from corners until all are found: outlines do not change on the way.
    for (int r = 0; r < regions_.count(); ++r) add_anchors(r);
    for (const int v : anchors_) is_corner_[v] = 1;
    number_corners();
    count_edges();
  }

 private:
  void add_anchors(int r) {
    const std::vector<int>& loop = loops_[r];
    const size_t n = loop.size();
    std::vector<size_t> at;
    for (size_t k = 0; k < n; ++k)
      if (is_corner_[graph_.tail(loop[k])]) at.push_back(k);
    if (at.empty()) {  // a part of the mesh that is one region: all of its outline is border
      const size_t start = farthest_from_middle(loop);
      anchors_.push_back(graph_.tail(loop[start]));
      add_border_anchors(graph_, chain(loop, start, start + n), tolerance_, 2, anchors_);
      return;
    }
    // Each stretch of the border as it needs, and the most curved one what the region lacks.
    const int missing = 3 - static_cast<int>(at.size());
    const size_t before = anchors_.size();
    std::vector<std::vector<int>> chains;
    for (size_t k = 0; k < at.size(); ++k) {
      if (graph_.across[loop[at[k]]] >= 0) continue;
      chains.push_back(chain(loop, at[k], k + 1 < at.size() ? at[k + 1] : at[0] + n));
      add_border_anchors(graph_, chains.back(), tolerance_, 0, anchors_);
    }
    if (missing <= static_cast<int>(anchors_.size() - before)) return;
    anchors_.resize(before);
    const auto longest = std::max_element(chains.begin(), chains.end(),
                                          [](const auto& a, const auto& b) { return a.size() < b.size(); });
    if (longest != chains.end()) add_border_anchors(graph_, *longest, tolerance_, missing, anchors_);
  }

  std::vector<int> chain(const std::vector<int>& loop, size_t from, size_t to) const {
    std::vector<int> vertices;
    for (size_t k = from; k <= to; ++k) vertices.push_back(graph_.tail(loop[k % loop.size()]));
    return vertices;
  }

  size_t farthest_from_middle(const std::vector<int>& loop) const {
    Vector3d middle = Vector3d::Zero();
    for (const int c : loop)
      middle += graph_.vertices.row(graph_.tail(c)).transpose() / static_cast<double>(loop.size());
    size_t best = 0;
    double most = -1.0;
    for (size_t k = 0; k < loop.size(); ++k) {
      const double d = (graph_.vertices.row(graph_.tail(loop[k])).transpose() - middle).norm();
      if (d > most) {
        most = d;
        best = k;
      }
    }
    return best;
  }

  void number_corners() {
    std::vector<int> number(is_corner_.size(), -1);
    for (size_t v = 0; v < is_corner_.size(); ++v) {
      if (!is_corner_[v]) continue;
      number[v] = static_cast<int>(regions_.corner_vertex.size());
      regions_.corner_vertex.push_back(static_cast<int>(v));
    }
    std::vector<std::vector<int>> regions_of(regions_.corner_vertex.size());
    for (int r = 0; r < regions_.count(); ++r) {
      std::vector<int> corners;
      for (const int c : loops_[r])
        if (const int corner = number[graph_.tail(c)]; corner >= 0) {
          corners.push_back(corner);
          regions_of[corner].push_back(r);  // ascending
        }
      regions_.corners_of_region.push_back(corners);
    }
    for (const auto& list : regions_of) regions_.regions_of_corner.push_back(list);
  }

  // An edge of panels for each stretch of an outline between corners: two outlines share it, or one at the
  // border.
  void count_edges() {
    int edges = 0;
    for (int r = 0; r < regions_.count(); ++r)
      for (const int c : loops_[r]) {
        if (!is_corner_[graph_.tail(c)]) continue;
        const int beside = graph_.beside[c];
        edges += beside < 0 || regions_.region_of_face[beside] > r ? 1 : 0;
      }
    regions_.euler_after = static_cast<int>(regions_.corner_vertex.size()) - edges + regions_.count();
  }

  const FaceGraph& graph_;
  Regions& regions_;
  RegionShapes shapes_;
  Polygons faces_;
  double tolerance_;
  std::vector<char> is_corner_;  // #V
  std::vector<std::vector<int>> loops_;
  std::vector<int> anchors_;
};

}  // namespace

std::map<int, int> Regions::corners_by_valence() const {
  std::map<int, int> count;
  for (int c = 0; c < regions_of_corner.size(); ++c) ++count[regions_of_corner.valence(c)];
  return count;
}

Result<Regions> make_regions(const FaceGraph& graph, const Clustering& clustering,
                             const RegionOptions& options) {
  if (!(std::isfinite(options.border_tolerance) && options.border_tolerance > 0.0))
    return fail(ErrorCode::Usage, "the tolerance is not a positive number", "border tolerance",
                "Give a share of the panels' size, such as 0.1");
  if (auto ok = check_metric(options.metric); !ok) return tl::unexpected(ok.error());
  if (auto known = clustering_of(graph, clustering.region_of_face, options.metric); !known)
    return tl::unexpected(known.error());
  Regions regions;
  regions.region_of_face = clustering.region_of_face;
  int count = clustering.regions();
  auto repairs = repair_regions(graph, regions.region_of_face, count, options.metric);
  if (!repairs) return tl::unexpected(repairs.error());
  regions.repairs = std::move(*repairs);
  regions.origin = graph.origin;
  regions.euler_before = graph.euler_characteristic();
  auto repaired = clustering_of(graph, regions.region_of_face, options.metric);
  if (!repaired) return tl::unexpected(repaired.error());
  regions.proxies = repaired->proxies;
  regions.error = repaired->error;
  regions.normal_error = repaired->normal_error;
  regions.distance_error = repaired->distance_error;
  Builder(graph, options, regions).build();
  for (Proxy& proxy : regions.proxies) proxy.centre *= graph.length;
  return regions;
}

}  // namespace planewright
