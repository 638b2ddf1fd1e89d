// planewright-cli check IN [--tolerance T]: health and planarity of any polygon mesh.
#include <cstdio>
#include <memory>

#include "cli/commands.h"
#include "cli/finite_number.h"
#include "core/diagnose/planarity.h"
#include "core/mesh/mesh_io.h"

namespace planewright::cli {
namespace {

constexpr double kRelativeTolerance = 1e-9;  // of the bounding box's diagonal, when none is given

struct CheckOptions {
  std::string input;
  double tolerance = -1.0;
};

void print_elements(const Defect& defect) {
  constexpr size_t kShown = 10;
  const bool edges =
      defect.kind == DefectKind::NonManifoldEdge || defect.kind == DefectKind::InconsistentOrientation;
  std::printf("    at");
  const size_t count = std::min(defect.elements.size(), edges ? 2 * kShown : kShown);
  for (size_t k = 0; k < count; k += edges ? 2 : 1)
    edges&& k + 1 < count ? std::printf(" %d-%d", defect.elements[k], defect.elements[k + 1])
                          : std::printf(" %d", defect.elements[k]);
  std::printf(count < defect.elements.size() || defect.elements.size() < static_cast<size_t>(defect.count)
                  ? " ...\n"
                  : "\n");
}

ExitStatus run(const CheckOptions& options) {
  const auto checked = load_mesh(options.input);
  if (!checked) return report(checked.error());
  const HealthReport& health = checked->health;
  std::printf("%s: %d vertices, %d faces, %d component%s, %d border loop%s\n", options.input.c_str(),
              health.vertices, health.faces, health.components, health.components == 1 ? "" : "s",
              health.border_loops, health.border_loops == 1 ? "" : "s");
  std::printf("health: %s\n", health.summary().c_str());
  for (const Defect& defect : health.defects) {
    std::printf("  %s: %d, %s\n", name(defect.kind), defect.count, defect.action.c_str());
    if (!defect.elements.empty()) print_elements(defect);
  }

  const PolygonMesh& mesh = checked->mesh;
  const Polygons faces = mesh.faces();
  const Planarity planarity = measure_planarity(mesh.positions(), faces);
  const double diagonal = bounding_diagonal(mesh.positions());
  const double tolerance = options.tolerance >= 0.0 ? options.tolerance : kRelativeTolerance * diagonal;
  std::printf("planarity: max %.3g, mean %.3g (%.3g of the diagonal), tolerance %.3g\n", planarity.max,
              planarity.mean, planarity.max_relative_to_bbox, tolerance);
  int beyond = 0;
  for (const double d : planarity.per_panel) beyond += d > tolerance;
  if (beyond > 0)
    std::printf("not planar: %d of %d faces are beyond the tolerance, the worst is face %d\n", beyond,
                faces.size(), planarity.worst);
  else
    std::printf("planar\n");
  return health.healthy() && beyond == 0 ? kSuccess : kNotMet;
}

}  // namespace

void add_check_command(CLI::App& app, ExitStatus& status) {
  auto options = std::make_shared<CheckOptions>();
  auto* command =
      app.add_subcommand("check", "Tell the health and the planarity of a polygon mesh (status 1: not well)");
  command->add_option("IN", options->input, "Mesh to check (.obj .off .ply .stl)")->required();
  command
      ->add_option(
          "--tolerance", options->tolerance,
          "Allowed distance of a corner from its face's plane, model units (default: 1e-9 diagonals)")
      ->check(finite_number())
      ->check(CLI::NonNegativeNumber);
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace planewright::cli
