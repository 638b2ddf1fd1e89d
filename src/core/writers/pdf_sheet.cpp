#include "core/writers/pdf_sheet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace planewright {
namespace {

struct LineStyle {
  double width;
  Grey grey;
};
LineStyle style_of(DrawingLayer layer) {
  switch (layer) {
    case DrawingLayer::Cut:
      return {0.25, kInk};
    case DrawingLayer::Engrave:
      return {0.13, kMiddleGrey};
    case DrawingLayer::Sheet:
      return {0.18, kPaleGrey};
    case DrawingLayer::Text:
      break;
  }
  return {0.13, kMiddleGrey};
}

// A name smaller than this on paper is written larger, as far as its part has room, mm.
constexpr double kLegible = 1.8;
// How much of its part's smaller side a larger name may take up, across and along.
constexpr double kPartHeight = 0.22, kPartWidth = 0.6;
static_assert(kLegible >= kLeastPdfName && kLeastPdfName >= kLeastPdfText);

// The contours of a part that are cut.
struct Part {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(1e300), high = Eigen::Vector2d::Constant(-1e300);
  std::vector<const Contour*> cut;
  void add(const Contour& points) {
    low = low.cwiseMin(points.colwise().minCoeff().transpose());
    high = high.cwiseMax(points.colwise().maxCoeff().transpose());
    cut.push_back(&points);
  }
  Eigen::Vector2d size() const { return high - low; }
  // How far the nearest contour is from a place inside.
  double room_at(const Eigen::Vector2d& at) const {
    double room = std::numeric_limits<double>::infinity();
    for (const Contour* contour : cut)
      for (Eigen::Index i = 0, n = contour->rows(); i < n; ++i) {
        const Eigen::Vector2d a = contour->row(i), along = Eigen::Vector2d(contour->row((i + 1) % n)) - a;
        const double length = along.squaredNorm();
        const double t = length > 0.0 ? std::clamp((at - a).dot(along) / length, 0.0, 1.0) : 0.0;
        room = std::min(room, (at - a - t * along).norm());
      }
    return room;
  }
};

// By how much a name's height grows on paper: as a share of its part allows, or as it has room where it is.
double enlarged(PdfPen& pen, const DrawingText& text, const Part& part, double scale) {
  const double height = text.height / scale;
  if (height >= kLegible) return 1.0;
  const double size = part.size().minCoeff() / scale, room = part.room_at(text.at) / scale;
  const double per_height = std::max(pen.text_width(text.text, 1.0, true), 1e-9);
  const double limit = std::max(std::min(kPartHeight * size, kPartWidth * size / per_height),
                                room / (0.5 * std::hypot(per_height, 1.0)));
  return std::max(1.0, std::min(kLegible, limit) / height);
}

// A text that is the name of another panel.
bool is_edge_name(const PanelNames& names, const DrawingText& text) {
  return !text.is_name && text.panel >= 0 && names.contains(text.text);
}
bool is_left_out(const PanelNames& names, const DrawingText& text, double scale) {
  return text.height / scale < kLeastPdfText && is_edge_name(names, text);
}

struct Enlargement {
  Eigen::Vector2d about;
  double reach, factor;  // mm of the drawing
};

// Strokes that stand with a name (its up mark, its engraved letters) grow with it; contours never do.
bool goes_with(const DrawingLine& line, const Enlargement& name) {
  if (line.layer != DrawingLayer::Engrave || line.closed) return false;
  return (line.points.rowwise() - name.about.transpose()).rowwise().norm().maxCoeff() <= name.reach;
}

Eigen::Vector2d to_page(const Eigen::Vector2d& p, const Drawing& drawing, const PlacedDrawing& placed) {
  const double n = placed.scale;
  return {placed.area.x + (placed.area.width - drawing.width / n) / 2.0 + p.x() / n,
          placed.area.y + (placed.area.height - drawing.height / n) / 2.0 + (drawing.height - p.y()) / n};
}

}  // namespace

bool leaves_out_edge_names(const PanelNames& panel_names, const Drawing& drawing,
                           const PlacedDrawing& placed) {
  return std::any_of(drawing.texts.begin(), drawing.texts.end(),
                     [&](const DrawingText& text) { return is_left_out(panel_names, text, placed.scale); });
}

void draw_sheet(PdfPen& pen, const PanelNames& panel_names, const Drawing& drawing,
                const PlacedDrawing& placed) {
  std::map<int, Part> parts;
  for (const DrawingLine& line : drawing.lines)
    if (line.layer == DrawingLayer::Cut) parts[line.panel].add(line.points);
  std::map<int, Enlargement> names;
  for (const DrawingText& text : drawing.texts) {
    const auto part = parts.find(text.panel);
    if (!text.is_name || part == parts.end()) continue;
    const double reach = text.height * (2.5 + 0.7 * static_cast<double>(text.text.size()));
    names.try_emplace(text.panel,
                      Enlargement{text.at, reach, enlarged(pen, text, part->second, placed.scale)});
  }
  const auto draw_line = [&](const DrawingLine& line) {
    const auto name = names.find(line.panel);
    const bool grows = name != names.end() && name->second.factor > 1.0 && goes_with(line, name->second);
    Contour points(line.points.rows(), 2);
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      Eigen::Vector2d p = line.points.row(i);
      if (grows) p = name->second.about + name->second.factor * (p - name->second.about);
      points.row(i) = to_page(p, drawing, placed);
    }
    const LineStyle style = style_of(line.layer);
    pen.polyline(points, line.closed, style.width, style.grey);
  };
  const auto draw_text = [&](const DrawingText& text) {
    // A name grows, and what stands with it does; names along sides do not.
    const auto name = names.find(text.panel);
    const bool grows = name != names.end() && !is_edge_name(panel_names, text);
    const double factor = grows ? name->second.factor : 1.0;
    const Eigen::Vector2d about = grows ? name->second.about : text.at;
    const Eigen::Vector2d at = to_page(about + factor * (text.at - about), drawing, placed);
    const double height = text.height / placed.scale * factor;
    pen.text_about(text.text, at.x(), at.y(), text.is_name ? height : std::max(height, kLeastPdfText),
                   text.rotation, text.is_name ? kInk : kMiddleGrey, text.is_name);
  };
  // Texts after the lines of their part: cairo makes one text of two on the same line that nothing parts.
  std::map<int, std::vector<const DrawingText*>> texts;
  for (const DrawingText& text : drawing.texts)
    if (!is_left_out(panel_names, text, placed.scale)) texts[text.panel].push_back(&text);
  const auto draw_texts = [&](int panel) {
    for (const DrawingText* text : texts[panel]) draw_text(*text);
    texts.erase(panel);
  };
  std::map<int, int> lines_left;
  for (const DrawingLine& line : drawing.lines) ++lines_left[line.panel];
  for (const DrawingLine& line : drawing.lines) {
    draw_line(line);
    if (--lines_left[line.panel] == 0) draw_texts(line.panel);
  }
  while (!texts.empty()) draw_texts(texts.begin()->first);
}

IndexRow index_row(const Drawing& drawing, int page, double scale) {
  std::map<int, double> areas;
  for (const DrawingLine& line : drawing.lines) {
    if (line.layer != DrawingLayer::Cut || !line.closed) continue;
    double twice = 0.0;
    for (Eigen::Index i = 0, n = line.points.rows(); i < n; ++i) {
      const auto a = line.points.row(i), b = line.points.row((i + 1) % n);
      twice += a.x() * b.y() - a.y() * b.x();
    }
    areas[line.panel] = std::max(areas[line.panel], std::abs(twice) / 2.0);
  }
  double sum = 0.0;
  for (const auto& [panel, area] : areas) sum += area;
  const double whole = drawing.width * drawing.height;
  return {page,
          drawing.title,
          drawing.width,
          drawing.height,
          static_cast<int>(areas.size()),
          whole > 0.0 ? sum / whole : 0.0,
          scale};
}

}  // namespace planewright
