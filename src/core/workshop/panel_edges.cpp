#include "core/workshop/panel_edges.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace planewright {
namespace {

struct Side {
  int panel, side, from, to;
  std::array<int, 2> ends() const { return {std::min(from, to), std::max(from, to)}; }
};

std::vector<Side> all_sides(const Polygons& panels) {
  std::vector<Side> sides;
  sides.reserve(panels.indices().size());
  for (int p = 0; p < panels.size(); ++p) {
    const auto corners = panels[p];
    for (size_t k = 0; k < corners.size(); ++k)
      sides.push_back({p, static_cast<int>(k), corners[k], corners[(k + 1) % corners.size()]});
  }
  return sides;
}

std::string list_names(const std::vector<std::string>& names, const std::vector<Side>& sides,
                       std::span<const int> which) {
  std::string list;
  for (size_t i = 0; i < which.size(); ++i) {
    if (i > 0) list += i + 1 == which.size() ? " and " : ", ";
    const Side& side = sides[static_cast<size_t>(which[i])];
    list += names[static_cast<size_t>(side.panel)] + " (side " + std::to_string(side.side + 1) + ")";
  }
  return list;
}

constexpr int kBorder = -1;

}  // namespace

PanelEdges find_panel_edges(const Polygons& panels, const std::vector<std::string>& names) {
  const std::vector<Side> sides = all_sides(panels);
  std::vector<int> order(sides.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int s, int t) {
    return sides[static_cast<size_t>(s)].ends() < sides[static_cast<size_t>(t)].ends();
  });

  std::vector<int> beyond(sides.size(), kBorder);  // the side on the other side of each
  std::vector<std::pair<int, std::string>> odd;    // by their first side
  for (size_t first = 0, last; first < order.size(); first = last) {
    const auto ends = sides[static_cast<size_t>(order[first])].ends();
    for (last = first + 1; last < order.size() && sides[static_cast<size_t>(order[last])].ends() == ends;)
      ++last;
    const std::span<const int> here(order.data() + first, last - first);
    if (here.size() == 1) continue;
    const Side& one = sides[static_cast<size_t>(here[0])];
    if (here.size() > 2) {
      odd.emplace_back(here[0], "more than two panels meet at one edge: " + list_names(names, sides, here) +
                                    "; it counts as border of each");
    } else if (one.from == sides[static_cast<size_t>(here[1])].from) {
      odd.emplace_back(here[0], "two panels that meet at an edge have their outsides on different sides: " +
                                    list_names(names, sides, here) + "; it counts as border of both");
    } else {
      beyond[static_cast<size_t>(here[0])] = here[1];
      beyond[static_cast<size_t>(here[1])] = here[0];
    }
  }
  std::sort(odd.begin(), odd.end());

  PanelEdges result;
  for (auto& [side, text] : odd) result.warnings.push_back(std::move(text));
  std::vector<int> edge_of(sides.size());
  for (size_t s = 0; s < sides.size(); ++s) {
    const Side& side = sides[s];
    const int other = beyond[s];
    if (other != kBorder && static_cast<size_t>(other) < s) {
      edge_of[s] = edge_of[static_cast<size_t>(other)];
      continue;
    }
    edge_of[s] = static_cast<int>(result.edges.size());
    WorkshopEdge edge{side.from, side.to, side.panel, -1, side.side, -1};
    if (other != kBorder) {
      edge.right = sides[static_cast<size_t>(other)].panel;
      edge.right_side = sides[static_cast<size_t>(other)].side;
    }
    result.edges.push_back(edge);
  }
  result.of_panel.reserve(panels.size(), static_cast<int>(sides.size()));
  for (int p = 0; p < panels.size(); ++p)
    result.of_panel.push_back(
        std::span<const int>(edge_of).subspan(static_cast<size_t>(panels.offsets()[static_cast<size_t>(p)]),
                                              static_cast<size_t>(panels.valence(p))));
  return result;
}

}  // namespace planewright
