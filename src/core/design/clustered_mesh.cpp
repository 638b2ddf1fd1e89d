#include "core/design/clustered_mesh.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/cluster/region_edits.h"

namespace planewright {
namespace {

using SharedGraph = std::shared_ptr<const FaceGraph>;

Result<SharedGraph> graph_of(const PolygonMesh& mesh) {
  return FaceGraph::create(mesh).map(
      [](FaceGraph&& graph) -> SharedGraph { return std::make_shared<const FaceGraph>(std::move(graph)); });
}

Result<SharedClusters> made_ready(std::shared_ptr<const PolygonMesh> mesh, SharedGraph graph,
                                  const ClusterOptions& options, Clustering clustering, bool given = false) {
  RegionOptions of_regions;
  of_regions.metric = options.metric;
  auto regions = make_regions(*graph, clustering, of_regions);
  if (!regions) return tl::unexpected(regions.error());
  return std::make_shared<const ClusteredMesh>(ClusteredMesh{
      std::move(mesh), std::move(graph), options, given, std::move(clustering), std::move(*regions)});
}

// What a designer sees, as a clustering to change by hand.
Result<Clustering> seen(const ClusteredMesh& of) {
  return clustering_of(*of.graph, of.regions.region_of_face, of.options.metric);
}

Result<SharedClusters> changed_by_hand(const ClusteredMesh& of, Clustering clustering) {
  ClusterOptions options = of.options;
  options.panels = clustering.regions();
  options.target_normal.reset();
  options.target_distance.reset();
  return made_ready(of.mesh, of.graph, options, std::move(clustering));
}

// Gives each face without a region (-1) that of the nearest face with one; what lies apart from all of them
// becomes regions of its own.
void fill_in(const FaceGraph& graph, std::vector<int>& regions, int& count) {
  std::vector<int> front;
  const auto spread = [&] {
    for (std::size_t k = 0; k < front.size(); ++k) {
      const int f = front[k];
      for (int c = graph.faces.offsets()[f]; c < graph.faces.offsets()[f + 1]; ++c) {
        const int g = graph.beside[c];
        if (g < 0 || regions[g] >= 0) continue;
        regions[g] = regions[f];
        front.push_back(g);
      }
    }
    front.clear();
  };
  for (int f = 0; f < graph.face_count(); ++f)
    if (regions[f] >= 0) front.push_back(f);
  spread();
  for (int f = 0; f < graph.face_count(); ++f) {
    if (regions[f] >= 0) continue;
    regions[f] = count++;
    front.push_back(f);
    spread();
  }
}

// Of each region the largest connected part keeps it; the rest has none.
void keep_connected(const FaceGraph& graph, std::vector<int>& regions, int count) {
  std::vector<std::vector<int>> largest(static_cast<std::size_t>(count));
  std::vector<char> reached(regions.size(), 0);
  for (int start = 0; start < graph.face_count(); ++start) {
    if (reached[start] || regions[start] < 0) continue;
    std::vector<int> part{start};
    reached[start] = 1;
    for (std::size_t k = 0; k < part.size(); ++k) {
      const int f = part[k];
      for (int c = graph.faces.offsets()[f]; c < graph.faces.offsets()[f + 1]; ++c) {
        const int g = graph.beside[c];
        if (g < 0 || reached[g] || regions[g] != regions[f]) continue;
        reached[g] = 1;
        part.push_back(g);
      }
    }
    std::vector<int>& kept = largest[regions[start]];
    if (part.size() > kept.size()) std::swap(part, kept);
    for (const int f : part) regions[f] = -1;
  }
}

// Numbers without gaps, in their order.
void renumber(std::vector<int>& regions, int& count) {
  std::vector<int> number(static_cast<std::size_t>(count), -1);
  for (const int r : regions) number[r] = 0;
  count = 0;
  for (int& n : number)
    if (n == 0) n = count++;
  for (int& r : regions) r = number[r];
}

}  // namespace

ClusterRecord record_of(const ClusteredMesh& clusters) {
  return {clusters.options, clusters.given, clusters.clustering.target_met,
          clusters.clustering.region_of_face};
}

Result<SharedClusters> clusters_of(std::shared_ptr<const PolygonMesh> mesh, const ClusterRecord& record) {
  if (auto checked = check_metric(record.options.metric); !checked) return tl::unexpected(checked.error());
  auto graph = graph_of(*mesh);
  if (!graph) return tl::unexpected(graph.error());
  auto clustering = clustering_of(**graph, record.region_of_face, record.options.metric);
  if (!clustering) return tl::unexpected(clustering.error());
  clustering->target_met = record.target_met;
  return made_ready(std::move(mesh), std::move(*graph), record.options, std::move(*clustering), record.given);
}

Result<SharedClusters> cluster_mesh(std::shared_ptr<const PolygonMesh> mesh, const ClusterOptions& options,
                                    ClusterObserver* observer, std::stop_token stop) {
  auto graph = graph_of(*mesh);
  if (!graph) return tl::unexpected(graph.error());
  auto clustering = cluster(**graph, options, observer, std::move(stop));
  if (!clustering) return tl::unexpected(clustering.error());
  return made_ready(std::move(mesh), std::move(*graph), options, std::move(*clustering));
}

Result<SharedClusters> mesh_of_regions(std::shared_ptr<const PolygonMesh> mesh,
                                       std::vector<int> region_of_face, const ClusterMetric& metric) {
  auto graph = graph_of(*mesh);
  if (!graph) return tl::unexpected(graph.error());
  auto clustering = clustering_of(**graph, std::move(region_of_face), metric);
  if (!clustering) return tl::unexpected(clustering.error());
  ClusterOptions options;
  options.panels = clustering->regions();
  options.metric = metric;
  return made_ready(std::move(mesh), std::move(*graph), options, std::move(*clustering), true);
}

Result<SharedClusters> cluster_anew(const ClusteredMesh& from, const ClusterOptions& options,
                                    std::stop_token stop) {
  auto clustering = cluster(*from.graph, options, nullptr, std::move(stop));
  if (!clustering) return tl::unexpected(clustering.error());
  return made_ready(from.mesh, from.graph, options, std::move(*clustering));
}

Result<SharedClusters> recluster(const ClusteredMesh& from, ClusterOptions options, std::stop_token stop) {
  options.target_normal.reset();
  options.target_distance.reset();
  auto clustering = cluster(*from.graph, options, nullptr, std::move(stop), &from.clustering);
  if (!clustering) return tl::unexpected(clustering.error());
  return made_ready(from.mesh, from.graph, options, std::move(*clustering));
}

Result<SharedClusters> with_regions_merged(const ClusteredMesh& of, int a, int b) {
  const auto before = seen(of);
  if (!before) return tl::unexpected(before.error());
  auto merged = merge_regions(*of.graph, *before, a, b, of.options.metric);
  if (!merged) return tl::unexpected(merged.error());
  return changed_by_hand(of, std::move(*merged));
}

Result<SharedClusters> with_region_split(const ClusteredMesh& of, int region) {
  const auto before = seen(of);
  if (!before) return tl::unexpected(before.error());
  auto split = split_region(*of.graph, *before, region, of.options.metric);
  if (!split) return tl::unexpected(split.error());
  return changed_by_hand(of, std::move(*split));
}

Result<Painted> with_faces_painted(const ClusteredMesh& of, std::span<const int> faces, int from) {
  auto clustering = seen(of);
  if (!clustering) return tl::unexpected(clustering.error());
  if (from < 0 || from >= of.graph->face_count())
    return fail(ErrorCode::Refused, "there is no such face", "face " + std::to_string(from),
                "Choose one that there is");
  auto painted =
      paint_faces(*of.graph, *clustering, faces, clustering->region_of_face[from], of.options.metric);
  if (!painted) return tl::unexpected(painted.error());
  Painted result{nullptr, std::move(painted->refused), std::move(painted->why)};
  if (!painted->changed) {
    result.clusters = std::make_shared<const ClusteredMesh>(of);
    return result;
  }
  auto clusters = changed_by_hand(of, std::move(painted->clustering));
  if (!clusters) return tl::unexpected(clusters.error());
  result.clusters = std::move(*clusters);
  return result;
}

Result<SharedClusters> carried_over(const ClusteredMesh& before, std::shared_ptr<const PolygonMesh> mesh,
                                    const IndexMap& faces) {
  auto graph = graph_of(*mesh);
  if (!graph) return tl::unexpected(graph.error());
  int count = before.regions.count();
  std::vector<int> regions(static_cast<std::size_t>((*graph)->face_count()), -1);
  for (std::size_t f = 0; f < regions.size() && f < faces.to_old.size(); ++f)
    if (const int old = faces.to_old[f]; old >= 0) regions[f] = before.regions.region_of_face[old];
  fill_in(**graph, regions, count);
  keep_connected(**graph, regions, count);
  fill_in(**graph, regions, count);
  renumber(regions, count);
  auto clustering = clustering_of(**graph, std::move(regions), before.options.metric);
  if (!clustering) return tl::unexpected(clustering.error());
  ClusterOptions options = before.options;
  options.panels = std::min(options.panels, (*graph)->face_count());
  return made_ready(std::move(mesh), std::move(*graph), options, std::move(*clustering));
}

IndexMap same_regions(const std::vector<int>& before, int count_before, const std::vector<int>& after,
                      int count_after) {
  std::map<std::pair<int, int>, int> shared;
  for (std::size_t f = 0; f < std::min(before.size(), after.size()); ++f) ++shared[{before[f], after[f]}];
  struct Best {
    int other = -1, faces = 0;
  };
  std::vector<Best> of_before(static_cast<std::size_t>(count_before)),
      of_after(static_cast<std::size_t>(count_after));
  for (const auto& [pair, faces] : shared) {
    if (Best& best = of_before[pair.first]; faces > best.faces) best = {pair.second, faces};
    if (Best& best = of_after[pair.second]; faces > best.faces) best = {pair.first, faces};
  }
  std::vector<int> to_old(of_after.size(), -1);
  for (std::size_t r = 0; r < of_after.size(); ++r) {
    const int old = of_after[r].other;
    if (old >= 0 && of_before[old].other == static_cast<int>(r)) to_old[r] = old;
  }
  return index_map(std::move(to_old), count_before);
}

}  // namespace planewright
