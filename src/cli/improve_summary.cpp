#include "cli/improve_summary.h"

#include <algorithm>
#include <cstdio>

namespace planewright::cli {
namespace {

constexpr size_t kEditsShown = 20, kLeftShown = 20;

void print_row(const char* what, int before, int after) {
  std::printf("  %-26s %10d %10d\n", what, before, after);
}
void print_row(const char* what, double before, double after) {
  std::printf("  %-26s %10.2f %10.2f\n", what, before, after);
}

// The best of what was tried, and how much that was.
void print_left(const ImproveReport::Left& left) {
  const auto tried = std::count_if(left.tried.begin(), left.tried.end(),
                                   [](const ImproveReport::Tried& each) { return each.gain.has_value(); });
  const auto refused = static_cast<std::ptrdiff_t>(left.tried.size()) - tried;
  std::printf("  %s at %s, %.3g %s, angle defect %.1f degrees: ", info(left.finding.kind).title,
              text(left.finding.element).c_str(), left.finding.measure, left.finding.unit.c_str(),
              left.angle_defect);
  if (tried > 0)
    std::printf("%td edits tried, the best (%s) gains %.2f; ", tried, left.tried.front().what.c_str(),
                *left.tried.front().gain);
  std::printf("%td refused\n", refused);
}

}  // namespace

void print_improvement(const ImproveRecord& record, const std::string& unit) {
  const ImproveReport& report = record.report;
  const DesignMeasure &before = report.before, &after = report.after;
  std::printf("%s: %zu edits in %zu rounds, %.1f s\n", record.input.c_str(), report.applied.size(),
              report.rounds.size(), record.seconds);
  for (size_t k = 0; k < report.applied.size() && k < kEditsShown; ++k)
    std::printf("  %-26s predicted gain %6.2f  (round %d)\n", report.applied[k].what.c_str(),
                report.applied[k].predicted, report.applied[k].round);
  if (report.applied.size() > kEditsShown)
    std::printf("  ... and %zu more (--report lists all)\n", report.applied.size() - kEditsShown);
  std::printf("  %-26s %10s %10s\n", "", "before", "after");
  print_row("panels", before.panels, after.panels);
  for (const FindingKind kind : all_finding_kinds()) {
    const auto k = static_cast<size_t>(kind);
    if (before.findings[k] > 0 || after.findings[k] > 0)
      print_row(info(kind).title, before.findings[k], after.findings[k]);
  }
  print_row("energy", before.score.energy, after.score.energy);
  print_row("score (lower is better)", total(before.score), total(after.score));
  if (!report.left.empty()) {
    std::printf("left, with the best of what was tried there:\n");
    for (size_t k = 0; k < report.left.size() && k < kLeftShown; ++k) print_left(report.left[k]);
    if (report.left.size() > kLeftShown)
      std::printf("  ... and %zu more (--report lists all)\n", report.left.size() - kLeftShown);
  }
  std::printf("panels: %s, planar to %.2e %s (%.2e of the box)\n", record.panels_file.c_str(),
              record.planarity.max, unit.c_str(), record.planarity.max_relative_to_bbox);
  if (!record.mesh_file.empty()) std::printf("mesh: %s\n", record.mesh_file.c_str());
}

}  // namespace planewright::cli
