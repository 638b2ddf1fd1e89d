#include "ui/sheet_preview.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

namespace planewright::ui {
namespace {

// The layers' colours in the files, on paper that is white in every theme.
constexpr ImU32 kPaper = IM_COL32(0xFF, 0xFF, 0xFF, 0xFF), kCut = IM_COL32(0xC6, 0x28, 0x28, 0xFF),
                kEngrave = IM_COL32(0x2B, 0x5F, 0xC4, 0xFF), kInk = IM_COL32(0x2C, 0x2A, 0x27, 0xFF),
                kSheet = IM_COL32(0x9A, 0x95, 0x8C, 0xFF), kFails = IM_COL32(0xF5, 0xC2, 0x6B, 0x5C),
                kSelected = IM_COL32(0x13, 0x7A, 0x78, 0x4C), kPointed = IM_COL32(0x13, 0x7A, 0x78, 0x20),
                kSmallName = IM_COL32(0x2C, 0x2A, 0x27, 0xA0);
constexpr double kWheel = 1.2;           // zoom of a notch
constexpr float kSlop = 4;               // pixels at scale 1 that a click may wander
constexpr double kSmallestLine = 1.5;    // pixels; what is smaller is not drawn
constexpr double kSmallestMark = 6.0;    // likewise, of what is engraved: seen when names are as they are
constexpr double kSmallestText = 5.0;    // pixels of a capital letter
constexpr double kSmallestPart = 14.0;   // pixels; smaller parts are not recorded
constexpr int kRecorded = 250;           // parts, at most
constexpr double kMostPixelsPerMm = 40;  // of zooming in

ImU32 colour_of(DrawingLayer layer) {
  switch (layer) {
    case DrawingLayer::Cut:
      return kCut;
    case DrawingLayer::Engrave:
      return kEngrave;
    case DrawingLayer::Text:
      return kInk;
    case DrawingLayer::Sheet:
      return kSheet;
  }
  return kInk;
}

// Of a font, in parts of its size: a capital letter's height, and how far its middle is below the line's top.
struct Capitals {
  float height, middle;
};
Capitals capitals_of(ImFont* font) {
  const ImFontGlyph* glyph = font->FindGlyph('H');
  if (glyph == nullptr || !(glyph->Y1 > glyph->Y0)) return {0.7f, 0.5f};
  return {(glyph->Y1 - glyph->Y0) / font->FontSize, 0.5f * (glyph->Y0 + glyph->Y1) / font->FontSize};
}

double fitting_scale(const Drawing& drawing, ImVec2 min, ImVec2 max) {
  constexpr double kShare = 0.94;  // of the place
  return kShare * std::min(static_cast<double>(max.x - min.x) / std::max(drawing.width, 1e-6),
                           static_cast<double>(max.y - min.y) / std::max(drawing.height, 1e-6));
}

// Text whose middle stands at `at`, turned clockwise on the screen by `turn`.
void draw_turned(ImDrawList& draw, ImFont* font, const Capitals& capitals, const std::string& text, ImVec2 at,
                 float letter_height, float turn, ImU32 colour) {
  const float size = letter_height / capitals.height;
  const ImVec2 extent = font->CalcTextSizeA(size, FLT_MAX, 0.0f, text.data(), text.data() + text.size());
  const int first = draw.VtxBuffer.Size;
  // Drawn at the place's own top left, whatever is in sight of it, and then moved.
  font->RenderText(&draw, size, ImVec2(0, 0), colour, ImVec4(-1e6f, -1e6f, 1e6f, 1e6f), text.data(),
                   text.data() + text.size());
  const float c = std::cos(turn), s = std::sin(turn);
  for (int i = first; i < draw.VtxBuffer.Size; ++i) {
    ImVec2& p = draw.VtxBuffer[i].pos;
    const float x = p.x - 0.5f * extent.x, y = p.y - capitals.middle * size;
    p = ImVec2(at.x + c * x - s * y, at.y + s * x + c * y);
  }
}

bool inside(const Contour& contour, double x, double y) {
  bool in = false;
  for (Eigen::Index i = 0, j = contour.rows() - 1; i < contour.rows(); j = i++) {
    const double yi = contour(i, 1), yj = contour(j, 1);
    if ((yi > y) != (yj > y) && x < contour(i, 0) + (y - yi) / (yj - yi) * (contour(j, 0) - contour(i, 0)))
      in = !in;
  }
  return in;
}

}  // namespace

// Whether a part's box has room for its name in a readable size.
bool SheetPreview::has_room(const Ui& ui, const DrawingText& text) const {
  const auto found = part_of_panel_.find(text.panel);
  if (found == part_of_panel_.end()) return false;
  const Box& box = boxes_[found->second];
  ImFont* font = ui.theme().small();
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, text.text.c_str());
  return (box.x1 - box.x0) * scale_ > 1.6 * static_cast<double>(size.x) &&
         (box.y1 - box.y0) * scale_ > 1.6 * static_cast<double>(size.y);
}

void SheetPreview::index(const Drawing& drawing, std::uint64_t number) {
  if (indexed_ && number == number_) return;
  indexed_ = true;
  number_ = number;
  boxes_.clear();
  parts_.clear();
  part_of_panel_.clear();
  for (std::size_t i = 0; i < drawing.lines.size(); ++i) {
    const DrawingLine& line = drawing.lines[i];
    const Eigen::RowVector2d low = line.points.colwise().minCoeff(), high = line.points.colwise().maxCoeff();
    boxes_.push_back({low(0), low(1), high(0), high(1)});
    if (line.layer != DrawingLayer::Cut || line.panel < 0 || !line.closed) continue;
    parts_.push_back({line.panel, i});
    part_of_panel_[line.panel] = i;
  }
  if (drawing.width != width_ || drawing.height != height_) fitted_ = true;
  width_ = drawing.width;
  height_ = drawing.height;
}

void SheetPreview::fit_to(const Drawing& drawing, ImVec2 min, ImVec2 max) {
  scale_ = fitting_scale(drawing, min, max);
  middle_x_ = 0.5 * drawing.width;
  middle_y_ = 0.5 * drawing.height;
}

ImVec2 SheetPreview::place(double x, double y) const {
  return {static_cast<float>(centre_.x + scale_ * (x - middle_x_)),
          static_cast<float>(centre_.y - scale_ * (y - middle_y_))};
}

std::optional<SheetPreview::Part> SheetPreview::part_at(const Drawing& drawing, ImVec2 at) const {
  const double x = middle_x_ + (at.x - centre_.x) / scale_, y = middle_y_ - (at.y - centre_.y) / scale_;
  for (const Part& part : parts_) {
    const Box& box = boxes_[part.line];
    if (x < box.x0 || x > box.x1 || y < box.y0 || y > box.y1) continue;
    if (inside(drawing.lines[part.line].points, x, y)) return part;
  }
  return std::nullopt;
}

SheetPreview::Pointed SheetPreview::draw(Ui& ui, const Drawing& drawing, std::uint64_t number,
                                         const std::vector<std::string>& names, const std::vector<bool>& pass,
                                         std::optional<int> selected, ImVec2 min, ImVec2 max) {
  index(drawing, number);
  centre_ = ImVec2(0.5f * (min.x + max.x), 0.5f * (min.y + max.y));
  if (fitted_) fit_to(drawing, min, max);

  // The mouse.
  ImGui::SetCursorScreenPos(min);
  ImGui::InvisibleButton("##preview", ImVec2(max.x - min.x, max.y - min.y));
  ui.record("preview", min, max);
  const ImGuiIO& io = ImGui::GetIO();
  const bool hovered = ImGui::IsItemHovered(), held = ImGui::IsItemActive();
  Pointed pointed;
  if (hovered) {
    ImGui::SetItemUsingMouseWheel();
    if (io.MouseWheel != 0) {
      const double before = scale_, most = kMostPixelsPerMm * ui.theme().scale();
      const double least = std::min(0.25 * fitting_scale(drawing, min, max), most);
      scale_ = std::clamp(before * std::pow(kWheel, static_cast<double>(io.MouseWheel)), least, most);
      // What the mouse points at stays where it is.
      const double x = io.MousePos.x - centre_.x, y = centre_.y - io.MousePos.y;
      middle_x_ += x / before - x / scale_;
      middle_y_ += y / before - y / scale_;
      fitted_ = false;
    }
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
      fitted_ = true;
      fit_to(drawing, min, max);
    }
  }
  if (ImGui::IsItemActivated()) moved_ = false;
  if (held) {
    const ImVec2 drag = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 0.0f);
    if (!moved_ && std::hypot(drag.x, drag.y) > ui.px(kSlop)) moved_ = true;
    if (moved_) {
      middle_x_ -= io.MouseDelta.x / scale_;
      middle_y_ += io.MouseDelta.y / scale_;
      fitted_ = false;
      ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
    }
  }
  const auto under = hovered && !moved_ ? part_at(drawing, io.MousePos) : std::nullopt;
  if (under) pointed.panel = under->panel;
  pointed.clicked = ImGui::IsItemDeactivated() && hovered && !moved_ && under.has_value();
  if (!held) moved_ = false;

  // The paper.
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(min, max, true);
  const ImVec2 paper_min = place(0, drawing.height), paper_max = place(drawing.width, 0);
  list.AddRectFilled(ImVec2(paper_min.x + ui.px(2), paper_min.y + ui.px(3)),
                     ImVec2(paper_max.x + ui.px(2), paper_max.y + ui.px(3)), ui.colours().shadow);
  list.AddRectFilled(paper_min, paper_max, kPaper);

  const double left = middle_x_ - 0.5 * (max.x - min.x) / scale_,
               right = middle_x_ + 0.5 * (max.x - min.x) / scale_,
               low = middle_y_ - 0.5 * (max.y - min.y) / scale_,
               high = middle_y_ + 0.5 * (max.y - min.y) / scale_;
  const auto in_sight = [&](const Box& box) {
    return box.x1 >= left && box.x0 <= right && box.y1 >= low && box.y0 <= high;
  };
  const auto run = [&](const Contour& points) {
    buffer_.clear();
    for (Eigen::Index k = 0; k < points.rows(); ++k) buffer_.push_back(place(points(k, 0), points(k, 1)));
    return static_cast<int>(buffer_.size());
  };

  // Parts that are pointed at, selected or fail.
  int recorded = 0;
  for (const Part& part : parts_) {
    const Box& box = boxes_[part.line];
    if (!in_sight(box)) continue;
    const auto panel = static_cast<std::size_t>(part.panel);
    const bool fails = panel < pass.size() && !pass[panel];
    const bool is_selected = selected == part.panel, is_pointed = under && under->line == part.line;
    for (const auto& [tints, tint] :
         {std::pair(fails, kFails), std::pair(is_selected, kSelected), std::pair(is_pointed, kPointed)}) {
      if (!tints) continue;
      const int count = run(drawing.lines[part.line].points);
      list.AddConvexPolyFilled(buffer_.data(), count, tint);
    }
    if (std::min(box.x1 - box.x0, box.y1 - box.y0) * scale_ < kSmallestPart || recorded == kRecorded ||
        panel >= names.size())
      continue;
    ++recorded;
    ui.record("part " + names[panel], place(box.x0, box.y1), place(box.x1, box.y0));
  }

  // Lines: engraved ones below, so that what is cut is seen.
  const float thin = std::max(1.0f, ui.px(1));
  for (const DrawingLayer layer : {DrawingLayer::Sheet, DrawingLayer::Engrave, DrawingLayer::Cut})
    for (std::size_t i = 0; i < drawing.lines.size(); ++i) {
      const DrawingLine& line = drawing.lines[i];
      if (line.layer != layer || !in_sight(boxes_[i])) continue;
      const Box& box = boxes_[i];
      const double smallest = layer == DrawingLayer::Engrave ? kSmallestMark : kSmallestLine;
      if (std::max(box.x1 - box.x0, box.y1 - box.y0) * scale_ < smallest) continue;
      const int count = run(line.points);
      list.AddPolyline(buffer_.data(), count, colour_of(layer), line.closed ? ImDrawFlags_Closed : 0, thin);
    }

  // Texts, as high as they are; names that would be too small are written readably where their part has room.
  ImFont* font = ui.theme().regular();
  const Capitals capitals = capitals_of(font);
  const float most = 2.0f * (max.y - min.y);  // larger ones fill the whole place
  const float readable = capitals.height * ui.theme().small()->FontSize;
  for (const DrawingText& text : drawing.texts) {
    const double height = text.height * scale_;
    const bool small = height < kSmallestText;
    if (height > most || (small && (!text.is_name || !has_room(ui, text)))) continue;
    const double reach = std::max(text.height, readable / scale_) * static_cast<double>(text.text.size());
    if (!in_sight({text.at.x() - reach, text.at.y() - reach, text.at.x() + reach, text.at.y() + reach}))
      continue;
    draw_turned(list, font, capitals, text.text, place(text.at.x(), text.at.y()),
                small ? readable : static_cast<float>(height),
                small ? 0.0f : static_cast<float>(-text.rotation),
                small ? kSmallName : colour_of(text.layer));
  }
  list.PopClipRect();

  if (under && hovered && !held) {
    const auto panel = static_cast<std::size_t>(under->panel);
    if (panel < names.size())
      ui.tooltip(names[panel] + (panel < pass.size() && !pass[panel] ? "  ·  fails the tolerances" : ""));
  }
  return pointed;
}

void draw_thumbnail(ImDrawList& draw, const Drawing& drawing, ImVec2 min, ImVec2 max) {
  draw.AddRectFilled(min, max, kPaper);
  const double sx = (max.x - min.x) / std::max(drawing.width, 1e-6),
               sy = (max.y - min.y) / std::max(drawing.height, 1e-6);
  static thread_local std::vector<ImVec2> points;
  for (const DrawingLine& line : drawing.lines) {
    if (line.layer != DrawingLayer::Cut) continue;
    points.clear();
    for (Eigen::Index k = 0; k < line.points.rows(); ++k)
      points.emplace_back(static_cast<float>(min.x + sx * line.points(k, 0)),
                          static_cast<float>(max.y - sy * line.points(k, 1)));
    draw.AddPolyline(points.data(), static_cast<int>(points.size()), with_alpha(kCut, 0.6f),
                     ImDrawFlags_Closed, 1.0f);
  }
}

}  // namespace planewright::ui
