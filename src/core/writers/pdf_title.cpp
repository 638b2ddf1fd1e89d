#include "core/writers/pdf_title.h"

#include <algorithm>

#include "core/writers/number_text.h"

namespace planewright {
namespace {

constexpr double kFrame = 0.35, kRule = 0.13, kPad = 2.5;
constexpr double kCaption = 1.3, kValue = 2.0;

void field(PdfPen& pen, const PageBox& cell, const char* caption, const std::string& value,
           bool bold = false) {
  pen.text(caption, cell.x + kPad, cell.y + 3.0, kCaption, kMiddleGrey);
  const double width = cell.width - 2.0 * kPad;
  pen.text(pen.fitted(value, width, kValue, bold), cell.x + kPad, cell.y + 7.3, kValue, kInk,
           TextAnchor::Left, bold);
}

// Four pieces, black and white, with the lengths at its ends.
void scale_bar(PdfPen& pen, const PageBox& cell, double scale) {
  constexpr int kPieces = 4;
  constexpr double kHeight = 1.2;
  const double length = scale_bar_length(scale, cell.width - 24.0), paper = length / scale;
  const double x = cell.x + kPad, y = cell.y + 4.0, piece = paper / kPieces;
  for (int k = 0; k < kPieces; k += 2) pen.fill({x + k * piece, y, piece, kHeight}, kInk);
  pen.frame({x, y, paper, kHeight}, kRule);
  pen.text("0", x, y - 1.0, kCaption, kMiddleGrey);
  pen.text(number_text(length) + " mm", x + paper, y - 1.0, kCaption, kMiddleGrey, TextAnchor::Right);
}

}  // namespace

std::string scale_text(double scale) {
  return "1:" + number_text(scale);
}

void draw_page_frame(PdfPen& pen, const PageLayout& layout, const TitleBlock& block,
                     const std::string& project, const PageTitle& title) {
  pen.frame(layout.frame, kFrame);
  const PageBox& box = layout.title;
  pen.frame(box, kFrame);
  const double right = box.x + box.width, half = box.x + box.width / 2.0;
  // Rows of the block, from above.
  const double names = box.y + 18.0, people = names + 10.0, numbers = people + 10.0;
  for (const double y : {names, people, numbers}) pen.line(box.x, y, right, y, kRule);
  pen.line(half, names, half, numbers, kRule);

  const double width = box.width - 2.0 * kPad;
  pen.text("PROJECT", box.x + kPad, box.y + 3.0, kCaption, kMiddleGrey);
  pen.text(pen.fitted(project, width, 3.0, true), box.x + kPad, box.y + 8.4, 3.0, kInk, TextAnchor::Left,
           true);
  pen.text(pen.fitted(title.title, width, kValue), box.x + kPad, box.y + 14.4, kValue, kInk);

  const double cell = box.width / 2.0;
  field(pen, {box.x, names, cell, 10.0}, "DRAWN BY", block.drawn_by);
  field(pen, {half, names, cell, 10.0}, "DATE", block.date);
  field(pen, {box.x, people, cell, 10.0}, "SCALE", title.scale > 0.0 ? scale_text(title.scale) : "\u2013",
        true);
  field(pen, {half, people, cell, 10.0}, "SHEET",
        "page " + std::to_string(title.page) + " of " + std::to_string(title.pages), true);
  const PageBox last{box.x, numbers + 1.0, box.width, 13.0};
  if (title.scale > 0.0)
    scale_bar(pen, last, title.scale);
  else
    pen.text("Planewright", box.x + kPad, numbers + 5.0, kCaption, kMiddleGrey);
  const std::string note = block.note.empty() ? "Dimensions in mm" : block.note;
  // What the page says of itself is never cut; the note has what that leaves.
  const double line = box.y + box.height - 2.6;
  double room = width;
  if (title.without_edge_names) {
    pen.text(kPdfEdgeNamesLeftOut, right - kPad, line, kCaption, kMiddleGrey, TextAnchor::Right);
    room -= pen.text_width(kPdfEdgeNamesLeftOut, kCaption) + 2.0 * kPad;
  }
  pen.text(pen.fitted(note, room, kCaption), box.x + kPad, line, kCaption, kMiddleGrey);
}

}  // namespace planewright
