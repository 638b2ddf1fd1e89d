#include "core/diagnose/diagnosis.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

#include "core/diagnose/close_points.h"
#include "core/diagnose/collapsed_quads.h"
#include "core/diagnose/crossing_panels.h"
#include "core/diagnose/far_points.h"
#include "core/diagnose/ill_determined_points.h"
#include "core/diagnose/not_convex_panels.h"
#include "core/diagnose/reversed_edges.h"
#include "core/diagnose/self_crossing_panels.h"
#include "core/diagnose/twisted_beams.h"

namespace planewright {
namespace {

// By how much a measure is beyond its threshold, whichever way is worse.
double excess(const Finding& finding) {
  return std::abs(finding.measure - finding.threshold);
}

bool worse(const Finding& a, const Finding& b) {
  return std::tuple(a.kind, -a.severity, -excess(a), a.element, a.second) <
         std::tuple(b.kind, -b.severity, -excess(b), b.element, b.second);
}

}  // namespace

std::vector<Finding> find_all(const TangentComplex& complex, const State& state,
                              const FindingSettings& settings, const NeighbourLayer* other) {
  const MeshPlaces mesh(complex);
  const Subject subject{complex, state, mesh};
  std::vector<Finding> all;
  const auto add = [&](std::vector<Finding> found) {
    std::move(found.begin(), found.end(), std::back_inserter(all));
  };
  const auto run = [&](FindingKind kind, auto find) {
    if (settings[kind].on) add(find(subject, settings[kind].threshold));
  };
  run(FindingKind::IllDetermined, find_ill_determined_points);
  run(FindingKind::ClosePoints, find_close_points);
  run(FindingKind::ReversedEdge, find_reversed_edges);
  run(FindingKind::SelfCrossing, find_self_crossing_panels);
  add(find_crossing_panels(subject, settings));
  run(FindingKind::NotConvex, [&](const Subject& s, double threshold) {
    return find_not_convex_panels(s, threshold, settings.least_defect);
  });
  run(FindingKind::FarPoint, find_far_points);
  run(FindingKind::CollapsedQuad, find_collapsed_quads);
  if (other)
    run(FindingKind::TwistedBeam,
        [&](const Subject& s, double threshold) { return find_twisted_beams(s, *other, threshold); });
  std::sort(all.begin(), all.end(), worse);
  return all;
}

int Diagnosis::count(FindingKind kind) const {
  return static_cast<int>(std::count_if(findings.begin(), findings.end(),
                                        [kind](const Finding& finding) { return finding.kind == kind; }));
}

Diagnosis diagnose(const TangentComplex& complex, const State& state, const FindingSettings& settings,
                   const NeighbourLayer* other) {
  Diagnosis diagnosis;
  const Vector residuals = incidence_residuals(complex, state);
  if (residuals.size() > 0) diagnosis.off_planes = residuals.cwiseAbs().maxCoeff() / complex.mean_edge;
  diagnosis.solved = residuals.allFinite() && diagnosis.off_planes <= settings.planar;
  if (diagnosis.solved) diagnosis.findings = find_all(complex, state, settings, other);
  return diagnosis;
}

}  // namespace planewright
