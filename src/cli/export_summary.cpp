#include "cli/export_summary.h"

#include <algorithm>
#include <cstdio>

namespace planewright::cli {
namespace {

constexpr std::size_t kShown = 10;  // of many lines of one kind

void print_first(const std::vector<std::string>& lines, const char* of_what) {
  for (std::size_t k = 0; k < std::min(kShown, lines.size()); ++k)
    std::fprintf(stderr, "planewright-cli: note: %s\n", lines[k].c_str());
  if (lines.size() > kShown)
    std::fprintf(stderr, "planewright-cli: note: and %zu more %s\n", lines.size() - kShown, of_what);
}

void print_failed_checks(const Certificate& certificate) {
  std::vector<std::string> failed;
  for (const Check& check : certificate.design)
    if (!check.pass) failed.push_back("the panels: " + check.name + ": " + check.detail);
  for (const FileCertificate& file : certificate.files)
    for (const Check& check : file.checks)
      if (!check.pass) failed.push_back(file.file + ": " + check.name + ": " + check.detail);
  print_first(failed, "checks that fail");
}

double total_area(const std::vector<PanelPassport>& passports) {
  double area = 0.0;
  for (const PanelPassport& passport : passports) area += passport.area;
  return area * 1e-6;  // m2
}

}  // namespace

void print_export(const WorkshopModel& model, const ExportPreparation& prepared,
                  const ExportOutcome& outcome) {
  std::vector<std::string> failures;
  for (const ToleranceFailure& failure : prepared.verdicts.failures)
    failures.push_back(describe(failure, model));
  print_first(failures, "failures");
  print_first(prepared.remarks, "remarks");
  print_failed_checks(outcome.certificate);

  std::printf("panels     %d, %.3f m2, %zu classes of congruent ones\n", model.panel_count(),
              total_area(prepared.passports), prepared.classes.size());
  std::printf("tolerances %d pass, %d fail\n", prepared.verdicts.passed, prepared.verdicts.failed);
  if (prepared.nesting)
    std::printf("sheets     %zu of %g x %g mm, %.1f %% filled, %zu parts fit none\n",
                prepared.nesting->sheets.size(), prepared.nesting->sheet.width,
                prepared.nesting->sheet.height, 100.0 * prepared.nesting->filled,
                prepared.nesting->unplaced.size());
  std::printf("certified  %s\n",
              outcome.certificate.pass() ? "all files read back as they should" : "NO: see certificate.html");
  std::printf("wrote      %zu files, %.1f MB, to %s\n", outcome.files.size(),
              static_cast<double>(outcome.bytes) * 1e-6, outcome.folder.string().c_str());
}

}  // namespace planewright::cli
