#include "ui/region_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace planewright::ui {
namespace {

using render::kRegionColours;

// Those that have the fewest neighbours left go last, so that few colours do ("smallest last").
std::vector<int> colouring_order(const std::vector<std::vector<int>>& neighbours) {
  const auto count = static_cast<int>(neighbours.size());
  std::vector<int> degree(neighbours.size());
  std::vector<std::vector<int>> of_degree(1);
  for (int r = 0; r < count; ++r) {
    degree[r] = static_cast<int>(neighbours[r].size());
    if (degree[r] >= static_cast<int>(of_degree.size())) of_degree.resize(degree[r] + 1);
    of_degree[degree[r]].push_back(r);
  }
  std::vector<char> taken(neighbours.size(), 0);
  std::vector<int> order;
  for (std::size_t d = 0; static_cast<int>(order.size()) < count;) {
    if (of_degree[d].empty()) {
      ++d;
      continue;
    }
    const int r = of_degree[d].back();
    of_degree[d].pop_back();
    if (taken[r] || degree[r] != static_cast<int>(d)) continue;
    taken[r] = 1;
    order.push_back(r);
    for (const int other : neighbours[r]) {
      if (!taken[other]) of_degree[--degree[other]].push_back(other);
    }
    d = d > 0 ? d - 1 : 0;
  }
  std::reverse(order.begin(), order.end());
  return order;
}

// Of each region the colour that most of its faces had.
std::vector<int> colours_before(const std::vector<int>& region_of_face, int count, const RegionView& before) {
  std::vector<std::array<int, kRegionColours>> votes(static_cast<std::size_t>(count));
  const std::vector<int>& earlier = before.clusters->regions.region_of_face;
  for (std::size_t f = 0; f < region_of_face.size(); ++f)
    ++votes[region_of_face[f]][before.colour_of_region[earlier[f]]];
  std::vector<int> colours;
  for (const auto& of : votes)
    colours.push_back(static_cast<int>(std::max_element(of.begin(), of.end()) - of.begin()));
  return colours;
}

}  // namespace

std::vector<int> colour_regions(const FaceGraph& graph, const std::vector<int>& region_of_face, int count,
                                const std::vector<int>& preferred) {
  std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(count));
  for (std::size_t c = 0; c < graph.beside.size(); ++c) {
    const int a = region_of_face[graph.face_of_corner[c]];
    const int b = graph.beside[c] < 0 ? a : region_of_face[graph.beside[c]];
    if (a != b) neighbours[a].push_back(b);  // the other corner of the edge adds it the other way round
  }
  for (auto& of : neighbours) {
    std::sort(of.begin(), of.end());
    of.erase(std::unique(of.begin(), of.end()), of.end());
  }
  std::vector<int> colours(neighbours.size(), -1);
  std::array<int, kRegionColours> used{};
  for (const int r : colouring_order(neighbours)) {
    std::array<int, kRegionColours> beside{};
    for (const int other : neighbours[r])
      if (colours[other] >= 0) ++beside[colours[other]];
    int best = preferred[r];
    if (best < 0 || beside[best] > 0) {
      best = 0;
      for (int c = 1; c < kRegionColours; ++c)
        if (std::pair(beside[c], used[c]) < std::pair(beside[best], used[best])) best = c;
    }
    colours[r] = best;
    ++used[best];
  }
  return colours;
}

RegionView make_region_view(SharedClusters clusters, std::shared_ptr<const MeshView> mesh,
                            const RegionView* before) {
  const FaceGraph& graph = *clusters->graph;
  const std::vector<int>& region_of_face = clusters->regions.region_of_face;
  const int count = clusters->regions.count();
  RegionView view;
  const bool same_mesh = before != nullptr && before->mesh == mesh;
  const bool same_faces =
      before != nullptr && before->clusters->regions.region_of_face.size() == region_of_face.size();
  view.colour_of_region = colour_regions(graph, region_of_face, count,
                                         same_faces ? colours_before(region_of_face, count, *before)
                                                    : std::vector<int>(static_cast<std::size_t>(count), -1));

  std::shared_ptr<render::PanelGeometry> geometry;
  if (same_mesh) {
    geometry = std::make_shared<render::PanelGeometry>(*before->arrays.faces.geometry);
    view.arrays.faces.places = before->arrays.faces.places;
  } else {
    geometry =
        std::make_shared<render::PanelGeometry>(render::make_panel_geometry(mesh->points, mesh->faces));
    view.arrays.faces.places.resize(static_cast<std::size_t>(geometry->vertex_count()));
    render::write_places(*geometry, mesh->points, view.arrays.faces.places);
  }
  // Lines run between regions alone, and are as strong as befits a region's size.
  std::vector<double> area(static_cast<std::size_t>(count), 0.0);
  for (int f = 0; f < graph.face_count(); ++f) area[region_of_face[f]] += graph.shapes[f].area;
  for (int f = 0; f < graph.face_count(); ++f) {
    const auto size = static_cast<float>(graph.length * std::sqrt(area[region_of_face[f]]));
    for (int t = geometry->first_triangle[f]; t < geometry->first_triangle[f + 1]; ++t) {
      std::uint32_t mask = 0;
      for (int k = 0; k < 3; ++k) {
        const int a = geometry->corners[3 * t + (k + 1) % 3], b = geometry->corners[3 * t + (k + 2) % 3];
        for (int c = graph.faces.offsets()[f]; c < graph.faces.offsets()[f + 1]; ++c) {
          if (graph.tail(c) != a || graph.head(c) != b) continue;
          const int g = graph.beside[c];
          if (g < 0) {
            mask |= render::edge_bit(k) | render::border_edge_bit(k);
          } else if (region_of_face[g] != region_of_face[f]) {
            mask |= render::edge_bit(k);
          }
        }
      }
      for (int k = 0; k < 3; ++k) geometry->shapes[3 * t + k] = {mask, size};
    }
  }
  view.arrays.faces.geometry = std::move(geometry);
  view.arrays.colours.resize(graph.face_count());
  for (int f = 0; f < graph.face_count(); ++f)
    view.arrays.colours[f] = view.colour_of_region[region_of_face[f]];
  view.clusters = std::move(clusters);
  view.mesh = std::move(mesh);
  return view;
}

}  // namespace planewright::ui
