#include "core/fabricate/export_files.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include "core/writers/schedule_writers.h"
#include "core/writers/solid_writers.h"

namespace planewright {
namespace {

// "sheets/sheet-03.dxf", as many digits as the last one needs; without sheets "parts.dxf".
std::string drawing_name(const ExportPreparation& prepared, int drawing, const char* ending) {
  if (!prepared.nesting) return std::string("parts.") + ending;
  const int sheets = static_cast<int>(prepared.drawings.size());
  const int digits = std::max(2, static_cast<int>(std::to_string(sheets).size()));
  std::string number = std::to_string(drawing + 1);
  number.insert(0, static_cast<std::size_t>(digits) - number.size(), '0');
  return "sheets/sheet-" + number + "." + ending;
}

struct MeshFile {
  ExportFormat format;
  SolidFormat as;
  const char* ending;
};
constexpr MeshFile kMeshFiles[] = {{ExportFormat::Obj, SolidFormat::Obj, "obj"},
                                   {ExportFormat::Ply, SolidFormat::Ply, "ply"},
                                   {ExportFormat::Stl, SolidFormat::Stl, "stl"},
                                   {ExportFormat::ThreeMf, SolidFormat::ThreeMf, "3mf"},
                                   {ExportFormat::Gltf, SolidFormat::Gltf, "glb"}};

// What the first page of the PDF says besides the sheets.
std::vector<std::string> index_notes(const WorkshopModel& model, const ExportPreparation& prepared) {
  std::vector<std::string> notes;
  notes.push_back(std::to_string(prepared.verdicts.passed) + " of " + std::to_string(model.panel_count()) +
                  " panels pass the tolerances");
  if (prepared.nesting) {
    char filled[32];
    std::snprintf(filled, sizeof filled, "%.1f", 100.0 * prepared.nesting->filled);
    notes.push_back(std::to_string(prepared.nesting->sheets.size()) + " sheets, filled " + filled +
                    " per cent");
  }
  notes.insert(notes.end(), prepared.remarks.begin(), prepared.remarks.end());
  return notes;
}

}  // namespace

std::vector<PlannedFile> plan_files(const WorkshopModel& model, const ExportPreparation& prepared,
                                    const ExportSettings& settings) {
  std::vector<PlannedFile> files;
  const auto wants = [&](ExportFormat format) { return settings.formats.contains(format); };
  const ScheduleSources sources{.model = &model,
                                .passports = &prepared.passports,
                                .verdicts = &prepared.verdicts,
                                .classes = &prepared.classes,
                                .patterns = &prepared.patterns,
                                .nesting = prepared.nesting ? &*prepared.nesting : nullptr,
                                .solids = prepared.solids ? &*prepared.solids : nullptr,
                                .thickness = settings.thickness,
                                .gap = settings.gap};

  for (int k = 0; k < static_cast<int>(prepared.drawings.size()); ++k) {
    const Drawing& drawing = prepared.drawings[static_cast<std::size_t>(k)];
    if (wants(ExportFormat::Dxf))
      files.push_back({{drawing_name(prepared, k, "dxf"), FileKind::SheetDxf, k},
                       [&drawing, version = settings.dxf]() -> Result<std::string> {
                         return format_dxf(drawing, version);
                       }});
    if (wants(ExportFormat::Svg))
      files.push_back({{drawing_name(prepared, k, "svg"), FileKind::SheetSvg, k},
                       [&drawing, &model]() -> Result<std::string> { return format_svg(model, drawing); }});
  }
  if (wants(ExportFormat::Pdf))
    files.push_back({{"sheets.pdf", FileKind::SheetsPdf, -1}, [&, notes = index_notes(model, prepared)] {
                       return format_pdf(model, prepared.drawings, notes, settings.pdf);
                     }});
  if (wants(ExportFormat::Csv)) {
    files.push_back({{"panels.csv", FileKind::PanelCsv, -1},
                     [sources]() -> Result<std::string> { return format_panel_csv(sources); }});
    files.push_back({{"edges.csv", FileKind::EdgeCsv, -1},
                     [sources]() -> Result<std::string> { return format_edge_csv(sources); }});
  }
  if (wants(ExportFormat::Json))
    files.push_back({{"schedule.json", FileKind::ScheduleJson, -1},
                     [sources]() -> Result<std::string> { return format_schedule_json(sources); }});
  for (const MeshFile& mesh : kMeshFiles) {
    if (!wants(mesh.format)) continue;
    if (mesh.format != ExportFormat::ThreeMf)
      files.push_back({{std::string("panels.") + mesh.ending, FileKind::PanelMesh, -1},
                       [&model, as = mesh.as] { return format_panels(model, as); }});
    if (prepared.solids)
      files.push_back({{std::string("solids.") + mesh.ending, FileKind::SolidMesh, -1},
                       [&, as = mesh.as] { return format_solids(model, *prepared.solids, as); }});
  }
  return files;
}

}  // namespace planewright
