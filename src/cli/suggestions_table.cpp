#include "cli/suggestions_table.h"

#include <cstdio>

namespace planewright::cli {
namespace {

constexpr size_t kShown = 20;

}  // namespace

void print_suggestions(const std::vector<Suggestion>& ranked, const PolygonMesh& mesh) {
  if (ranked.empty()) {
    std::printf("suggestions: none\n");
    return;
  }
  std::printf("suggestions: %zu (predicted gain and what it is made of, mean edges squared)\n",
              ranked.size());
  std::printf("%-26s %-16s %7s %8s %8s %8s %8s %8s %8s\n", "edit", "vertices", "gain", "energy", "crossing",
              "short", "reversed", "far", "cost");
  for (size_t k = 0; k < ranked.size() && k < kShown; ++k) {
    const Suggestion& suggestion = ranked[k];
    const GainParts parts = suggestion.parts();
    const MeshEdge edge = mesh.edge(suggestion.candidate.mesh_edge);
    const std::string vertices = std::to_string(edge.a) + ", " + std::to_string(edge.b);
    std::printf("%-26s %-16s %7.2f %8.2f %8.2f %8.2f %8.2f %8.2f %8.2f%s\n", title(suggestion).c_str(),
                vertices.c_str(), suggestion.gain(), parts.energy, parts.crossing, parts.short_edges,
                parts.reversed, parts.far_points, parts.deviation + parts.given_up,
                suggestion.met ? "" : "  (not all constraints met there)");
  }
  if (ranked.size() > kShown) std::printf("... and %zu more (--json lists all)\n", ranked.size() - kShown);
}

}  // namespace planewright::cli
