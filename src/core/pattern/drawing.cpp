#include "core/pattern/drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/pattern/contours.h"
#include "core/pattern/stroke_font.h"
#include "core/workshop/panel_names.h"

namespace planewright {
namespace {

using Eigen::Vector2d;

// Of the room that a name has (label_room): the name and its up mark stay within the first, names along sides
// within the second from their side, so they never meet.
constexpr double kNameRoom = 0.6, kEdgeRoom = 0.35;
constexpr double kEdgeText = 0.7;      // of text_height
constexpr double kSmallestText = 0.5;  // mm; names along sides that have no room for that are left out
constexpr double kOffSide = 0.5;       // heights between a side and the name along it

class PartPen {
 public:
  PartPen(const WorkshopModel& model, const FlatPattern& pattern, const LabelOptions& options,
          double rotation, const Vector2d& shift, Drawing& drawing)
      : model_(model),
        pattern_(pattern),
        options_(options),
        rotation_(rotation),
        turn_(Eigen::Rotation2Dd(rotation).toRotationMatrix()),
        shift_(shift),
        drawing_(drawing) {}

  void draw() {
    if (pattern_.empty()) return;
    line(DrawingLayer::Cut, pattern_.cut, true);
    for (const Contour* contour : {&pattern_.outer, &pattern_.inner})
      if (contour->rows() > 0 && *contour != pattern_.cut) line(DrawingLayer::Engrave, *contour, true);
    name();
    if (options_.edge_names) edge_names();
  }

 private:
  void line(DrawingLayer layer, const Contour& contour, bool closed) {
    DrawingLine line{layer, {}, closed, pattern_.panel};
    // A part that is not turned keeps its coordinates bit for bit.
    line.points = rotation_ == 0.0 ? contour : Contour(contour * turn_.transpose());
    line.points.rowwise() += shift_.transpose();
    drawing_.lines.push_back(std::move(line));
  }

  // at, angle: in the part's frame.
  void text(const std::string& words, const Vector2d& at, double height, double angle, bool is_name) {
    drawing_.texts.push_back(
        {DrawingLayer::Text, words, turn_ * at + shift_, height, rotation_ + angle, pattern_.panel, is_name});
    if (!options_.engrave_names) return;
    const Eigen::Matrix2d along = Eigen::Rotation2Dd(angle).toRotationMatrix();
    const Eigen::RowVector2d middle(stroke_width(words, height) / 2, height / 2);
    for (Contour& stroke : text_strokes(words, height)) {
      stroke.rowwise() -= middle;
      stroke = Contour(stroke * along.transpose());
      stroke.rowwise() += at.transpose();
      line(DrawingLayer::Engrave, stroke, false);
    }
  }

  // The name below the middle of its room, the up mark above it.
  void name() {
    const std::string& words = model_.names[static_cast<size_t>(pattern_.panel)];
    const bool mark = !pattern_.lies_flat;
    const double half = stroke_width(words, 1.0) / 2;
    const double height =
        std::min(options_.text_height, kNameRoom * pattern_.label_room / std::hypot(half, mark ? 1.3 : 0.5));
    const Vector2d up = Vector2d::UnitY(), aside = Vector2d::UnitX();
    text(words, pattern_.label - (mark ? 0.8 * height : 0.0) * up, height, 0.0, true);
    if (!mark) return;
    const Vector2d foot = pattern_.label + 0.1 * height * up, tip = pattern_.label + 1.3 * height * up;
    Contour shaft(2, 2), head(3, 2);
    shaft << foot.transpose(), tip.transpose();
    head << (tip - 0.4 * height * up - 0.3 * height * aside).transpose(), tip.transpose(),
        (tip - 0.4 * height * up + 0.3 * height * aside).transpose();
    line(DrawingLayer::Engrave, shaft, false);
    line(DrawingLayer::Engrave, head, false);
  }

  void edge_names() {
    for (Eigen::Index k = 0; k < pattern_.outer.rows(); ++k) {
      const int side = pattern_.side_of_segment[static_cast<size_t>(k)];
      if (side < 0) continue;
      const WorkshopEdge& edge =
          model_.edges[static_cast<size_t>(model_.edges_of_panel[pattern_.panel][static_cast<size_t>(side)])];
      if (edge.border()) continue;
      const int other = edge.left == pattern_.panel && edge.left_side == side ? edge.right : edge.left;
      edge_name(model_.names[static_cast<size_t>(other)], pattern_.outer.row(k).transpose(),
                pattern_.outer.row((k + 1) % pattern_.outer.rows()).transpose());
    }
  }

  void edge_name(const std::string& words, const Vector2d& a, const Vector2d& b) {
    const double length = (b - a).norm();
    if (!(length > 0.0)) return;
    const Vector2d along = (b - a) / length, inside(-along.y(), along.x());
    double height =
        std::min({kEdgeText * options_.text_height, kEdgeRoom * pattern_.label_room / (1 + kOffSide),
                  0.8 * length / stroke_width(words, 1.0)});
    for (; height >= kSmallestText; height *= 0.8) {
      const Vector2d at = (a + b) / 2 + (kOffSide + 0.5) * height * inside;
      const Vector2d half = stroke_width(words, height) / 2 * along, up = height / 2 * inside;
      const auto within = [&](const Vector2d& p) { return depth_in(pattern_.outer, p) > 0.0; };
      if (!within(at - half - up) || !within(at + half - up) || !within(at - half + up) ||
          !within(at + half + up))
        continue;
      // Nearer to another side it would be read as that side's.
      if (depth_in(pattern_.outer, at) < (1.0 - 1e-9) * (kOffSide + 0.5) * height) continue;
      // Readable with the part's up upwards; along an upright side from below.
      const bool turned_over = along.x() < -1e-9 || (along.x() < 1e-9 && along.y() < 0.0);
      const double angle = std::atan2(along.y(), along.x());
      text(words, at, height, turned_over ? angle - std::copysign(std::numbers::pi, angle) : angle, false);
      return;
    }
  }

  const WorkshopModel& model_;
  const FlatPattern& pattern_;
  const LabelOptions& options_;
  double rotation_;
  Eigen::Matrix2d turn_;
  Vector2d shift_;
  Drawing& drawing_;
};

}  // namespace

std::string_view layer_name(DrawingLayer layer) {
  switch (layer) {
    case DrawingLayer::Cut:
      return "CUT";
    case DrawingLayer::Engrave:
      return "ENGRAVE";
    case DrawingLayer::Text:
      return "TEXT";
    case DrawingLayer::Sheet:
      return "SHEET";
  }
  return "";
}

Drawing part_drawing(const WorkshopModel& model, const FlatPattern& pattern, const LabelOptions& options) {
  Drawing drawing;
  drawing.title = model.names[static_cast<size_t>(pattern.panel)];
  if (!pattern.empty()) {
    drawing.width = pattern.cut.col(0).maxCoeff();
    drawing.height = pattern.cut.col(1).maxCoeff();
  }
  PartPen(model, pattern, options, 0.0, Vector2d::Zero(), drawing).draw();
  return drawing;
}

Drawing sheet_drawing(const WorkshopModel& model, const std::vector<FlatPattern>& patterns,
                      const Nesting& nesting, int sheet, const LabelOptions& options) {
  Drawing drawing;
  drawing.title = (model.title.empty() ? "" : model.title + ", ") + "sheet " + std::to_string(sheet + 1) +
                  " of " + std::to_string(nesting.sheets.size());
  drawing.width = nesting.sheet.width;
  drawing.height = nesting.sheet.height;
  Contour border(4, 2);
  border << 0, 0, drawing.width, 0, drawing.width, drawing.height, 0, drawing.height;
  drawing.lines.push_back({DrawingLayer::Sheet, border, true, -1});
  for (const PlacedPart& part : nesting.sheets[static_cast<size_t>(sheet)].parts) {
    const auto pattern = std::find_if(patterns.begin(), patterns.end(),
                                      [&](const FlatPattern& p) { return p.panel == part.panel; });
    PartPen(model, *pattern, options, part.rotation, part.shift, drawing).draw();
  }
  return drawing;
}

Drawing row_drawing(const WorkshopModel& model, const std::vector<FlatPattern>& patterns, double spacing,
                    const LabelOptions& options) {
  Drawing drawing;
  drawing.title = model.title;
  std::vector<const FlatPattern*> order;
  double area = 0.0, widest = 0.0;
  for (const FlatPattern& pattern : patterns) {
    if (pattern.empty()) continue;
    order.push_back(&pattern);
    const Vector2d box = pattern.cut.colwise().maxCoeff().transpose();
    area += (box.x() + spacing) * (box.y() + spacing);
    widest = std::max(widest, box.x());
  }
  const auto name = [&](const FlatPattern* p) -> const std::string& {
    return model.names[static_cast<size_t>(p->panel)];
  };
  std::sort(order.begin(), order.end(),
            [&](const FlatPattern* a, const FlatPattern* b) { return natural_name_less(name(a), name(b)); });

  // Where each part's lower left corner is, from the top of the page downwards; then the page is as high.
  const double width = std::max(std::sqrt(area), widest);
  std::vector<Vector2d> corners;
  double x = 0.0, top = 0.0, row = 0.0;
  size_t first = 0;
  const auto end_row = [&](size_t end) {
    for (size_t k = first; k < end; ++k) corners[k].y() = -top - row;
    top += row + spacing;
    first = end;
    x = row = 0.0;
  };
  for (size_t k = 0; k < order.size(); ++k) {
    const Vector2d box = order[k]->cut.colwise().maxCoeff().transpose();
    if (x > 0.0 && x + box.x() > width) end_row(k);
    corners.emplace_back(x, 0.0);
    drawing.width = std::max(drawing.width, x + box.x());
    x += box.x() + spacing;
    row = std::max(row, box.y());
  }
  if (!order.empty()) end_row(order.size());
  drawing.height = std::max(0.0, top - spacing);
  for (size_t k = 0; k < order.size(); ++k)
    PartPen(model, *order[k], options, 0.0, corners[k] + Vector2d(0.0, drawing.height), drawing).draw();
  return drawing;
}

}  // namespace planewright
