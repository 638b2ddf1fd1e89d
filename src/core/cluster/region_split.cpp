#include "core/cluster/region_split.h"

#include <array>
#include <map>
#include <queue>
#include <tuple>

namespace planewright {
namespace {

// Calls visit(face, source) in the order of distance.
template <class Visit>
void flood(const FaceGraph& graph, const std::vector<int>& region_of_face, int region,
           const std::vector<std::vector<int>>& sources, Visit visit) {
  std::map<int, int> part;
  std::vector<int> queue;
  for (size_t s = 0; s < sources.size(); ++s)
    for (const int f : sources[s])
      if (part.try_emplace(f, static_cast<int>(s)).second) queue.push_back(f);
  for (size_t k = 0; k < queue.size(); ++k) {
    const int f = queue[k], s = part[f];
    visit(f, s);
    for (int c = graph.faces.offsets()[f]; c < graph.faces.offsets()[f + 1]; ++c) {
      const int g = graph.beside[c];
      if (g >= 0 && region_of_face[g] == region && part.try_emplace(g, s).second) queue.push_back(g);
    }
  }
}

constexpr int kIterations = 20;

struct Halves {
  std::vector<int> part;  // of each of the region's faces
  std::array<RegionSums, 2> sums;
  std::array<FittedProxy, 2> fitted;
  double error = 0.0;
};

}  // namespace

void split_by_distance(const FaceGraph& graph, std::vector<int>& region_of_face, int region, int first_new,
                       const std::vector<std::vector<int>>& sources) {
  std::vector<std::array<int, 2>> found;
  flood(graph, region_of_face, region, sources, [&](int f, int s) { found.push_back({f, s}); });
  for (const auto& [f, s] : found)
    if (s > 0) region_of_face[f] = first_new + s - 1;
}

std::array<int, 2> far_faces(const FaceGraph& graph, const std::vector<int>& region_of_face, int start) {
  const int region = region_of_face[start];
  int from = start, to = start;
  for (int k = 0; k < 2; ++k) {
    from = to;
    flood(graph, region_of_face, region, {{from}}, [&](int f, int) { to = f; });
  }
  return {from, to};
}

bool split_by_error(const FaceGraph& graph, std::vector<int>& region_of_face, int region, int new_region,
                    const ClusterMetric& metric) {
  std::vector<int> faces;
  for (int f = 0; f < graph.face_count(); ++f)
    if (region_of_face[f] == region) faces.push_back(f);
  if (faces.size() < 2) return false;
  std::map<int, int> index;
  for (size_t k = 0; k < faces.size(); ++k) index[faces[k]] = static_cast<int>(k);

  // Grown as whole meshes are, but two regions need no clever queue.
  const auto grow = [&](const std::array<int, 2>& seeds, const std::array<Proxy, 2>& proxies) {
    Halves halves;
    halves.part.assign(faces.size(), -1);
    std::priority_queue<std::tuple<double, int, int>, std::vector<std::tuple<double, int, int>>,
                        std::greater<>>
        offers;
    const auto take = [&](int f, int side) {
      halves.part[index[f]] = side;
      halves.sums[side].add(graph, f);
      for (int c = graph.faces.offsets()[f]; c < graph.faces.offsets()[f + 1]; ++c) {
        const auto found = index.find(graph.beside[c]);
        if (found != index.end() && halves.part[found->second] < 0)
          offers.push({error_density(graph, found->first, proxies[side], metric), found->first, side});
      }
    };
    halves.part[index[seeds[1]]] = 1;  // before the first one grows
    take(seeds[0], 0);
    take(seeds[1], 1);
    while (!offers.empty()) {
      const auto [cost, f, side] = offers.top();
      offers.pop();
      if (halves.part[index[f]] < 0) take(f, side);
    }
    for (int side = 0; side < 2; ++side) {
      halves.fitted[side] = fit_proxy(halves.sums[side], metric);
      halves.error += halves.fitted[side].error;
    }
    return halves;
  };
  const auto face_proxy = [&](int f) {
    const FaceShape& shape = graph.shapes[f];
    return Proxy{shape.centre, shape.area > 0.0 ? shape.normal : Vector3d(Vector3d::UnitZ())};
  };

  const std::array<int, 2> far = far_faces(graph, region_of_face, faces.front());
  Halves best = grow(far, {face_proxy(far[0]), face_proxy(far[1])});
  for (int k = 0; k < kIterations; ++k) {
    std::array<int, 2> seeds{-1, -1};
    std::array<double, 2> least{};
    for (size_t i = 0; i < faces.size(); ++i) {
      const int side = best.part[i];
      const double error = error_density(graph, faces[i], best.fitted[side].proxy, metric);
      if (seeds[side] >= 0 && error >= least[side]) continue;
      least[side] = error;
      seeds[side] = faces[i];
    }
    Halves next = grow(seeds, {best.fitted[0].proxy, best.fitted[1].proxy});
    if (!(next.error < best.error)) break;
    best = std::move(next);
  }
  for (size_t k = 0; k < faces.size(); ++k)
    if (best.part[k] == 1) region_of_face[faces[k]] = new_region;
  return true;
}

}  // namespace planewright
