#include "core/certify/schedule_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "core/certify/check_text.h"
#include "core/certify/placed_parts.h"
#include "core/certify/schedule_common.h"
#include "core/certify/value_check.h"

namespace planewright {
namespace {

using Eigen::Vector2d;

// How far a pattern, turned and moved as the file says, lies from where the drawing has it.
double off_drawing(const PlacedPattern& placed, double rotation, const Vector2d& shift) {
  const Contour &from = placed.pattern->cut, &to = placed.line->points;
  if (from.rows() != to.rows()) return std::numeric_limits<double>::infinity();
  const Eigen::Rotation2Dd turn(rotation);
  double off = 0.0;
  for (Eigen::Index i = 0; i < from.rows(); ++i)
    off = std::max(off, (turn * Vector2d(from.row(i)) + shift - Vector2d(to.row(i))).norm());
  return off;
}

double area_of(const Contour& c) {
  double twice = 0.0;
  for (Eigen::Index i = 1; i + 1 < c.rows(); ++i) {
    const Eigen::RowVector2d a = c.row(i) - c.row(0), b = c.row(i + 1) - c.row(0);
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

}  // namespace

Check check_places(const Json& json, const ExportContent& content) {
  const Json none = Json::object();
  const auto at = json.is_object() ? json.find("nesting") : json.end();
  const bool there = json.is_object() && at != json.end() && at->is_object();
  if (!content.nesting)
    return {"places on sheets", !there, there ? "there are no sheets, but places on some" : "no sheets"};
  const Json& nesting = there ? *at : none;
  constexpr double kLimit = 1e-6;  // mm
  ValueCheck values;
  std::vector<std::string> wrong;
  double largest = 0.0, filled = 0.0;
  long long places = 0;
  values.compare("sheets", "width_mm", number_of(nesting, "width_mm"), content.nesting->sheet.width);
  values.compare("sheets", "height_mm", number_of(nesting, "height_mm"), content.nesting->sheet.height);
  const Json& sheets = list_of(nesting, "sheets");
  values.compare("sheets", "number", static_cast<double>(sheets.size()),
                 static_cast<double>(content.drawings.size()));
  for (size_t d = 0; d < std::min(sheets.size(), content.drawings.size()); ++d) {
    const std::string who = "sheet " + std::to_string(d + 1);
    std::map<std::string, PlacedPattern> shown;
    double area = 0.0;
    for (const PlacedPattern& part : placed_patterns(content.drawings[d], content.patterns)) {
      shown.emplace(name_of_panel(content, part.line->panel), part);
      area += area_of(part.line->points);
    }
    area /= content.nesting->sheet.width * content.nesting->sheet.height;
    filled += area / static_cast<double>(content.drawings.size());
    values.compare(who, "filled", sheets[d].is_object() ? number_of(sheets[d], "filled") : std::nullopt,
                   area);
    for (const Json& part : list_of(sheets[d], "parts")) {
      const std::string panel = part.is_object() ? text_of(part, "panel") : std::string();
      const auto found = shown.find(panel);
      const auto turn = part.is_object() ? number_of(part, "rotation_rad") : std::nullopt;
      const Json& shift = list_of(part, "shift_mm");
      const auto x = number_at(shift, 0), y = number_at(shift, 1);
      if (found == shown.end() || !turn || !x || !y) {
        wrong.push_back(panel + " on " + who);
        continue;
      }
      ++places;
      const double off = found->second.pattern ? off_drawing(found->second, *turn, {*x, *y}) : 0.0;
      if (std::isfinite(off)) largest = std::max(largest, off);
      if (!(off <= kLimit)) wrong.push_back(panel + " on " + who);
      shown.erase(found);
    }
    for (const auto& [panel, part] : shown) wrong.push_back(panel + " not on " + who);
  }
  values.compare("sheets", "filled", number_of(nesting, "filled"), filled);
  std::set<std::string> unplaced, left_out;
  for (const Json& panel : list_of(nesting, "unplaced"))
    unplaced.insert(panel.is_string() ? panel.get<std::string>() : std::string());
  for (const int p : content.left_out)
    if (!content.patterns || !(*content.patterns)[static_cast<size_t>(p)].empty())
      left_out.insert(name_of_panel(content, p));
  if (unplaced != left_out) wrong.push_back("the panels that fit no sheet");
  const Check of_values = values.check({});
  std::string detail =
      counted(places) + " places, " + against_limit(largest, kLimit, "mm") + "; " + of_values.detail;
  if (!wrong.empty()) detail += "; not as drawn: " + listed(wrong);
  return {"places on sheets", wrong.empty() && of_values.pass, detail};
}

}  // namespace planewright
