#include "core/edit/remap.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "core/complex/mapped_origin.h"
#include "core/design/design.h"
#include "core/edit/design_edits.h"
#include "core/edit/select.h"

namespace planewright {
namespace {

std::vector<int> remapped(const std::vector<int>& list, const IndexMap& map) {
  std::vector<int> out;
  for (const int i : list) {
    if (const int now = mapped(map, i); now >= 0) out.push_back(now);
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

void remap_selections(RemappedDesign& result, const ElementMap& map) {
  std::vector<std::string> emptied;
  for (Selection& selection : result.design.selections) {
    const int before = element_count(selection);
    selection = remapped(selection, map);
    const int lost = before - element_count(selection);
    if (lost == 0) continue;
    if (selection.empty()) {
      emptied.push_back(selection.name);
    } else {
      result.dropped.push_back(counted(static_cast<std::size_t>(lost), "element", "elements") +
                               " of selection " + selection.name);
    }
  }
  for (const std::string& name : emptied) {
    const int demands = demands_on(result.design, name);
    std::string what = "selection " + name;
    if (demands > 0)
      what += " and " + counted(static_cast<std::size_t>(demands), "demand", "demands") + " on it";
    result.dropped.push_back(std::move(what));
    result.design = with_selection_removed(std::move(result.design), name);
  }
}

// Elements of two complexes of a layer, one of the mesh before and one of the mesh after.
class WaivedElements {
 public:
  WaivedElements(const TangentComplex& before, const TangentComplex& after, const ElementMap& map,
                 const IndexMap& planes)
      : before_(before), map_(map), planes_(planes) {
    for (int j = 0; j < after.point_count(); ++j) points_[key(after.point_origin[as_size(j)])] = j;
    for (int i = 0; i < after.plane_count(); ++i) panels_[after.plane_origin[as_size(i)]] = i;
    for (std::size_t k = 0; k < after.panel_edges.size(); ++k) {
      edges_[edge_key(after, static_cast<int>(k), nullptr)] = static_cast<int>(k);
    }
  }

  // -1: gone.
  int now(const ElementRef& element) const {
    if (element.index < 0) return -1;
    switch (element.kind) {
      case ElementKind::Point:
        return element.index < before_.point_count()
                   ? found(points_, key(before_.point_origin[as_size(element.index)], &map_))
                   : -1;
      case ElementKind::Panel:
        return element.index < before_.plane_count()
                   ? found(panels_, mapped(planes_, before_.plane_origin[as_size(element.index)]))
                   : -1;
      case ElementKind::PanelEdge:
        break;
    }
    return element.index < static_cast<int>(before_.panel_edges.size())
               ? found(edges_, edge_key(before_, element.index, &map_))
               : -1;
  }

 private:
  using Key = std::pair<PointKind, int>;
  using EdgeKey = std::array<Key, 2>;

  static std::size_t as_size(int i) { return static_cast<std::size_t>(i); }
  static Key key(const PointOrigin& origin, const ElementMap* map = nullptr) {
    return {origin.kind, map ? mapped(point_origins(*map, origin.kind), origin.element) : origin.element};
  }
  // A panel edge is what crosses its mesh edge (dual), else what joins its two points.
  static EdgeKey edge_key(const TangentComplex& complex, int k, const ElementMap* map) {
    EdgeKey ends;
    if (const auto [a, b] = complex.crossed_edge[as_size(k)]; a >= 0 && b >= 0) {
      ends = {key({PointKind::Vertex, a}, map), key({PointKind::Vertex, b}, map)};
    } else {
      const PanelEdge& edge = complex.panel_edges[as_size(k)];
      ends = {key(complex.point_origin[as_size(edge.a)], map),
              key(complex.point_origin[as_size(edge.b)], map)};
    }
    std::sort(ends.begin(), ends.end());
    return ends;
  }
  template <class Map>
  static int found(const Map& map, const typename Map::key_type& key) {
    const auto at = map.find(key);
    return at == map.end() ? -1 : at->second;
  }

  const TangentComplex& before_;
  const ElementMap& map_;
  const IndexMap& planes_;
  std::map<Key, int> points_;
  std::map<int, int> panels_;
  std::map<EdgeKey, int> edges_;
};

// What a change leads through: elements of the mesh, and the regions of its clusters.
struct Change {
  const ElementMap& map;
  const PolygonMesh &before, &after;
  const ClustersChange& clusters;
  IndexMap regions = {};

  const IndexMap& planes(ComplexKind kind) const {
    return kind == ComplexKind::Cluster ? regions : plane_origins(map, kind);
  }
};

// Regions before in the faces after, so that both can be compared: a new face has none of them.
IndexMap regions_known_again(const ElementMap& map, const ClustersChange& clusters) {
  if (!clusters.before || !clusters.after) return {};
  const std::vector<int>& now = clusters.after->regions.region_of_face;
  std::vector<int> then, now_there;
  for (std::size_t f = 0; f < now.size() && f < map.faces.to_old.size(); ++f) {
    if (map.faces.to_old[f] < 0) continue;
    then.push_back(clusters.before->regions.region_of_face[static_cast<std::size_t>(map.faces.to_old[f])]);
    now_there.push_back(now[f]);
  }
  return same_regions(then, clusters.before->regions.count(), now_there, clusters.after->regions.count());
}

Result<std::shared_ptr<const TangentComplex>> complex_of(const PolygonMesh& mesh,
                                                         const LayerSettings& settings,
                                                         const SharedClusters& clusters) {
  return build_complex(mesh, settings, clusters ? &clusters->regions : nullptr);
}

void remap_waivers(std::vector<Waiver>& waived, const LayerSettings& settings, const Change& change) {
  if (waived.empty()) return;
  const auto before = complex_of(change.before, settings, change.clusters.before),
             after = complex_of(change.after, settings, change.clusters.after);
  if (!before || !after) {
    waived.clear();
    return;
  }
  const WaivedElements elements(**before, **after, change.map, change.planes(settings.mode));
  for (Waiver& waiver : waived) waiver.element.index = elements.now(waiver.element);
  std::erase_if(waived, [](const Waiver& waiver) { return waiver.element.index < 0; });
  std::sort(waived.begin(), waived.end());
}

// Of the elements that are left, border policy Interior gives nothing to those on the border alone.
bool has_panel(const PolygonMesh& mesh, const LayerSettings& settings, int origin) {
  if (origin < 0) return false;
  return settings.mode != ComplexKind::Dual || settings.border != BorderPolicy::Interior ||
         !mesh.is_border_vertex(origin);
}
bool has_point(const PolygonMesh& mesh, const LayerSettings& settings, const PointOrigin& origin,
               const SharedClusters& clusters) {
  if (origin.element < 0) return false;
  if (settings.mode == ComplexKind::Cluster) {
    if (!clusters) return true;  // they are still to come
    const std::vector<int>& corners = clusters->regions.corner_vertex;
    return std::binary_search(corners.begin(), corners.end(), origin.element);
  }
  if (origin.kind != PointKind::Face) return true;
  const std::vector<int> corners = mesh.corners(origin.element);
  return std::any_of(corners.begin(), corners.end(), [&](int v) { return has_panel(mesh, settings, v); });
}

void remap_layer(Layer& layer, const Change& change, std::vector<std::string>& dropped) {
  Demands& demands = layer.settings.demands;
  const auto report = [&](std::size_t lost, const std::string& one, const std::string& many) {
    if (lost > 0) dropped.push_back(counted(lost, one, many) + " of layer " + layer.name);
  };
  for (Pin& pin : demands.pins) {
    pin.point.element = mapped(point_origins(change.map, pin.point.kind), pin.point.element);
  }
  report(std::erase_if(demands.pins,
                       [&](const Pin& pin) {
                         return !has_point(change.after, layer.settings, pin.point, change.clusters.after);
                       }),
         "pinned point", "pinned points");
  const IndexMap& panels = change.planes(layer.settings.mode);
  for (PlanePin& pin : demands.plane_pins) pin.panel_origin = mapped(panels, pin.panel_origin);
  report(std::erase_if(
             demands.plane_pins,
             [&](const PlanePin& pin) { return !has_panel(change.after, layer.settings, pin.panel_origin); }),
         "pinned panel", "pinned panels");
  const std::size_t waived = demands.waived.size();
  remap_waivers(demands.waived, layer.settings, change);
  report(waived - demands.waived.size(), "place given up", "places given up");
}

}  // namespace

Selection remapped(const Selection& selection, const ElementMap& map) {
  return {selection.name, remapped(selection.vertices, map.vertices), remapped(selection.edges, map.edges),
          remapped(selection.faces, map.faces)};
}

RemappedDesign remapped(Design design, const ElementMap& map, const PolygonMesh& before,
                        const PolygonMesh& after, const ClustersChange& clusters) {
  RemappedDesign result{std::move(design), {}};
  remap_selections(result, map);
  const Change change{map, before, after, clusters, regions_known_again(map, clusters)};
  for (Layer& layer : result.design.layers) remap_layer(layer, change, result.dropped);
  return result;
}

RemappedDesign with_clusters_changed(Design design, const PolygonMesh& mesh, const ClustersChange& clusters) {
  RemappedDesign result{std::move(design), {}};
  const auto names_panels = [](const Layer& layer) {
    const Demands& demands = layer.settings.demands;
    return layer.settings.mode == ComplexKind::Cluster &&
           !(demands.pins.empty() && demands.plane_pins.empty() && demands.waived.empty());
  };
  if (std::none_of(result.design.layers.begin(), result.design.layers.end(), names_panels)) return result;
  const ElementMap map = identity_map(mesh);
  const Change change{map, mesh, mesh, clusters, regions_known_again(map, clusters)};
  for (Layer& layer : result.design.layers)
    if (names_panels(layer)) remap_layer(layer, change, result.dropped);
  return result;
}

}  // namespace planewright
