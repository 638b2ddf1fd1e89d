// Certificate: the files of an export read back by readers that share no code with the writers, and compared
// with what they should say. Where a sign decides (an outline crosses itself, which way round a contour runs,
// a solid is closed and its volume positive) it is decided by exact predicates, not by rounding.
//
// Readers: DXF by dime and, because dime keeps coordinates in single precision, by group codes of our own
// that dime has to agree with; SVG by libxml2, PDF by qpdf (its content streams), OBJ by tinyobjloader, PLY
// and CSV by readers of our own, JSON by nlohmann, 3MF by minizip and libxml2, STL and glTF by assimp (single
// precision). Units: mm. Threads: pure.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/pattern/drawing.h"
#include "core/pattern/nesting.h"
#include "core/workshop/congruence.h"
#include "core/workshop/panel_passport.h"
#include "core/workshop/tolerance_sheet.h"
#include "core/workshop/workshop_model.h"
#include "core/writers/drawing_writers.h"

namespace planewright {

enum class FileKind {
  SheetDxf,
  SheetSvg,   // one nested sheet (or all parts in rows), content: `drawing`
  SheetsPdf,  // all of them
  PanelCsv,
  EdgeCsv,
  ScheduleJson,
  PanelMesh,  // OBJ, PLY, STL, glTF by the ending: the panels as a surface
  SolidMesh,  // OBJ, PLY, STL, 3MF, glTF: the thick panels
};

struct ExportedFile {
  std::string name;  // below the folder, "sheets/sheet-03.dxf"
  FileKind kind;
  int drawing = -1;  // which of ExportContent::drawings; -1: none, or all
};

// What the files should say.
struct ExportContent {
  const WorkshopModel* model;
  const std::vector<PanelPassport>* passports;
  const ToleranceVerdicts* verdicts;
  const std::vector<FlatPattern>* patterns;  // may be null
  const ThickPanels* solids;                 // may be null
  std::vector<Drawing> drawings;             // sheets or rows, in order
  std::vector<int> left_out;  // panels that no drawing shows (crossing themselves, no sheet fits), ascending
  PdfOptions pdf;
  const std::vector<CongruenceClass>* classes = nullptr;  // may be null: none are told
  CongruenceOptions congruence = {};                      // that they were made with
  std::optional<NestingOptions> nesting =
      {};  // that drawings were laid with, as sheets; absent: rows, no sheets
};

struct Check {
  std::string name;  // "scale", "every name once", "closed", ...
  bool pass = false;
  std::string detail;  // "1,053 of 1,053 names", "largest difference 2.3e-11 mm (limit 1e-6)"
};
struct FileCertificate {
  std::string file, reader;  // "dime 0.2011", ...
  std::vector<Check> checks;
  bool pass() const;  // and that there is a check
};
struct Certificate {
  std::vector<Check>
      design;  // of the document itself: planarity per panel, simple polygons, equal lengths of shared edges,
               // areas of patterns and panels, classes of congruent panels, parts on the drawings (each once,
               // as its pattern, apart from others, inside the margins), closed solids, penetrating solids
  // In the order asked for; after them "all DXF files together", "all SVG files together": parts and names.
  std::vector<FileCertificate> files;
  bool pass() const;
};

// Reads every file below `folder`. A file that cannot be read is a check that fails, no error. progress(done,
// total) may be null. Stopped between two files it lacks the rest, and is good for nothing.
Certificate certify(const std::filesystem::path& folder, const std::vector<ExportedFile>& files,
                    const ExportContent& content, const std::function<void(int, int)>& progress = {},
                    const std::stop_token& stop = {});

// With "pass", tool, version, and every check. The page: one HTML file that needs nothing else, prints well.
std::string to_json(const Certificate& certificate, const ExportContent& content);
std::string certificate_page(const Certificate& certificate, const ExportContent& content);

}  // namespace planewright
