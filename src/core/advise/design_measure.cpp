#include "core/advise/design_measure.h"

#include "core/design/design.h"

namespace planewright {

bool is_unbuildable(FindingKind kind) {
  switch (kind) {
    case FindingKind::ClosePoints:
    case FindingKind::SelfCrossing:
    case FindingKind::FoldedOver:
    case FindingKind::CrossingPanels:
      return true;
    default:
      return false;
  }
}

int DesignMeasure::unbuildable() const {
  int count = 0;
  for (const FindingKind kind : all_finding_kinds())
    if (is_unbuildable(kind)) count += findings[static_cast<size_t>(kind)];
  return count;
}

Result<DesignMeasure> measure_design(const Advised& design, const Diagnosis& diagnosis) {
  const TangentComplex& complex = *design.complex;
  const FrozenGeometry frozen{&design.state, design.reference, nullptr, {}};
  const auto problem = build_problem(design.complex, design.settings, design.selections, frozen);
  if (!problem) return tl::unexpected(problem.error());
  DesignMeasure measure;
  measure.panels = complex.plane_count();
  measure.points = complex.point_count();
  for (const FindingKind kind : all_finding_kinds())
    measure.findings[static_cast<size_t>(kind)] = diagnosis.count(kind);
  measure.score = defects_of(complex, design.state, whole_region(complex));
  measure.score.energy = (*problem)->objective((*problem)->from_state(design.state).data());
  return measure;
}

}  // namespace planewright
