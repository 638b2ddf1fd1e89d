// ExportChoice: what the designer chose in the export dialog. What the panels are made to (thickness, gap,
// density, tolerances) is the document's contract, not this.
//
// Units: mm. Threads: plain values.
#pragma once

#include <array>
#include <set>
#include <string>

#include "core/fabricate/export_run.h"
#include "core/workshop/contract.h"

namespace planewright::ui {

// What decides where which part is drawn: a change of it lays all parts anew.
struct ExportLayout {
  bool sheets = true;  // else all parts in rows, without sheets
  SheetSize sheet{3210.0, 6000.0};
  double spacing = 10.0;  // between parts
  double margin = 10.0;   // along the sheet's border
  bool rotate = true;     // parts may be turned
  double text_height = 12.0;
  bool edge_names = true;
  bool engrave_names = false;
  bool operator==(const ExportLayout&) const = default;
};

// Of the PDF, upright or not, whichever shows the sheets larger.
enum class PageSize { A4, A3, A2, A1 };
struct PageMeasure {
  const char* name;
  double shorter, longer;
};
inline constexpr std::array<PageMeasure, 4> kPages{
    {{"A4", 210, 297}, {"A3", 297, 420}, {"A2", 420, 594}, {"A1", 594, 841}}};

struct ExportChoice {
  std::set<ExportFormat> formats{ExportFormat::Dxf, ExportFormat::Pdf, ExportFormat::Csv};
  DxfVersion dxf = DxfVersion::R2000;
  ExportLayout layout;
  PageSize page = PageSize::A3;
  std::string project, drawn_by, note;  // in the title block; an empty project: the design's title
  OnFailure on_failure = OnFailure::Mark;
  bool operator==(const ExportChoice&) const = default;
};

// A format that is chosen but cannot be made of panels like these: 3mf of panels without thickness.
bool lacks_thickness(ExportFormat format, const WorkshopContract& contract);

// What the core is to be told. Formats that lack a thickness are left out. `date` goes into the title block.
ExportSettings export_settings(const ExportChoice& choice, const WorkshopContract& contract,
                               const std::string& title, const std::string& date, bool overwrite);

// Of the machine's calendar: "2026-11-26".
std::string today();

}  // namespace planewright::ui
