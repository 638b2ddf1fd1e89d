#include <algorithm>

#include "core/writers/clean_text.h"
#include "core/writers/number_text.h"
#include "core/writers/pdf_sheet.h"
#include "core/writers/pdf_title.h"

namespace planewright {
namespace {

constexpr double kRow = 5.0, kText = 1.9, kHeading = 2.8, kInset = 6.0;
constexpr double kTableWidth = 250.0;

}  // namespace

std::vector<std::string> wrapped(PdfPen& pen, const std::string& text, double width, double height) {
  std::vector<std::string> lines;
  std::string line;
  const std::string clean = clean_text(text);
  for (size_t at = 0; at < clean.size();) {
    const size_t end = std::min(clean.find(' ', at), clean.size());
    const std::string word = clean.substr(at, end - at);
    at = end + 1;
    if (word.empty()) continue;
    const std::string longer = line.empty() ? word : line + ' ' + word;
    if (line.empty() || pen.text_width(longer, height) <= width) {
      line = longer;
    } else {
      lines.push_back(pen.fitted(line, width, height));
      line = word;
    }
  }
  if (!line.empty()) lines.push_back(pen.fitted(line, width, height));
  return lines;
}

IndexPages::IndexPages(PdfPen& pen, const PageLayout& layout, std::vector<IndexRow> rows,
                       const std::vector<std::string>& notes)
    : pen_(pen), area_(layout.beside), rows_(std::move(rows)) {
  area_.x += kInset;
  area_.y += kInset;
  area_.width = std::min(area_.width - 2.0 * kInset, kTableWidth);
  area_.height -= 2.0 * kInset;
  using Kind = Line::Kind;
  std::vector<Line> lines{{Kind::Heading, -1, "Sheets"}};
  if (rows_.empty()) {
    lines.push_back({Kind::Note, -1, "No sheets."});
  } else {
    lines.push_back({Kind::TableHead, -1, ""});
    for (int k = 0; k < static_cast<int>(rows_.size()); ++k) lines.push_back({Kind::Row, k, ""});
  }
  if (!notes.empty()) {
    lines.push_back({Kind::Space, -1, ""});
    lines.push_back({Kind::Heading, -1, "Notes"});
    for (const std::string& note : notes)
      for (std::string& line : wrapped(pen_, note, area_.width, kText))
        lines.push_back({Kind::Note, -1, std::move(line)});
  }
  break_pages(lines);
}

void IndexPages::break_pages(const std::vector<Line>& lines) {
  using Kind = Line::Kind;
  const auto fit = static_cast<size_t>(std::max(area_.height / kRow, 3.0));
  pages_.emplace_back();
  for (const Line& line : lines) {
    if (pages_.back().size() >= fit) {
      pages_.emplace_back();
      // A table that goes on says again what its columns are.
      if (line.kind == Kind::Row) pages_.back().push_back({Kind::TableHead, -1, ""});
    }
    pages_.back().push_back(line);
  }
}

void IndexPages::draw(int page) const {
  double y = area_.y;
  for (const Line& line : pages_.at(page)) {
    draw_line(line, y);
    y += kRow;
  }
}

void IndexPages::draw_line(const Line& line, double y) const {
  using Kind = Line::Kind;
  const double base = y + 3.4, right = area_.x + area_.width;
  // Right ends of the columns of numbers, from the left.
  const double w = area_.width, x = area_.x;
  const double size = x + 0.62 * w, parts = x + 0.74 * w, filled = x + 0.87 * w;
  const double title_width = 0.33 * w;
  switch (line.kind) {
    case Kind::Heading:
      pen_.text(line.text, x, base, kHeading, kInk, TextAnchor::Left, true);
      break;
    case Kind::Note:
      pen_.text(line.text, x, base, kText);
      break;
    case Kind::Space:
      break;
    case Kind::TableHead: {
      constexpr double kCaption = 1.4;
      pen_.text("PAGE", x, base, kCaption, kMiddleGrey);
      pen_.text("SHEET", x + 0.08 * w, base, kCaption, kMiddleGrey);
      pen_.text("SIZE, MM", size, base, kCaption, kMiddleGrey, TextAnchor::Right);
      pen_.text("PARTS", parts, base, kCaption, kMiddleGrey, TextAnchor::Right);
      pen_.text("FILLED, %", filled, base, kCaption, kMiddleGrey, TextAnchor::Right);
      pen_.text("SCALE", right, base, kCaption, kMiddleGrey, TextAnchor::Right);
      pen_.line(x, y + kRow - 0.2, right, y + kRow - 0.2, 0.25);
      break;
    }
    case Kind::Row: {
      const IndexRow& row = rows_[line.row];
      if (line.row % 2 == 1) pen_.fill({x, y - 0.1, w, kRow}, kWash);
      pen_.text(std::to_string(row.page), x, base, kText);
      pen_.text(pen_.fitted(row.title, title_width, kText), x + 0.08 * w, base, kText);
      pen_.text(rounded_text(row.width, 0) + " \u00d7 " + rounded_text(row.height, 0), size, base, kText,
                kInk, TextAnchor::Right);
      pen_.text(std::to_string(row.parts), parts, base, kText, kInk, TextAnchor::Right);
      pen_.text(rounded_text(100.0 * row.filled, 1), filled, base, kText, kInk, TextAnchor::Right);
      pen_.text(scale_text(row.scale), right, base, kText, kInk, TextAnchor::Right);
      break;
    }
  }
}

}  // namespace planewright
