// planewright-cli render IN -o PICTURE.png: a picture without a display.
#include <cstdio>
#include <filesystem>
#include <string>

#include "cli/commands.h"
#include "cli/output_files.h"
#include "core/diagnose/planarity.h"
#include "core/mesh/mesh_io.h"
#include "ui/render/renderer.h"

namespace planewright::cli {
namespace {

struct RenderOptions {
  std::string input, output, ghost, unit = "m";
  int width = 1600, height = 1000;
  bool planarity = false, dark = false;
};

// Any other ending would name a PNG what it is not.
Result<void> check_ending(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  if (CLI::detail::to_lower(ending) == ".png") return {};
  return fail(ErrorCode::Usage,
              ending.empty() ? "the name has no ending that says the format"
                             : "pictures are written as PNG, not as '" + ending + "'",
              path.string(), "Use .png");
}

ExitStatus run(const RenderOptions& options) {
  // What cannot be written should be known before the work, not after it.
  if (const auto png = check_ending(options.output); !png) return report(png.error());
  if (const auto writable =
          check_outputs({{"IN", options.input}, {"--ghost", options.ghost}}, {{"-o", options.output}});
      !writable)
    return report(writable.error());
  const auto checked = load_mesh(options.input);
  if (!checked) return report(checked.error());
  const Points& points = checked->mesh.positions();
  const Vector3d origin = points.rows() > 0 ? Vector3d(points.colwise().mean()) : Vector3d::Zero();

  render::Scene scene;
  render::PolygonLayer panels;
  panels.points = points.rowwise() - origin.transpose();
  panels.polygons = checked->mesh.faces();
  if (options.planarity) {
    const Planarity planarity = measure_planarity(points, panels.polygons);
    panels.polygon_values = planarity.per_panel;
    scene.colours = render::ColourScale{0.0, planarity.max, "Planarity", options.unit, std::nullopt};
  }
  scene.panels = std::move(panels);
  if (!options.ghost.empty()) {
    const auto ghost = load_mesh(options.ghost);
    if (!ghost) return report(ghost.error());
    render::PolygonLayer layer;
    layer.points = ghost->mesh.positions().rowwise() - origin.transpose();
    layer.polygons = ghost->mesh.faces();
    scene.ghost = std::move(layer);
  }
  render::PictureOptions picture;
  picture.width = options.width;
  picture.height = options.height;
  picture.theme.dark = options.dark;
  if (const auto drawn = render::render_picture(scene, picture, options.output); !drawn)
    return report(drawn.error());
  std::printf("%s: %d x %d\n", options.output.c_str(), options.width, options.height);
  return kSuccess;
}

}  // namespace

void add_render_command(CLI::App& app, ExitStatus& status) {
  auto options = std::make_shared<RenderOptions>();
  auto* command = app.add_subcommand("render", "Draw a mesh into a PNG, without a display");
  command->add_option("IN", options->input, "Mesh to draw (.obj .off .ply .stl)")->required();
  command->add_option("-o,--output", options->output, "Picture to write (.png)")->required();
  command->add_option("--ghost", options->ghost,
                      "Second mesh, drawn as a faint wire (the input of a design)");
  command->add_option("--width", options->width, "Pixels")->check(CLI::Range(16, 16384));
  command->add_option("--height", options->height, "Pixels")->check(CLI::Range(16, 16384));
  command->add_flag("--planarity", options->planarity,
                    "Colour panels by their distance from a plane, with a legend");
  command->add_option("--unit", options->unit, "Unit of the model, for the legend")
      ->check(CLI::IsMember({"mm", "cm", "m", "in"}));
  command->add_flag("--dark", options->dark, "Dark theme");
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace planewright::cli
