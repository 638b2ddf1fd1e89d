#include "core/certify/part_checks.h"

#include <algorithm>
#include <cmath>

#include "core/certify/check_text.h"
#include "core/certify/contours_apart.h"
#include "core/certify/placed_parts.h"

namespace planewright {
namespace {

using Eigen::Vector2d;

constexpr double kLimit = 1e-6;  // mm

// What the drawings show, drawing by drawing.
using Drawn = std::vector<std::vector<PlacedPattern>>;

long long parts_in(const Drawn& drawn) {
  long long all = 0;
  for (const auto& parts : drawn) all += static_cast<long long>(parts.size());
  return all;
}

const std::string& name(const ExportContent& content, const PlacedPattern& part) {
  return content.model->names[static_cast<size_t>(part.line->panel)];
}

Check once_each(const ExportContent& content, const Drawn& drawn) {
  const int count = content.model->panel_count();
  std::vector<int> times(static_cast<size_t>(count), 0);
  for (const auto& parts : drawn)
    for (const PlacedPattern& part : parts) ++times[static_cast<size_t>(part.line->panel)];
  std::vector<std::string> wrong;
  int wanted = 0;
  for (int p = 0; p < count; ++p) {
    const bool left_out = std::binary_search(content.left_out.begin(), content.left_out.end(), p);
    const bool empty = content.patterns && (*content.patterns)[static_cast<size_t>(p)].empty();
    const int should = left_out || empty ? 0 : 1, is = times[static_cast<size_t>(p)];
    wanted += should;
    if (is != should)
      wrong.push_back(content.model->names[static_cast<size_t>(p)] + " on " + std::to_string(is));
  }
  std::string detail = counted(wanted) + " parts on " + counted(static_cast<long long>(drawn.size())) +
                       (drawn.size() == 1 ? " drawing" : " drawings");
  if (!content.left_out.empty())
    detail += ", " + counted(static_cast<long long>(content.left_out.size())) + " left out";
  if (!wrong.empty()) detail += "; wrong: " + listed(wrong);
  return {"every part on one drawing", wrong.empty(), detail};
}

Check as_patterns(const ExportContent& content, const Drawn& drawn) {
  std::vector<std::string> wrong;
  double largest = 0.0;
  for (const auto& parts : drawn)
    for (const PlacedPattern& part : parts) {
      if (std::isfinite(part.difference)) largest = std::max(largest, part.difference);
      if (!part.pattern || !(part.difference <= kLimit)) wrong.push_back(name(content, part));
    }
  std::string detail =
      counted(parts_in(drawn)) + " parts, turned and moved, " + against_limit(largest, kLimit, "mm");
  if (!wrong.empty()) detail += "; wrong: " + listed(wrong);
  return {"parts as their patterns", wrong.empty(), detail};
}

Check parts_apart(const ExportContent& content, const Drawn& drawn) {
  const double spacing = content.nesting ? content.nesting->spacing : 0.0;
  std::vector<std::string> overlapping, near;
  long long tested = 0;
  for (const auto& parts : drawn) {
    struct Box {
      const PlacedPattern* part;
      Vector2d low, high;
    };
    std::vector<Box> boxes;
    for (const PlacedPattern& part : parts)
      boxes.push_back(
          {&part, part.line->points.colwise().minCoeff(), part.line->points.colwise().maxCoeff()});
    std::sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.low.x() < b.low.x(); });
    for (size_t i = 0; i < boxes.size(); ++i)
      for (size_t k = i + 1; k < boxes.size() && boxes[k].low.x() <= boxes[i].high.x() + spacing; ++k) {
        if (boxes[k].low.y() > boxes[i].high.y() + spacing || boxes[i].low.y() > boxes[k].high.y() + spacing)
          continue;
        ++tested;
        const Apart found = apart(boxes[i].part->line->points, boxes[k].part->line->points, spacing, kLimit);
        if (found != Apart::Yes)
          (found == Apart::Overlap ? overlapping : near)
              .push_back(name(content, *boxes[i].part) + "/" + name(content, *boxes[k].part));
      }
  }
  std::string detail = counted(tested) + " pairs with boxes that are near, ";
  detail += content.nesting ? "spacing " + brief(spacing) + " mm (less 1e-06)" : std::string("none overlaps");
  if (!overlapping.empty()) detail += "; overlapping: " + listed(overlapping);
  if (!near.empty()) detail += "; too near: " + listed(near);
  return {"parts apart", overlapping.empty() && near.empty(), detail};
}

Check inside_margins(const ExportContent& content, const Drawn& drawn) {
  const double margin = content.nesting ? content.nesting->margin : 0.0;
  std::vector<std::string> wrong;
  for (size_t d = 0; d < drawn.size(); ++d) {
    const Drawing& drawing = content.drawings[d];
    if (content.nesting &&
        (drawing.width != content.nesting->sheet.width || drawing.height != content.nesting->sheet.height))
      wrong.push_back("the size of sheet " + std::to_string(d + 1));
    const Vector2d low = Vector2d::Constant(margin - kLimit),
                   high = Vector2d(drawing.width, drawing.height) - low;
    for (const PlacedPattern& part : drawn[d]) {
      const Vector2d from = part.line->points.colwise().minCoeff(),
                     to = part.line->points.colwise().maxCoeff();
      if (!((from - low).minCoeff() >= 0.0 && (high - to).minCoeff() >= 0.0))
        wrong.push_back(name(content, part));
    }
  }
  std::string detail = counted(parts_in(drawn)) + " parts, ";
  detail +=
      content.nesting ? "margin " + brief(margin) + " mm (less 1e-06)" : std::string("in rows on the page");
  if (!wrong.empty()) detail += "; wrong: " + listed(wrong);
  return {"parts inside the margins", wrong.empty(), detail};
}

}  // namespace

std::vector<Check> check_parts(const ExportContent& content) {
  Drawn drawn;
  for (const Drawing& drawing : content.drawings) drawn.push_back(placed_patterns(drawing, content.patterns));
  std::vector<Check> checks{once_each(content, drawn)};
  if (content.patterns) checks.push_back(as_patterns(content, drawn));
  checks.push_back(parts_apart(content, drawn));
  checks.push_back(inside_margins(content, drawn));
  return checks;
}

}  // namespace planewright
