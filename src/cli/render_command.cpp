// planewright-cli render IN... -o PICTURE.png: a picture without a display, of one mesh or of several to be
// compared.
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <set>
#include <string>

#include "cli/commands.h"
#include "cli/output_files.h"
#include "core/diagnose/crossings.h"
#include "core/diagnose/panel_shape.h"
#include "core/diagnose/planarity.h"
#include "core/mesh/mesh_io.h"
#include "ui/render/picture.h"
#include "ui/render/png.h"
#include "ui/render/sheet.h"

namespace planewright::cli {
namespace {

struct RenderOptions {
  std::vector<std::string> inputs;
  // One for all of the inputs, or one for each.
  std::vector<std::string> ghosts, seconds, captions, views;
  std::string output, unit = "m";
  int width = 1600, height = 1000, columns = 0;
  bool planarity = false, dark = false, mark_crossings = false;
};

// What --view says.
struct View {
  double azimuth = 0.0, elevation = 0.0;  // radians
  double zoom = 1.0;
  bool centred = false;                // on the centre; else on the whole
  Vector3d centre = Vector3d::Zero();  // model units
};

// A penetration of less than this part of the second mesh's diagonal is touching.
constexpr double kTouch = 1e-7;

// Any other ending would name a PNG what it is not.
Result<void> check_ending(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  if (CLI::detail::to_lower(ending) == ".png") return {};
  return fail(ErrorCode::Usage,
              ending.empty() ? "the name has no ending that says the format"
                             : "pictures are written as PNG, not as '" + ending + "'",
              path.string(), "Use .png");
}

Result<void> check_counts(const RenderOptions& options) {
  const std::pair<const char*, size_t> lists[] = {{"--ghost", options.ghosts.size()},
                                                  {"--with", options.seconds.size()},
                                                  {"--caption", options.captions.size()},
                                                  {"--view", options.views.size()}};
  for (const auto& [option, count] : lists)
    if (count > 1 && count != options.inputs.size())
      return fail(ErrorCode::Usage,
                  std::to_string(options.inputs.size()) + " meshes, but " + option + " is given " +
                      std::to_string(count) + " times",
                  option, "Give it once for all of them, or once for each");
  return {};
}

// The entry of a list that has one for all or one for each; null: the list is empty.
const std::string* entry(const std::vector<std::string>& list, size_t i) {
  return list.empty() ? nullptr : &list[list.size() == 1 ? 0 : i];
}

Result<View> parse_view(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& word : CLI::detail::split(text, ':')) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(number)) break;
    numbers.push_back(number);
  }
  const size_t words = CLI::detail::split(text, ':').size();
  if (numbers.size() != words || (words != 2 && words != 3 && words != 6) ||
      (words > 2 && !(numbers[2] > 0.0)))
    return fail(ErrorCode::Usage, "'" + text + "' is no view", "--view",
                "Write AZIMUTH:ELEVATION[:ZOOM[:X:Y:Z]], degrees, ZOOM above 0");
  View view{numbers[0] * std::numbers::pi / 180.0, numbers[1] * std::numbers::pi / 180.0, 1.0};
  if (words > 2) view.zoom = numbers[2];
  view.centred = words > 3;
  if (view.centred) view.centre = Vector3d(numbers[3], numbers[4], numbers[5]);
  return view;
}

// Everything relative to `origin`, which the first mesh sets.
Result<render::Scene> draw_up(const RenderOptions& options, size_t i, std::optional<Vector3d>& origin) {
  const auto checked = load_mesh(options.inputs[i]);
  if (!checked) return tl::unexpected(checked.error());
  const Points& points = checked->mesh.positions();
  if (!origin) origin = points.rows() > 0 ? Vector3d(points.colwise().mean()) : Vector3d::Zero();
  const auto layer_of = [&](const PolygonMesh& mesh) {
    render::PolygonLayer layer;
    layer.points = mesh.positions().rowwise() - origin->transpose();
    layer.polygons = mesh.faces();
    return layer;
  };

  render::Scene scene;
  render::PolygonLayer panels = layer_of(checked->mesh);
  if (options.planarity) {
    const Planarity planarity = measure_planarity(points, panels.polygons);
    panels.polygon_values = planarity.per_panel;
    scene.colours = render::ColourScale{0.0, planarity.max, "Planarity", options.unit, std::nullopt};
  }
  std::set<int> crossing;
  if (options.mark_crossings)
    for (int panel : find_self_crossing(points, panels.polygons)) crossing.insert(panel);
  if (const std::string* name = entry(options.ghosts, i)) {
    const auto ghost = load_mesh(*name);
    if (!ghost) return tl::unexpected(ghost.error());
    scene.ghost = layer_of(ghost->mesh);
  }
  if (const std::string* name = entry(options.seconds, i)) {
    const auto second = load_mesh(*name);
    if (!second) return tl::unexpected(second.error());
    const Points& others = second->mesh.positions();
    scene.further.push_back({render::Tone::Second, layer_of(second->mesh)});
    if (options.mark_crossings && others.rows() > 0) {
      const double diagonal = (others.colwise().maxCoeff() - others.colwise().minCoeff()).norm();
      for (const Crossing& pair :
           find_crossings({points, checked->mesh.faces()}, {others, second->mesh.faces()}, kTouch * diagonal))
        crossing.insert(pair.first);
    }
  }
  scene.crossing.assign(crossing.begin(), crossing.end());
  scene.panels = std::move(panels);
  return scene;
}

// Meshes that are compared are seen from one place, far enough away for all of them.
render::Camera camera_of(const std::vector<render::Scene>& scenes, const View* view, const Vector3d& origin,
                         int width, int height) {
  std::vector<Points> all;
  Eigen::Index count = 0;
  for (const render::Scene& scene : scenes) count += all.emplace_back(render::points_of(scene)).rows();
  Points points(count, 3);
  Eigen::Index first = 0;
  for (const Points& some : all) {
    points.middleRows(first, some.rows()) = some;
    first += some.rows();
  }

  render::Camera camera;
  camera.set_viewport(width, height);
  if (view) camera.set_direction(view->azimuth, view->elevation);
  camera.fit(points);
  if (!view) return camera;
  Vector3d centre = camera.target();
  if (view->centred) {
    centre = view->centre - origin;
    camera.pan(glm::vec2(0.5f * static_cast<float>(width), 0.5f * static_cast<float>(height)) -
                   camera.project(centre),
               centre);
  }
  camera.zoom(view->zoom, centre);
  return camera;
}

ExitStatus run(const RenderOptions& options) {
  // What cannot be written should be known before the work, not after it.
  if (const auto png = check_ending(options.output); !png) return report(png.error());
  if (const auto counts = check_counts(options); !counts) return report(counts.error());
  std::vector<NamedFile> inputs;
  for (const std::string& name : options.inputs) inputs.push_back({"IN", name});
  for (const std::string& name : options.ghosts) inputs.push_back({"--ghost", name});
  for (const std::string& name : options.seconds) inputs.push_back({"--with", name});
  if (const auto writable = check_outputs(inputs, {{"-o", options.output}}); !writable)
    return report(writable.error());
  std::vector<View> views;
  for (const std::string& text : options.views) {
    const auto view = parse_view(text);
    if (!view) return report(view.error());
    views.push_back(*view);
  }

  const int count = static_cast<int>(options.inputs.size());
  const int columns = options.columns > 0 ? std::min(options.columns, count) : count;
  const int rows = (count + columns - 1) / columns;
  const render::SheetLayout layout{columns, options.width, !options.captions.empty()};
  render::PictureOptions picture;
  picture.width = (options.width - (columns - 1) * layout.gap()) / columns;
  picture.height = (options.height - (rows - 1) * layout.gap()) / rows - layout.caption_height();
  if (picture.width < 16 || picture.height < 16)
    return report(Error{ErrorCode::Usage,
                        std::to_string(options.width) + " x " + std::to_string(options.height) +
                            " pixels are too few for " + std::to_string(count) + " meshes",
                        "--width, --height", "Take a larger picture"});
  picture.theme.dark = options.dark;

  std::vector<render::Scene> scenes;
  std::optional<Vector3d> origin;
  for (size_t i = 0; i < options.inputs.size(); ++i) {
    auto scene = draw_up(options, i, origin);
    if (!scene) return report(scene.error());
    scenes.push_back(std::move(*scene));
  }
  // Colours mean the same in every cell.
  double high = 0.0;
  for (const render::Scene& scene : scenes)
    if (scene.colours) high = std::max(high, scene.colours->high);

  std::vector<render::Cell> cells;
  for (size_t i = 0; i < scenes.size(); ++i) {
    render::Scene& scene = scenes[i];
    if (scene.colours) scene.colours->high = high;
    const View* view = views.empty() ? nullptr : &views[views.size() == 1 ? 0 : i];
    picture.camera = camera_of(scenes, view, *origin, picture.width, picture.height);
    const std::string* caption = entry(options.captions, i);
    auto image = render::render_image(scene, picture);
    if (!image) return report(image.error());
    cells.push_back({std::move(*image), caption ? *caption : ""});
  }
  const render::Image sheet = render::make_sheet(cells, layout, picture.theme);
  if (const auto written = render::write_png(sheet, options.output); !written) return report(written.error());
  if (options.mark_crossings)
    for (size_t i = 0; i < scenes.size(); ++i) {
      const std::string* second = entry(options.seconds, i);
      std::printf("%s: panels that cross themselves%s%s: %zu\n", options.inputs[i].c_str(),
                  second ? " or " : "", second ? second->c_str() : "", scenes[i].crossing.size());
    }
  std::printf("%s: %d x %d\n", options.output.c_str(), sheet.width, sheet.height);
  return kSuccess;
}

}  // namespace

void add_render_command(CLI::App& app, ExitStatus& status) {
  auto options = std::make_shared<RenderOptions>();
  auto* command = app.add_subcommand("render", "Draw meshes into a PNG, without a display");
  const auto add_list = [&](const char* name, std::vector<std::string>& list, const char* help) {
    command->add_option(name, list, help)->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  };
  command
      ->add_option("IN", options->inputs,
                   "Mesh to draw (.obj .off .ply .stl); several: one beside the other, seen from one place")
      ->required();
  command->add_option("-o,--output", options->output, "Picture to write (.png)")->required();
  add_list("--ghost", options->ghosts, "Second mesh, drawn as a faint wire (the input of a design)");
  add_list("--with", options->seconds, "Second mesh, drawn as a solid surface");
  command->add_flag("--mark-crossings", options->mark_crossings,
                    "Tint panels that cross themselves or the mesh of --with, and count them");
  add_list("--caption", options->captions, "Text below the mesh");
  add_list("--view", options->views,
           "AZIMUTH:ELEVATION[:ZOOM[:X:Y:Z]]: where from (degrees), how much closer than for the whole, and "
           "what to put in the middle (model units)");
  command->add_option("--columns", options->columns, "Meshes in a row (default: all)")
      ->check(CLI::Range(1, 1000));
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
