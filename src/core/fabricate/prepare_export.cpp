// From panels to what the files will say: measures, verdicts, solids, patterns, sheets, drawings.
#include <algorithm>
#include <string>

#include "core/fabricate/export_run.h"
#include "core/fabricate/failure_marks.h"

namespace planewright {
namespace {

tl::unexpected<Error> stopped_error() {
  return fail(ErrorCode::Usage, "stopped before anything was written");
}

std::string sheet_title(const WorkshopModel& model, int sheet, int sheets) {
  return model.title + ", sheet " + std::to_string(sheet + 1) + " of " + std::to_string(sheets);
}

// "C-17, C-18 and 3 more"
std::string names_of(const WorkshopModel& model, const std::vector<int>& panels) {
  constexpr std::size_t kShown = 10;
  std::string text;
  for (std::size_t k = 0; k < std::min(kShown, panels.size()); ++k)
    text += (k > 0 ? ", " : "") + model.names[static_cast<std::size_t>(panels[k])];
  if (panels.size() > kShown) text += " and " + std::to_string(panels.size() - kShown) + " more";
  return text;
}

// Everything but the sheets themselves.
void add_remarks(ExportPreparation& made, const WorkshopModel& model) {
  made.remarks = model.warnings;
  if (made.solids)
    for (const ThicknessFinding& finding : made.solids->findings)
      made.remarks.push_back(describe(finding, model));
  std::vector<int> crossing;
  for (const PanelPassport& passport : made.passports)
    if (passport.crosses_itself) crossing.push_back(passport.panel);
  if (!crossing.empty())
    made.remarks.push_back("panels that cross themselves have no pattern: " + names_of(model, crossing));
  if (made.nesting && !made.nesting->unplaced.empty())
    made.remarks.push_back("panels that fit no sheet: " + names_of(model, made.nesting->unplaced));
}

void draw(ExportPreparation& made, const WorkshopModel& model, const ExportSettings& settings) {
  for (const FlatPattern& pattern : made.patterns)
    if (pattern.empty()) made.left_out.push_back(pattern.panel);
  if (made.nesting) {
    const int sheets = static_cast<int>(made.nesting->sheets.size());
    for (int sheet = 0; sheet < sheets; ++sheet) {
      made.drawings.push_back(sheet_drawing(model, made.patterns, *made.nesting, sheet, settings.labels));
      made.drawings.back().title = sheet_title(model, sheet, sheets);
    }
    made.left_out.insert(made.left_out.end(), made.nesting->unplaced.begin(), made.nesting->unplaced.end());
    std::sort(made.left_out.begin(), made.left_out.end());
  } else {
    constexpr double kBetweenParts = 20.0;  // mm
    made.drawings.push_back(row_drawing(model, made.patterns, kBetweenParts, settings.labels));
    made.drawings.back().title = model.title + ", all panels";
  }
  for (Drawing& drawing : made.drawings) mark_failures(drawing, made.verdicts);
}

}  // namespace

Result<ExportPreparation> prepare_export(const std::shared_ptr<const WorkshopModel>& model,
                                         const ExportSettings& settings, const ReferenceSurface* reference,
                                         const ExportProgress& progress, const std::stop_token& stop) {
  const auto tell = [&](std::string_view stage, double fraction) {
    if (progress) progress(stage, fraction);
  };
  tell("measuring", 0.0);
  ExportPreparation made;
  made.passports = make_passports(*model, {settings.thickness, settings.density, reference});
  made.verdicts = check_tolerances(*model, made.passports, settings.tolerances);
  if (stop.stop_requested()) return stopped_error();
  made.congruence = settings.congruence;
  made.congruence.bevels = settings.thickness > 0.0;
  made.classes = congruence_classes(*model, made.passports, made.congruence);
  if (stop.stop_requested()) return stopped_error();

  if (settings.thickness != 0.0) {
    tell("thickening", 0.0);
    auto solids = thicken(*model, {settings.thickness, settings.gap});
    if (!solids) return tl::unexpected(solids.error());
    made.solids = std::move(*solids);
  }
  made.patterns = flatten(*model, made.solids ? &*made.solids : nullptr, settings.gap);
  if (stop.stop_requested()) return stopped_error();

  if (settings.nesting) {
    auto nesting = nest(
        made.patterns, *settings.nesting,
        [&](int placed, int total) { tell("nesting", total > 0 ? double(placed) / total : 1.0); }, stop);
    if (!nesting) return tl::unexpected(nesting.error());
    if (nesting->stopped || stop.stop_requested()) return stopped_error();
    made.nesting = std::move(*nesting);
  }
  add_remarks(made, *model);
  draw(made, *model, settings);
  return made;
}

}  // namespace planewright
