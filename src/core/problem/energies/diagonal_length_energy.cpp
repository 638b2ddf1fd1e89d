#include "core/problem/energies/diagonal_length_energy.h"

#include <algorithm>

#include "core/problem/energies/length_rows.h"

namespace planewright {
namespace {

// Ascending, each once.
std::vector<std::array<int, 2>> diagonals(const Polygons& panels) {
  std::vector<std::array<int, 2>> pairs;
  for (int p = 0; p < panels.size(); ++p) {
    const auto corners = panels[p];
    if (corners.size() < 4) continue;
    for (size_t k = 0; k < corners.size(); ++k) {
      const int a = corners[k], b = corners[(k + 2) % corners.size()];
      if (a != b) pairs.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  // A quad names both of its diagonals twice; panels on both sides of a point of valence 2 share one.
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace

std::unique_ptr<Energy> make_diagonal_length_energy(const EnergyContext& context) {
  return std::make_unique<LengthRows>("diagonal-length", context, diagonals(context.complex.panels));
}

}  // namespace planewright
