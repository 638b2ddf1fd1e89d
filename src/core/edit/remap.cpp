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
  WaivedElements(const TangentComplex& before, const TangentComplex& after, const ElementMap& map)
      : before_(before), map_(map) {
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
                   ? found(panels_, mapped(plane_origins(map_, before_.kind),
                                           before_.plane_origin[as_size(element.index)]))
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
  std::map<Key, int> points_;
  std::map<int, int> panels_;
  std::map<EdgeKey, int> edges_;
};

void remap_waivers(std::vector<Waiver>& waived, const LayerSettings& settings, const ElementMap& map,
                   const PolygonMesh& before, const PolygonMesh& after) {
  if (waived.empty()) return;
  const auto complex_before = build_complex(before, settings), complex_after = build_complex(after, settings);
  if (!complex_before || !complex_after) {
    waived.clear();
    return;
  }
  const WaivedElements elements(**complex_before, **complex_after, map);
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
bool has_point(const PolygonMesh& mesh, const LayerSettings& settings, const PointOrigin& origin) {
  if (origin.element < 0) return false;
  if (origin.kind != PointKind::Face) return true;
  const std::vector<int> corners = mesh.corners(origin.element);
  return std::any_of(corners.begin(), corners.end(), [&](int v) { return has_panel(mesh, settings, v); });
}

}  // namespace

Selection remapped(const Selection& selection, const ElementMap& map) {
  return {selection.name, remapped(selection.vertices, map.vertices), remapped(selection.edges, map.edges),
          remapped(selection.faces, map.faces)};
}

RemappedDesign remapped(Design design, const ElementMap& map, const PolygonMesh& before,
                        const PolygonMesh& after) {
  RemappedDesign result{std::move(design), {}};
  remap_selections(result, map);
  for (Layer& layer : result.design.layers) {
    Demands& demands = layer.settings.demands;
    const auto report = [&](std::size_t lost, const std::string& one, const std::string& many) {
      if (lost > 0) result.dropped.push_back(counted(lost, one, many) + " of layer " + layer.name);
    };
    for (Pin& pin : demands.pins) {
      pin.point.element = mapped(point_origins(map, pin.point.kind), pin.point.element);
    }
    report(std::erase_if(demands.pins,
                         [&](const Pin& pin) { return !has_point(after, layer.settings, pin.point); }),
           "pinned point", "pinned points");
    const IndexMap& panels = plane_origins(map, layer.settings.mode);
    for (PlanePin& pin : demands.plane_pins) pin.panel_origin = mapped(panels, pin.panel_origin);
    report(std::erase_if(
               demands.plane_pins,
               [&](const PlanePin& pin) { return !has_panel(after, layer.settings, pin.panel_origin); }),
           "pinned panel", "pinned panels");
    const std::size_t waived = demands.waived.size();
    remap_waivers(demands.waived, layer.settings, map, before, after);
    report(waived - demands.waived.size(), "place given up", "places given up");
  }
  return result;
}

}  // namespace planewright
