#include "core/pattern/nesting.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/pattern/part_fit.h"
#include "core/pattern/sheet_filling.h"

namespace planewright {
namespace {

using Eigen::Vector2d;
using std::numbers::pi;

constexpr double kSlack = 1e-6;  // mm

// How a part may be turned; empty: it fits no sheet.
std::vector<double> angles_of(const Contour& hull, const NestingOptions& options, const Vector2d& room) {
  const auto fits = [&](double angle) {
    return ((box_of(turned(hull, angle)) - room).array() <= kSlack).all();
  };
  if (!options.rotate) return fits(0.0) ? std::vector{0.0} : std::vector<double>{};
  std::vector<double> angles;
  const double first = smallest_box_angle(hull);
  for (int quarter = 0; quarter < 4; ++quarter)
    if (fits(first + quarter * pi / 2)) angles.push_back(first + quarter * pi / 2);
  if (angles.empty())
    if (const auto angle = fitting_angle(hull, room.x(), room.y())) angles = {*angle, *angle + pi};
  return angles;
}

struct Filled {
  std::vector<Placement> placed;
  double area = 0.0;
};

}  // namespace

Result<Nesting> nest(const std::vector<FlatPattern>& patterns, const NestingOptions& options,
                     const std::function<void(int, int)>& progress, const std::stop_token& stop) {
  const SheetSize& sheet = options.sheet;
  for (const double value : {sheet.width, sheet.height, options.spacing, options.margin})
    if (!std::isfinite(value) || value < 0.0 || std::max(sheet.width, sheet.height) > 1e6)
      return fail(ErrorCode::Refused, "a size of the sheet, its margin or the spacing is no length", "sheet",
                  "give lengths of 0 mm or more, below 1 km");
  const Vector2d room = Vector2d(sheet.width, sheet.height) - 2 * options.margin * Vector2d::Ones();
  if (!(sheet.width > 0.0 && sheet.height > 0.0))
    return fail(ErrorCode::Refused, "the sheet has no area", "sheet",
                "give its size in millimetres, as 3210x6000");
  if (!(room.minCoeff() > 0.0))
    return fail(ErrorCode::Refused, "the margins leave nothing of the sheet", "sheet",
                "give a larger sheet or a smaller margin");

  Nesting nesting;
  nesting.sheet = sheet;
  std::vector<SheetPart> parts;
  for (size_t k = 0; k < patterns.size(); ++k) {
    if (patterns[k].empty()) continue;
    const Contour hull = convex_hull(patterns[k].cut);
    const std::vector<double> angles = angles_of(hull, options, room);
    if (angles.empty())
      nesting.unplaced.push_back(patterns[k].panel);
    else
      parts.emplace_back(patterns[k].panel, signed_area(patterns[k].cut), hull, angles, options.spacing);
  }
  std::sort(nesting.unplaced.begin(), nesting.unplaced.end());
  const int total = static_cast<int>(parts.size() + nesting.unplaced.size());
  int done = static_cast<int>(nesting.unplaced.size());
  if (progress) progress(done, total);

  std::vector<size_t> waiting(parts.size());
  for (size_t k = 0; k < waiting.size(); ++k) waiting[k] = k;
  double area = 0.0;
  while (!waiting.empty()) {
    const std::optional<std::vector<Placement>> placed = fill_sheet(parts, waiting, room, stop);
    if (!placed) {
      nesting.stopped = true;
      break;
    }
    NestedSheet filled;
    std::vector<bool> on_sheet(parts.size(), false);
    double used = 0.0;
    for (const Placement& at : *placed) {
      on_sheet[at.part] = true;
      used += parts[at.part].area();
      filled.parts.push_back(
          {parts[at.part].panel(), at.rotation, at.shift + options.margin * Vector2d::Ones()});
    }
    std::sort(filled.parts.begin(), filled.parts.end(),
              [](const PlacedPart& a, const PlacedPart& b) { return a.panel < b.panel; });
    filled.filled = used / (sheet.width * sheet.height);
    area += used;
    std::erase_if(waiting, [&](size_t k) { return on_sheet[k]; });
    done += static_cast<int>(placed->size());
    nesting.sheets.push_back(std::move(filled));
    if (progress) progress(done, total);
  }
  if (!nesting.sheets.empty())
    nesting.filled = area / (sheet.width * sheet.height * static_cast<double>(nesting.sheets.size()));
  return nesting;
}

}  // namespace planewright
