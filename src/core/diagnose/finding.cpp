#include "core/diagnose/finding.h"

#include <algorithm>

namespace planewright {

const std::array<FindingKind, kFindingKinds>& all_finding_kinds() {
  static const std::array<FindingKind, kFindingKinds> all{
      FindingKind::IllDetermined, FindingKind::ClosePoints, FindingKind::ReversedEdge,
      FindingKind::SelfCrossing,  FindingKind::FoldedOver,  FindingKind::CrossingPanels,
      FindingKind::NotConvex,     FindingKind::FarPoint,    FindingKind::CollapsedQuad,
      FindingKind::TwistedBeam};
  return all;
}

const FindingKindInfo& info(FindingKind kind) {
  // In the order of the enumeration.
  static const std::array<FindingKindInfo, kFindingKinds> infos{{
      {"ill-determined", "ill-determined point", "edges per degree", 0.0, 0.1, 0.6},
      {"close-points", "points too close", "edges", 0.15, 0.2, 0.6},
      {"reversed-edge", "reversed edge", "edges", 1e-3, 0.5, 0.9},
      {"self-crossing", "panel crosses itself", "of its outline", 0.0, 0.7, 1.0},
      {"folded-over", "panel folds over", "edges", 1e-3, 0.7, 1.0},
      {"crossing-panels", "panels cross", "edges", 1e-3, 0.7, 1.0},
      {"not-convex", "panel not convex", "degrees", 10.0, 0.1, 0.5},
      {"far-point", "point far from its place", "edges", 1.0, 0.3, 0.7},
      {"collapsed-quad", "quad became a triangle", "of a full corner", 0.1, 0.3, 0.7},
      {"twisted-beam", "beam twists", "degrees", 5.0, 0.1, 0.8},
  }};
  return infos[static_cast<size_t>(kind)];
}

bool calls_for_edits(FindingKind kind) {
  return kind != FindingKind::NotConvex && kind != FindingKind::TwistedBeam;
}

Result<FindingKind> find_finding_kind(const std::string& name) {
  std::string known;
  for (const FindingKind kind : all_finding_kinds()) {
    if (name == info(kind).name) return kind;
    known += (known.empty() ? "" : ", ") + std::string(info(kind).name);
  }
  return fail(ErrorCode::Usage, "there is no kind of finding named '" + name + "'", {}, "Known: " + known);
}

FindingSettings::FindingSettings() {
  for (const FindingKind kind : all_finding_kinds()) (*this)[kind].threshold = info(kind).threshold;
}

Finding make_finding(FindingKind kind, ElementRef element, double measure, double threshold, double share) {
  const FindingKindInfo& of = info(kind);
  Finding finding;
  finding.kind = kind;
  finding.element = element;
  finding.measure = measure;
  finding.threshold = threshold;
  finding.unit = of.unit;
  // Not clamp: a share that is no number counts as the worst.
  finding.severity =
      of.least_severity + (of.most_severity - of.least_severity) * (share >= 0.0  ? std::min(share, 1.0)
                                                                    : share < 0.0 ? 0.0
                                                                                  : 1.0);
  return finding;
}

}  // namespace planewright
