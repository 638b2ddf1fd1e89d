// One export: panels in, a folder of files for the workshop out, certified, whole or not at all.
//
// All files are made in a folder beside the target, read back and certified there, and take their place only
// then; whatever goes wrong before (disk full, refused, stopped) leaves neither target nor trace. Threads:
// one run per thread; the window runs it on a worker.
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/certify/certificate.h"
#include "core/pattern/nesting.h"
#include "core/workshop/congruence.h"
#include "core/workshop/tolerance_sheet.h"
#include "core/workshop/workshop_model.h"
#include "core/writers/drawing_writers.h"

namespace planewright {

enum class ExportFormat { Dxf, Svg, Pdf, Csv, Json, Obj, Ply, Stl, ThreeMf, Gltf };
const std::vector<ExportFormat>& export_formats();
std::string_view name_of(ExportFormat format);  // "dxf", ..., "3mf", "gltf"
Result<std::set<ExportFormat>> parse_export_formats(const std::vector<std::string>& names, std::string where);

enum class OnFailure {
  Refuse,  // nothing is written if a panel fails the tolerances or cannot be made
  Mark,    // all is written; failing panels are marked in drawings, schedules and certificate
};

struct ExportSettings {
  std::set<ExportFormat> formats;
  ToleranceSheet tolerances;
  OnFailure on_failure = OnFailure::Mark;
  double thickness = 0.0, gap = 0.0;  // mm
  double density = 0.0;               // kg/m^3
  CongruenceOptions congruence;
  std::optional<NestingOptions> nesting;  // absent: all parts in rows, no sheets
  LabelOptions labels;
  DxfVersion dxf = DxfVersion::R2000;
  PdfOptions pdf;
  bool overwrite = false;  // files of the target folder that have the names of ours
};

// What there is to write, before any file is: what the window previews.
struct ExportPreparation {
  std::vector<PanelPassport> passports;
  ToleranceVerdicts verdicts;
  std::vector<CongruenceClass> classes;
  CongruenceOptions congruence;  // that they were made with
  std::optional<ThickPanels> solids;
  std::vector<FlatPattern> patterns;
  std::optional<Nesting> nesting;
  std::vector<Drawing> drawings;
  std::vector<int> left_out;  // panels that no drawing shows
  std::vector<std::string>
      remarks;  // blunted corners, parts that fit no sheet, ..., each a line, panels by name
};

// stage: "nesting", "writing", "certifying"; fraction 0..1.
using ExportProgress = std::function<void(std::string_view stage, double fraction)>;

// Fails as thicken() and nest() do; ErrorCode::Usage: stopped.
Result<ExportPreparation> prepare_export(const std::shared_ptr<const WorkshopModel>& model,
                                         const ExportSettings& settings, const ReferenceSurface* reference,
                                         const ExportProgress& progress = {},
                                         const std::stop_token& stop = {});

struct ExportOutcome {
  std::filesystem::path folder;
  std::vector<std::string> files;  // below it, certificate included
  std::uintmax_t bytes = 0;
  Certificate certificate;
};

// Refused: a panel that fails, with OnFailure::Refuse (the first are named); a stock sheet that every panel
// is too big for. Unwritable: the folder cannot be made, files of our names are there and `overwrite` is off
// (they are named), the disk is full. Usage: no formats; thickness needed (3mf) but 0; stopped.
Result<ExportOutcome> write_export(const std::shared_ptr<const WorkshopModel>& model,
                                   const ExportPreparation& prepared, const ExportSettings& settings,
                                   const std::filesystem::path& folder, const ExportProgress& progress = {},
                                   const std::stop_token& stop = {});

}  // namespace planewright
