#include "core/advise/score.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/diagnose/panel_shape.h"
#include "core/diagnose/reversed_edges.h"

namespace planewright {
namespace {

constexpr double kShort = 0.15;  // mean edges, from which an edge counts as short
constexpr double kFar = 1.0, kMostFar = 4.0;

}  // namespace

double total(const Score& score, const ScoreWeights& weights) {
  return weights.energy * score.energy + weights.crossing * score.crossing +
         weights.short_edges * score.short_edges + weights.reversed * score.reversed +
         weights.far_points * score.far_points;
}

Region whole_region(const TangentComplex& complex) {
  const auto all = [](int count) {
    std::vector<int> list(static_cast<size_t>(count));
    std::iota(list.begin(), list.end(), 0);
    return list;
  };
  return {all(complex.point_count()), all(complex.plane_count()),
          all(static_cast<int>(complex.panel_edges.size()))};
}

Score defects_of(const TangentComplex& complex, const State& state, const Region& region) {
  Score score;
  Polygons panels;
  for (const int i : region.panels) {
    const auto panel = complex.panels[i];
    panels.push_back(std::vector<int>(panel.begin(), panel.end()));
  }
  const std::vector<int> crossing = find_self_crossing(state.x, panels);
  score.crossing = static_cast<double>(crossing.size());
  for (size_t k = 0; k < region.panels.size(); ++k) {
    const Vector3d area = newell_vector(state.x, panels[static_cast<int>(k)]);
    const bool turned = !(area.dot(state.n.row(region.panels[k])) > 0.0);
    if (turned && !std::binary_search(crossing.begin(), crossing.end(), static_cast<int>(k)))
      score.crossing += 1.0;
  }
  for (const int e : region.panel_edges) {
    const double s = signed_length(complex, state, e) / complex.mean_edge;
    score.short_edges += std::max(0.0, 1.0 - std::abs(s) / kShort);
    score.reversed += std::clamp(-s, 0.0, 1.0);
  }
  for (const int j : region.points) {
    const double off = (state.x.row(j) - complex.preferred.row(j)).norm() / complex.mean_edge;
    score.far_points += std::clamp(off - kFar, 0.0, kMostFar);
  }
  return score;
}

}  // namespace planewright
