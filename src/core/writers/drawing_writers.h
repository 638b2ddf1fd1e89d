// Drawings as files: DXF, SVG, PDF. Each gives the bytes of a whole file; core/fabricate writes them.
//
// Our own text for DXF (no library of Debian's writes it under a licence that goes with Ipopt's, and well:
// dxflib is GPL; dime, which the certificate reads with, knows no $INSUNITS and nothing newer than R13),
// pugixml for SVG, cairo for PDF. Units in every file: mm, 1:1 in DXF and SVG. Numbers are written with the
// digits that keep them exactly (DXF, SVG), whatever the locale. Threads: pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/pattern/drawing.h"

namespace planewright {

// What every writer demands: finite numbers, lines of two points and more (closed: three), texts of some
// height. Refused, naming the drawing and the panel; only a fault of ours can make such a drawing.
// format_dxf() and format_svg() of one throw std::invalid_argument where a number is not finite.
Result<void> check_drawing(const Drawing& drawing);

enum class DxfVersion { R12, R2000 };

// ASCII. Header: $INSUNITS 4 (mm; in R12 too, where most programs read it all the same), $MEASUREMENT 1,
// $EXTMIN, $EXTMAX. Layers CUT (red), ENGRAVE (blue), TEXT (white/black), SHEET (grey), each declared.
// R12: POLYLINE, TEXT. R2000: LWPOLYLINE, TEXT, handles, owner records, an OBJECTS section, as AutoCAD
// demands. Texts outside ASCII are written as \U+XXXX. Names as TEXT on the layer TEXT, panel names apart
// from edge names by their layer: TEXT (names), TEXT_EDGES (edge names and notes).
std::string format_dxf(const Drawing& drawing, DxfVersion version);

// width and height in mm, viewBox in mm, y down as SVG has it; one group per layer (id and inkscape:label:
// the layer's name, inkscape:groupmode="layer"), inside it one group per panel (data-panel: its name). Names
// are <text>.
std::string format_svg(const WorkshopModel& model, const Drawing& drawing);

struct TitleBlock {
  std::string project, drawn_by, date, note;  // UTF-8, may be empty
};
struct PdfOptions {
  bool landscape = true;
  double page_width = 420.0, page_height = 297.0;  // mm (A3)
  TitleBlock title;
};
// On paper, mm, of capital letters. An edge name that would be smaller than the first is left out of its
// page, whose title block then says so in these words. A panel's name is always there, and at least as high
// as the second wherever its part has room for that round the name's place; what else a drawing says of a
// panel (a failure) is no smaller than the first.
inline constexpr double kLeastPdfText = 1.2, kLeastPdfName = 1.6;
inline constexpr std::string_view kPdfEdgeNamesLeftOut = "Edge names are left out at this scale";

// One page per drawing, each at the largest of the usual scales (1:1, 1:2, 1:5, 1:10, 1:20, 1:25, 1:50,
// 1:100, ...) that fits, the scale written, with a scale bar, title block and "page n of m". Text is text.
// Not compressed where cairo allows. The first page is an index: the sheets, their filling, parts that fit no
// sheet (notes). Fails where cairo does (Refused).
Result<std::string> format_pdf(const WorkshopModel& model, const std::vector<Drawing>& drawings,
                               const std::vector<std::string>& notes, const PdfOptions& options);
// The scale that a page gets: the n of 1:n.
double page_scale(const Drawing& drawing, const PdfOptions& options);

}  // namespace planewright
