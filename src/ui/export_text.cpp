#include "ui/export_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ui/format.h"

namespace planewright::ui {
namespace {

// What the core says to those who type commands.
constexpr std::array<std::pair<std::string_view, std::string_view>, 2> kWords{{
    {"Choose another folder, or allow them to be replaced (--overwrite)",
     "Choose another folder, or tick “Overwrite existing files”."},
    {"Give a thickness, or leave 3mf out", "Give the panels a thickness, or leave 3MF out."},
}};

}  // namespace

std::string stage_text(std::string_view stage) {
  if (stage == "measuring") return "Measuring the panels";
  if (stage == "thickening") return "Giving the panels their thickness";
  if (stage == "nesting") return "Laying parts on sheets";
  if (stage == "writing") return "Writing files";
  if (stage == "certifying") return "Reading back and checking";
  return "Beginning";
}

std::string outcome_line(const ExportOutcome& outcome) {
  const std::string files = format_count(static_cast<std::int64_t>(outcome.files.size()), "file", "files") +
                            ", " + format_bytes(outcome.bytes);
  if (outcome.certificate.pass()) return "Certified: " + files + ", every check passed";
  std::size_t checks = outcome.certificate.design.size();
  for (const FileCertificate& file : outcome.certificate.files) checks += file.checks.size();
  return "The certificate says no: " +
         format_count(static_cast<std::int64_t>(failed_checks(outcome.certificate).size())) + " of " +
         format_count(static_cast<std::int64_t>(checks)) + " checks fail";
}

std::vector<std::string> failed_checks(const Certificate& certificate) {
  std::vector<std::string> failed;
  for (const Check& check : certificate.design)
    if (!check.pass) failed.push_back("The panels: " + check.name + ": " + check.detail);
  for (const FileCertificate& file : certificate.files) {
    if (file.checks.empty()) failed.push_back(file.file + ": nothing was checked");
    for (const Check& check : file.checks)
      if (!check.pass) failed.push_back(file.file + ": " + check.name + ": " + check.detail);
  }
  return failed;
}

Error readable(Error error) {
  if (error.where.starts_with("--")) error.where.clear();
  if (error.what.starts_with("has files of these names")) error.what = "The folder " + error.what;
  for (const auto& [core, window] : kWords)
    if (error.remedy == core) error.remedy = window;
  return error;
}

std::string sheet_line(const ExportPreparation& made, int sheet) {
  const auto parts = [](std::size_t n) {
    return format_count(static_cast<std::int64_t>(n), "part", "parts");
  };
  if (!made.nesting) {
    const auto drawn = std::count_if(made.patterns.begin(), made.patterns.end(),
                                     [](const FlatPattern& pattern) { return !pattern.empty(); });
    return "All panels in rows, " + parts(static_cast<std::size_t>(drawn));
  }
  if (sheet < 0 || sheet >= static_cast<int>(made.nesting->sheets.size())) return "No part fits a sheet";
  const NestedSheet& shown = made.nesting->sheets[static_cast<std::size_t>(sheet)];
  return "Sheet " + format_count(sheet + 1) + " of " +
         format_count(static_cast<std::int64_t>(made.nesting->sheets.size())) + ", " +
         std::to_string(std::lround(100.0 * shown.filled)) + " % filled, " + parts(shown.parts.size());
}

std::string verdict_line(const ToleranceVerdicts& verdicts) {
  if (verdicts.failed == 0)
    return format_count(verdicts.passed, "panel keeps", "panels keep") + " the tolerances";
  return format_count(verdicts.failed) + " of " +
         format_count(verdicts.passed + verdicts.failed, "panel fails", "panels fail");
}

}  // namespace planewright::ui
