#include "core/cluster/partition.h"

#include <algorithm>
#include <limits>

namespace planewright {

std::vector<Proxy> Partition::proxies() const {
  std::vector<Proxy> list;
  list.reserve(fitted.size());
  for (const FittedProxy& f : fitted) list.push_back(f.proxy);
  return list;
}

void Partition::refit(const FaceGraph& graph, int count, const ClusterMetric& metric) {
  sums.assign(static_cast<size_t>(count), {});
  fitted.resize(sums.size());
  for (int f = 0; f < graph.face_count(); ++f) sums[region_of_face[f]].add(graph, f);
  error = 0.0;
  for (size_t r = 0; r < sums.size(); ++r) {
    fitted[r] = fit_proxy(sums[r], metric);
    error += fitted[r].error;
  }
}

void Partition::merge(int a, int b, const ClusterMetric& metric) {
  const int last = regions() - 1;
  sums[a] += sums[b];
  fitted[a] = fit_proxy(sums[a], metric);
  sums[b] = sums[last];
  fitted[b] = fitted[last];
  const int kept = a == last ? b : a;
  for (int& r : region_of_face) {
    if (r == b)
      r = kept;
    else if (r == last)
      r = b;
  }
  sums.pop_back();
  fitted.pop_back();
  error = 0.0;
  for (const FittedProxy& f : fitted) error += f.error;
}

std::vector<std::array<int, 2>> neighbouring_regions(const FaceGraph& graph,
                                                     const std::vector<int>& region_of_face) {
  std::vector<std::array<int, 2>> pairs;
  for (size_t c = 0; c < graph.beside.size(); ++c) {
    if (graph.beside[c] < 0) continue;
    const int a = region_of_face[graph.face_of_corner[c]], b = region_of_face[graph.beside[c]];
    if (a < b) pairs.push_back({a, b});
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

double merge_cost(const Partition& partition, std::array<int, 2> pair, const ClusterMetric& metric) {
  RegionSums both = partition.sums[pair[0]];
  both += partition.sums[pair[1]];
  return fit_proxy(both, metric).error - partition.fitted[pair[0]].error - partition.fitted[pair[1]].error;
}

std::vector<int> best_faces(const FaceGraph& graph, const Partition& partition, const ClusterMetric& metric) {
  std::vector<int> best(partition.sums.size(), -1);
  std::vector<double> least(best.size(), std::numeric_limits<double>::infinity());
  for (int f = 0; f < graph.face_count(); ++f) {
    const int r = partition.region_of_face[f];
    const double error = graph.shapes[f].area > 0.0
                             ? error_density(graph, f, partition.fitted[r].proxy, metric)
                             : std::numeric_limits<double>::max();
    if (!(error < least[r])) continue;
    least[r] = error;
    best[r] = f;
  }
  return best;
}

std::vector<int> worst_faces(const FaceGraph& graph, const Partition& partition,
                             const ClusterMetric& metric) {
  const std::vector<int> best = best_faces(graph, partition, metric);
  std::vector<int> worst = best;
  std::vector<double> most(best.size(), -1.0);
  for (int f = 0; f < graph.face_count(); ++f) {
    const int r = partition.region_of_face[f];
    if (f == best[r]) continue;
    const double error = graph.shapes[f].area * error_density(graph, f, partition.fitted[r].proxy, metric);
    if (!(error > most[r])) continue;
    most[r] = error;
    worst[r] = f;
  }
  return worst;
}

Proxy proxy_of_face(const FaceGraph& graph, int f) {
  const FaceShape& shape = graph.shapes[f];
  return {shape.centre, shape.area > 0.0 ? shape.normal : Vector3d::UnitZ()};
}

}  // namespace planewright
