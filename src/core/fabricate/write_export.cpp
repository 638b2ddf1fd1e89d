// Files made aside, read back, certified, and only then put in their place.
#include <algorithm>
#include <string>

#include "core/fabricate/earlier_export.h"
#include "core/fabricate/export_files.h"
#include "core/fabricate/export_run.h"
#include "core/fabricate/staged_folder.h"

namespace planewright {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kNamed = 5;  // of many

std::string listed(const std::vector<std::string>& all, const char* separator) {
  std::string text;
  for (std::size_t k = 0; k < std::min(kNamed, all.size()); ++k) text += (k > 0 ? separator : "") + all[k];
  if (all.size() > kNamed) text += separator + std::to_string(all.size() - kNamed) + " more";
  return text;
}

Result<void> check_settings(const ExportSettings& settings) {
  if (settings.formats.empty())
    return fail(ErrorCode::Usage, "no format is chosen", "--format", "Choose at least one");
  if (settings.formats.contains(ExportFormat::ThreeMf) && settings.thickness <= 0.0)
    return fail(ErrorCode::Usage, "3mf holds solids, and panels without thickness are none", "--format",
                "Give a thickness, or leave 3mf out");
  return {};
}

// What stands against these panels being built at all.
Result<void> check_panels(const WorkshopModel& model, const ExportPreparation& prepared,
                          const ExportSettings& settings) {
  if (prepared.nesting && prepared.nesting->sheets.empty()) {
    const SheetSize& sheet = prepared.nesting->sheet;
    return fail(ErrorCode::Refused,
                "no panel fits a sheet of " + std::to_string(static_cast<long>(sheet.width)) + " x " +
                    std::to_string(static_cast<long>(sheet.height)) + " mm",
                "--sheet", "Choose larger sheets, look at the model's unit, or export without sheets");
  }
  if (settings.on_failure == OnFailure::Mark) return {};
  std::vector<std::string> troubles;
  for (const ToleranceFailure& failure : prepared.verdicts.failures)
    troubles.push_back(describe(failure, model));
  for (const int panel : prepared.left_out)
    troubles.push_back(model.names[static_cast<std::size_t>(panel)] + " is on no drawing");
  if (troubles.empty()) return {};
  return fail(ErrorCode::Refused,
              std::to_string(prepared.verdicts.failed) + " of " + std::to_string(model.panel_count()) +
                  " panels fail, and nothing was written: " + listed(troubles, "; "),
              "", "Mend them, change the tolerances, or export with failing panels marked");
}

}  // namespace

Result<ExportOutcome> write_export(const std::shared_ptr<const WorkshopModel>& model,
                                   const ExportPreparation& prepared, const ExportSettings& settings,
                                   const fs::path& folder, const ExportProgress& progress,
                                   const std::stop_token& stop) {
  const auto tell = [&](std::string_view stage, double fraction) {
    if (progress) progress(stage, fraction);
  };
  if (auto checked = check_settings(settings); !checked) return tl::unexpected(checked.error());
  if (auto checked = check_panels(*model, prepared, settings); !checked)
    return tl::unexpected(checked.error());

  for (const Drawing& drawing : prepared.drawings)
    if (auto checked = check_drawing(drawing); !checked) return tl::unexpected(checked.error());

  const std::vector<PlannedFile> planned = plan_files(*model, prepared, settings);
  ExportOutcome outcome;
  outcome.folder = folder;
  for (const PlannedFile& plan : planned) outcome.files.push_back(plan.file.name);
  outcome.files.insert(outcome.files.end(), {kCertificateJson, kCertificatePage});

  std::vector<std::string> there;
  for (const std::string& name : outcome.files) {
    std::error_code ignored;
    if (fs::exists(folder / name, ignored)) there.push_back(name);
  }
  if (!there.empty() && !settings.overwrite)
    return fail(ErrorCode::Unwritable, "has files of these names: " + listed(there, ", "), folder.string(),
                "Choose another folder, or allow them to be replaced (--overwrite)");

  auto staged = StagedFolder::at(folder);
  if (!staged) return tl::unexpected(staged.error());
  std::vector<ExportedFile> files;
  for (const PlannedFile& plan : planned) {
    if (stop.stop_requested()) return fail(ErrorCode::Usage, "stopped before anything was written");
    tell("writing", double(files.size()) / double(planned.size()));
    const auto bytes = plan.bytes();
    if (!bytes) return tl::unexpected(bytes.error());
    if (auto written = staged->write(plan.file.name, *bytes); !written)
      return tl::unexpected(written.error());
    outcome.bytes += bytes->size();
    files.push_back(plan.file);
  }

  const ExportContent content{.model = model.get(),
                              .passports = &prepared.passports,
                              .verdicts = &prepared.verdicts,
                              .patterns = &prepared.patterns,
                              .solids = prepared.solids ? &*prepared.solids : nullptr,
                              .drawings = prepared.drawings,
                              .left_out = prepared.left_out,
                              .pdf = settings.pdf,
                              .classes = &prepared.classes,
                              .congruence = prepared.congruence,
                              .nesting = prepared.nesting ? settings.nesting : std::nullopt};
  outcome.certificate = certify(
      staged->path(), files, content,
      [&](int done, int total) { tell("certifying", total > 0 ? double(done) / total : 1.0); }, stop);
  if (stop.stop_requested()) return fail(ErrorCode::Usage, "stopped before anything was written");
  for (const auto& [name, text] :
       {std::pair{kCertificateJson, to_json(outcome.certificate, content)},
        std::pair{kCertificatePage, certificate_page(outcome.certificate, content)}}) {
    if (auto written = staged->write(name, text); !written) return tl::unexpected(written.error());
    outcome.bytes += text.size();
  }

  std::vector<std::string> stale;
  if (settings.overwrite) {
    stale = files_of_earlier_export(folder);
    std::erase_if(stale, [&](const std::string& name) {
      return std::find(outcome.files.begin(), outcome.files.end(), name) != outcome.files.end();
    });
  }
  if (auto published = staged->publish(outcome.files, stale); !published)
    return tl::unexpected(published.error());
  return outcome;
}

}  // namespace planewright
