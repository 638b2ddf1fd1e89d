#include "core/edit/element_names.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "core/problem/element.h"

namespace planewright {
namespace {

std::vector<int> first_numbers(int count) {
  std::vector<int> ids(static_cast<std::size_t>(count));
  std::iota(ids.begin(), ids.end(), 0);
  return ids;
}

std::vector<int> carried(const std::vector<int>& before, const IndexMap& map, int& next) {
  std::vector<int> ids(map.to_old.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const int old = map.to_old[i];
    ids[i] = old >= 0 ? before[static_cast<std::size_t>(old)] : next++;
  }
  return ids;
}

IndexMap same_numbers(const std::vector<int>& from, const std::vector<int>& to) {
  std::unordered_map<int, int> index_of;
  index_of.reserve(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) index_of.emplace(from[i], static_cast<int>(i));
  std::vector<int> to_old(to.size(), -1);
  for (std::size_t i = 0; i < to.size(); ++i) {
    if (const auto found = index_of.find(to[i]); found != index_of.end()) to_old[i] = found->second;
  }
  return index_map(std::move(to_old), static_cast<int>(from.size()));
}

// Ranks among those that have a panel, and behind them the others.
std::vector<int> ranks(const std::vector<char>& has_panel) {
  std::vector<int> rank(has_panel.size());
  int next = 0;
  for (const char with : {char{1}, char{0}}) {
    for (std::size_t v = 0; v < rank.size(); ++v) {
      if (has_panel[v] == with) rank[v] = next++;
    }
  }
  return rank;
}

}  // namespace

ElementNumbering::ElementNumbering(const PolygonMesh& opened)
    : opened_{opened.vertex_count(), opened.edge_count(), opened.face_count()}, next_(opened_) {}

ElementIds ElementNumbering::opened() const {
  return {first_numbers(opened_.vertices), first_numbers(opened_.edges), first_numbers(opened_.faces)};
}

ElementIds ElementNumbering::edited(const ElementIds& before, const ElementMap& map) {
  return {carried(before.vertices, map.vertices, next_.vertices),
          carried(before.edges, map.edges, next_.edges), carried(before.faces, map.faces, next_.faces)};
}

ElementMap map_between(const ElementIds& from, const ElementIds& to) {
  return {same_numbers(from.vertices, to.vertices), same_numbers(from.edges, to.edges),
          same_numbers(from.faces, to.faces)};
}

PanelNumbers::PanelNumbers(const PolygonMesh& opened) {
  std::vector<char> used(static_cast<std::size_t>(opened.vertex_count())), inner(used.size());
  for (int v = 0; v < opened.vertex_count(); ++v) {
    const auto i = static_cast<std::size_t>(v);
    used[i] = opened.is_isolated(v) ? 0 : 1;
    inner[i] = used[i] && !opened.is_border_vertex(v) ? 1 : 0;
  }
  closed_ = ranks(used);
  interior_ = ranks(inner);
}

int PanelNumbers::number(ComplexKind kind, BorderPolicy border, const ElementIds& ids, int origin) const {
  if (kind == ComplexKind::Cluster) return origin;  // regions have no other names
  const std::vector<int>& of_kind = kind == ComplexKind::Dual ? ids.vertices : ids.faces;
  if (origin < 0 || origin >= static_cast<int>(of_kind.size())) return -1;
  const int id = of_kind[static_cast<std::size_t>(origin)];
  if (kind == ComplexKind::Planarize) return id;
  const std::vector<int>& opened = border == BorderPolicy::Interior ? interior_ : closed_;
  return id < static_cast<int>(opened.size()) ? opened[static_cast<std::size_t>(id)] : id;
}

ElementNames names_of_opened(const PolygonMesh& mesh) {
  ElementNumbering numbering(mesh);
  ElementIds ids = numbering.opened();
  return {std::move(ids), numbering, PanelNumbers(mesh)};
}

std::string panel_name(int number) {
  return text(ElementRef{ElementKind::Panel, number});
}

}  // namespace planewright
