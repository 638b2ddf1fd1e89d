#include "core/workshop/workshop_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "core/workshop/panel_edges.h"
#include "core/workshop/panel_names.h"
#include "core/workshop/panel_plane.h"

namespace planewright {
namespace {

constexpr double kLargestCoordinate = 1e100;  // mm; squares of what is beyond could overflow

std::string panel_text(const std::vector<int>& numbers, int panel) {
  return "panel " + std::to_string(numbers[static_cast<size_t>(panel)]);
}

Result<std::vector<int>> panel_numbers(const WorkshopOptions& options, int panels) {
  std::vector<int> numbers = options.numbers;
  if (numbers.empty()) {
    numbers.resize(static_cast<size_t>(panels));
    std::iota(numbers.begin(), numbers.end(), 0);
  }
  if (numbers.size() != static_cast<size_t>(panels))
    return fail(ErrorCode::Refused, "there are " + std::to_string(numbers.size()) + " panel numbers for " +
                                        std::to_string(panels) + " panels");
  std::set<int> seen;
  for (const int number : numbers) {
    if (number < 0)
      return fail(ErrorCode::Refused, "a panel number is negative", "panel " + std::to_string(number));
    if (!seen.insert(number).second)
      return fail(ErrorCode::Refused, "two panels have the same number", "panel " + std::to_string(number));
  }
  return numbers;
}

Result<void> check_panels(const Points& points, const Polygons& panels, const std::vector<int>& numbers,
                          double factor) {
  std::vector<int> last_seen(static_cast<size_t>(points.rows()), -1);
  for (int p = 0; p < panels.size(); ++p) {
    const auto corners = panels[p];
    if (corners.size() < 3)
      return fail(ErrorCode::Refused, "a panel needs three corners and has " + std::to_string(corners.size()),
                  panel_text(numbers, p));
    for (const int v : corners) {
      const std::string corner = "corner " + std::to_string(v);
      if (v < 0 || v >= points.rows())
        return fail(ErrorCode::Refused, corner + " does not exist", panel_text(numbers, p));
      if (last_seen[static_cast<size_t>(v)] == p)
        return fail(ErrorCode::Refused, "the panel has " + corner + " twice", panel_text(numbers, p),
                    "Part it in two panels, or take the corner out");
      last_seen[static_cast<size_t>(v)] = p;
      if (!points.row(v).allFinite())
        return fail(ErrorCode::Refused, corner + " has a coordinate that is not a finite number",
                    panel_text(numbers, p));
      if (points.row(v).cwiseAbs().maxCoeff() > kLargestCoordinate / factor)
        return fail(ErrorCode::Refused, corner + " has a coordinate beyond 1e100 mm", panel_text(numbers, p));
    }
  }
  for (Eigen::Index v = 0; v < points.rows(); ++v)
    if (!points.row(v).allFinite())
      return fail(ErrorCode::Refused, "a coordinate is not a finite number", "point " + std::to_string(v));
  return {};
}

// The middle of the box round all corners, model units, rounded to a power of two that is small against the
// model: so that taking it off costs no digits.
Vector3d rounded_middle(const Points& points, const Polygons& panels) {
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const int v : panels.indices()) {
    low = low.cwiseMin(points.row(v).transpose());
    high = high.cwiseMax(points.row(v).transpose());
  }
  const Vector3d middle = low + 0.5 * (high - low);
  const double size = (high - low).maxCoeff();
  if (!(size > 0.0)) return middle;
  const double step = std::ldexp(1.0, std::ilogb(size) - 10);
  if (middle.cwiseAbs().maxCoeff() / step > 1e15) return middle;  // it has no digits below the step
  return (middle / step).array().round().matrix() * step;
}

}  // namespace

int WorkshopModel::neighbour(int panel, int side) const {
  const WorkshopEdge& edge = edges[static_cast<size_t>(edges_of_panel[panel][static_cast<size_t>(side)])];
  return edge.left == panel ? edge.right : edge.left;
}

Result<std::shared_ptr<const WorkshopModel>> make_workshop_model(const Points& points, const Polygons& panels,
                                                                 const WorkshopOptions& options) {
  if (panels.empty()) return fail(ErrorCode::Refused, "there are no panels");
  const double length = options.up.norm();
  if (!std::isfinite(length) || !(length > 0.0))
    return fail(ErrorCode::Refused, "the direction that is up has no length, or is not finite");
  auto numbers = panel_numbers(options, panels.size());
  if (!numbers) return tl::unexpected(std::move(numbers.error()));
  const double factor = millimetres_per(options.unit);
  if (auto checked = check_panels(points, panels, *numbers, factor); !checked)
    return tl::unexpected(std::move(checked.error()));

  auto model = std::make_shared<WorkshopModel>();
  model->title = options.title;
  model->model_unit = options.unit;
  model->up = options.up / length;
  const Vector3d middle = rounded_middle(points, panels);
  model->origin = middle * factor;
  model->points = (points.rowwise() - middle.transpose()) * factor;
  model->panels = panels;
  auto names = name_panels(model->points, panels, model->up, options.names, *numbers, options.kept_names);
  if (!names) return tl::unexpected(std::move(names.error()));
  model->numbers = std::move(*numbers);
  model->names = std::move(*names);
  PanelPlanes planes = fit_panel_planes(model->points, panels, model->up);
  model->normals = std::move(planes.normals);
  model->plane_offsets = std::move(planes.offsets);
  PanelEdges edges = find_panel_edges(panels, model->names);
  model->edges = std::move(edges.edges);
  model->edges_of_panel = std::move(edges.of_panel);
  model->warnings = std::move(edges.warnings);
  return std::shared_ptr<const WorkshopModel>(std::move(model));
}

}  // namespace planewright
