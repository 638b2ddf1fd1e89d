#include "cli/findings_table.h"

#include <cstdio>

namespace planewright::cli {
namespace {

constexpr int kShownOfAKind = 20;

// "0.213 edges"
std::string with_unit(double value, const std::string& unit) {
  char text[64];
  std::snprintf(text, sizeof text, "%.3g", value);
  return unit.empty() ? std::string(text) : std::string(text) + ' ' + unit;
}

void print_row(const Finding& finding) {
  std::string element = text(finding.element);
  if (finding.second) element += ", " + std::to_string(finding.second->index);
  std::printf("%-24s %-18s %-34s %9.3g %8.2f  %s\n", info(finding.kind).title, element.c_str(),
              with_unit(finding.measure, finding.unit).c_str(), finding.threshold, finding.severity,
              finding.cause.c_str());
}

}  // namespace

void print_findings(const DiagnosisRecord& record, const std::string& input) {
  const TangentComplex& complex = *record.complex;
  const Diagnosis& diagnosis = record.diagnosis;
  if (!record.layer.empty()) std::printf("layer %s\n", record.layer.c_str());
  std::printf("%s: %d panels, %d points, mean edge %.4g\n", input.c_str(), complex.plane_count(),
              complex.point_count(), complex.mean_edge);
  if (record.solve)
    std::printf("status: %s after %d iterations (%s)\n", name(record.solve->status), record.solve->iterations,
                record.solve->stop_reason.c_str());
  if (!diagnosis.solved) {
    std::printf("not solved: points lie up to %.2g mean edges off their planes; nothing was looked for\n",
                diagnosis.off_planes);
    return;
  }
  if (diagnosis.findings.empty()) {
    std::printf("findings: none\n");
    return;
  }
  std::printf("findings: %zu\n", diagnosis.findings.size());
  std::printf("%-24s %-18s %-34s %9s %8s  %s\n", "kind", "element", "measure", "threshold", "severity",
              "cause");
  int shown = 0;
  for (size_t k = 0; k < diagnosis.findings.size(); ++k) {
    const Finding& finding = diagnosis.findings[k];
    if (k > 0 && diagnosis.findings[k - 1].kind != finding.kind) shown = 0;
    if (shown < kShownOfAKind) print_row(finding);
    if (shown++ == kShownOfAKind)
      std::printf("%-24s ... and %d more\n", info(finding.kind).title,
                  diagnosis.count(finding.kind) - kShownOfAKind);
  }
}

}  // namespace planewright::cli
