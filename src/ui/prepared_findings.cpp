#include "ui/prepared_findings.h"

#include <limits>

#include "ui/frame_timings.h"
#include "ui/view_preparer.h"

namespace planewright::ui {

PreparedFindings prepare_findings(const PrepareJob& job) {
  const Stopwatch watch;
  const TangentComplex& complex = *job.iterate->complex;
  PreparedFindings out;
  out.layer = job.layer;
  out.number = job.number;
  out.iterate = job.iterate;
  out.thresholds = job.thresholds;
  if (job.neighbour) {
    const NeighbourLayer other{job.neighbour->complex, job.neighbour->state};
    out.diagnosis = diagnose(complex, job.iterate->state, job.thresholds, &other);
  } else {
    out.diagnosis = diagnose(complex, job.iterate->state, job.thresholds);
  }
  out.milliseconds = watch.milliseconds();
  return out;
}

Vector panel_severity(const TangentComplex& complex, const std::vector<Finding>& findings,
                      const HiddenFindings& hidden) {
  Vector worst = Vector::Constant(complex.plane_count(), std::numeric_limits<double>::quiet_NaN());
  const auto touch = [&](int panel, double severity) {
    if (panel >= 0 && !(worst[panel] >= severity)) worst[panel] = severity;
  };
  const auto touch_all_at = [&](const ElementRef& element, double severity) {
    switch (element.kind) {
      case ElementKind::Panel:
        touch(element.index, severity);
        break;
      case ElementKind::Point:
        for (const int panel : complex.planes_of_point[element.index]) touch(panel, severity);
        break;
      case ElementKind::PanelEdge: {
        const PanelEdge& edge = complex.panel_edges[static_cast<std::size_t>(element.index)];
        touch(edge.left, severity);
        touch(edge.right, severity);
        break;
      }
    }
  };
  for (const Finding& finding : findings) {
    if (is_hidden(hidden, finding.kind)) continue;
    touch_all_at(finding.element, finding.severity);
    if (finding.second) touch_all_at(*finding.second, finding.severity);
  }
  return worst;
}

}  // namespace planewright::ui
