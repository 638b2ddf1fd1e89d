#include "core/cluster/region_edits.h"

#include <algorithm>
#include <string>

#include "core/cluster/partition.h"
#include "core/cluster/region_split.h"

namespace planewright {
namespace {

std::string region_name(int r) {
  return "region " + std::to_string(r);
}
tl::unexpected<Error> refuse(std::string what, std::string where, std::string remedy) {
  return fail(ErrorCode::Refused, std::move(what), std::move(where), std::move(remedy));
}

Result<void> check_region(const Clustering& clustering, int region) {
  if (region < 0 || region >= clustering.regions())
    return refuse("there is no such region among " + std::to_string(clustering.regions()),
                  region_name(region), "Choose one that there is");
  return {};
}

bool beside(const FaceGraph& graph, const std::vector<int>& region_of_face, int face, int region) {
  for (int c = graph.faces.offsets()[face]; c < graph.faces.offsets()[face + 1]; ++c)
    if (graph.beside[c] >= 0 && region_of_face[graph.beside[c]] == region) return true;
  return false;
}

// Whether the region of the face stays in one piece without it. It has other faces.
bool connected_without(const FaceGraph& graph, const std::vector<int>& region_of_face, int face) {
  const int region = region_of_face[face];
  const auto own_beside = [&](int f) {
    std::vector<int> own;
    for (int c = graph.faces.offsets()[f]; c < graph.faces.offsets()[f + 1]; ++c) {
      const int g = graph.beside[c];
      if (g >= 0 && g != face && region_of_face[g] == region) own.push_back(g);
    }
    return own;
  };
  std::vector<int> ends = own_beside(face);
  if (ends.size() < 2) return true;
  std::vector<char> reached(region_of_face.size(), 0);
  std::vector<int> queue{ends.front()};
  reached[ends.front()] = 1;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    for (const int g : own_beside(queue[next])) {
      if (reached[g]) continue;
      reached[g] = 1;
      queue.push_back(g);
    }
  }
  return std::all_of(ends.begin(), ends.end(), [&](int f) { return reached[f] != 0; });
}

Result<void> check_paint(const FaceGraph& graph, const std::vector<int>& region_of_face, int face,
                         int region) {
  const std::string where = "face " + std::to_string(face);
  if (face < 0 || face >= graph.face_count())
    return refuse("there is no such face", where, "Choose one that there is");
  const int from = region_of_face[face];
  if (from == region)
    return refuse("the face is in " + region_name(region) + " already", where, "Choose another");
  if (!beside(graph, region_of_face, face, region))
    return refuse(region_name(region) + " is not beside the face", where,
                  "Paint from the region's edge outwards");
  // Regions are connected: one of several faces has another beside each.
  if (!beside(graph, region_of_face, face, from))
    return refuse(region_name(from) + " would be left without a face", where,
                  "Merge the two regions instead");
  if (!connected_without(graph, region_of_face, face))
    return refuse(region_name(from) + " would fall apart without the face", where,
                  "Paint its smaller part first, or split the region");
  return {};
}

}  // namespace

Result<Clustering> merge_regions(const FaceGraph& graph, const Clustering& clustering, int a, int b,
                                 const ClusterMetric& metric) {
  for (const int r : {a, b})
    if (auto ok = check_region(clustering, r); !ok) return tl::unexpected(ok.error());
  if (a == b) return refuse("a region cannot be merged with itself", region_name(a), "Choose two neighbours");
  if (a > b) std::swap(a, b);
  const auto pairs = neighbouring_regions(graph, clustering.region_of_face);
  if (!std::binary_search(pairs.begin(), pairs.end(), std::array{a, b}))
    return refuse("regions " + std::to_string(a) + " and " + std::to_string(b) + " share no edge",
                  region_name(a), "Choose two neighbours");
  std::vector<int> regions = clustering.region_of_face;
  const int last = clustering.regions() - 1;
  for (int& r : regions) r = r == b ? a : r == last ? b : r;
  return clustering_of(graph, std::move(regions), metric);
}

Result<Clustering> split_region(const FaceGraph& graph, const Clustering& clustering, int region,
                                const ClusterMetric& metric) {
  if (auto ok = check_region(clustering, region); !ok) return tl::unexpected(ok.error());
  std::vector<int> regions = clustering.region_of_face;
  if (!split_by_error(graph, regions, region, clustering.regions(),
                      for_regions(metric, clustering.regions() + 1)))
    return refuse("a region of a single face cannot be split", region_name(region),
                  "Choose a larger one, or subdivide the mesh");
  return clustering_of(graph, std::move(regions), metric);
}

Result<Clustering> paint_face(const FaceGraph& graph, const Clustering& clustering, int face, int region,
                              const ClusterMetric& metric) {
  if (auto ok = check_region(clustering, region); !ok) return tl::unexpected(ok.error());
  if (auto ok = check_paint(graph, clustering.region_of_face, face, region); !ok)
    return tl::unexpected(ok.error());
  std::vector<int> regions = clustering.region_of_face;
  regions[face] = region;
  return clustering_of(graph, std::move(regions), metric);
}

Result<PaintedFaces> paint_faces(const FaceGraph& graph, const Clustering& clustering,
                                 std::span<const int> faces, int region, const ClusterMetric& metric) {
  if (auto ok = check_region(clustering, region); !ok) return tl::unexpected(ok.error());
  std::vector<int> regions = clustering.region_of_face;
  PaintedFaces painted;
  std::vector<int> left(faces.begin(), faces.end());
  for (bool goes_on = true; goes_on;) {  // what is not beside the region yet may be so later
    goes_on = false;
    painted.refused.clear();
    painted.why.reset();
    for (const int face : left) {
      if (face >= 0 && face < graph.face_count() && regions[face] == region) continue;
      if (auto ok = check_paint(graph, regions, face, region); !ok) {
        painted.refused.push_back(face);
        painted.why = ok.error();
        continue;
      }
      regions[face] = region;
      goes_on = true;
    }
    left = painted.refused;
  }
  painted.changed = regions != clustering.region_of_face;
  if (!painted.changed) {
    painted.clustering = clustering;
    return painted;
  }
  auto made = clustering_of(graph, std::move(regions), metric);
  if (!made) return tl::unexpected(made.error());
  painted.clustering = std::move(*made);
  return painted;
}

}  // namespace planewright
