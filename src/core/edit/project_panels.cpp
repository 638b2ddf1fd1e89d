#include "core/edit/project_panels.h"

#include <memory>

#include "core/design/design.h"

namespace planewright {
namespace {

Result<std::size_t> find_layer(const Design& design, const std::string& name) {
  if (name.empty()) return 0;
  std::string known;
  for (std::size_t k = 0; k < design.layers.size(); ++k) {
    if (design.layers[k].name == name) return k;
    known += (known.empty() ? "" : ", ") + design.layers[k].name;
  }
  return fail(ErrorCode::Usage, "the project has no layer '" + name + "'", "layer", "Its layers: " + known);
}

}  // namespace

Result<ProjectPanels> solved_panels(const Project& project, const std::string& layer) {
  const auto index = find_layer(project.design, layer);
  if (!index) return tl::unexpected(index.error());
  const Layer& chosen = project.design.layers[*index];
  if (*index >= project.solved.size() || !project.solved[*index])
    return fail(ErrorCode::Refused, "the project holds no solved panels of it", "layer '" + chosen.name + "'",
                "Solve it and save the project again");
  SharedClusters clusters;
  if (project.clusters) {
    auto made = clusters_of(std::make_shared<const PolygonMesh>(project.mesh), *project.clusters);
    if (!made) return tl::unexpected(made.error());
    clusters = std::move(*made);
  }
  const auto complex = build_complex(project.mesh, chosen.settings, clusters ? &clusters->regions : nullptr);
  if (!complex) return tl::unexpected(complex.error());
  ProjectPanels result;
  result.layer = static_cast<int>(*index);
  result.panels = panels_of(**complex, *project.solved[*index]);
  for (const int origin : (*complex)->plane_origin)
    result.numbers.push_back(
        project.names.panels.number(chosen.settings.mode, chosen.settings.border, project.names.ids, origin));
  if (const auto given = project.given_names.find(panel_series(chosen.settings));
      given != project.given_names.end())
    result.given_names.assign(given->second.begin(), given->second.end());
  return result;
}

}  // namespace planewright
