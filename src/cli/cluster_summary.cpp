#include "cli/cluster_summary.h"

#include <algorithm>
#include <cstdio>

namespace planewright::cli {
namespace {

constexpr size_t kRepairsShown = 10;

void print_distance(const char* what, const std::optional<TwoSidedDistance>& distance, const char* from_first,
                    const char* from_second, const char* unit) {
  if (!distance) return;
  std::printf("%s: rms %.4g %s, max %.4g %s (%s: rms %.4g, max %.4g; %s: rms %.4g, max %.4g)\n", what,
              distance->rms(), unit, distance->max(), unit, from_first, distance->from_first.rms,
              distance->from_first.max, from_second, distance->from_second.rms, distance->from_second.max);
}

}  // namespace

void print_clusters(const ClusterReport& report, const std::string& unit) {
  std::printf("clusters: %d after %d iterations and %d teleports, L2,1 error %.4g, rms distance error %.4g\n",
              report.clusters, report.iterations, report.teleports, report.l21, report.distance);
  if (!report.repairs.empty()) std::printf("repairs: %zu\n", report.repairs.size());
  for (size_t k = 0; k < std::min(report.repairs.size(), kRepairsShown); ++k)
    std::printf("  %s\n", describe(report.repairs[k]).c_str());
  if (report.repairs.size() > kRepairsShown)
    std::printf("  and %zu more\n", report.repairs.size() - kRepairsShown);
  if (report.euler_before != report.euler_after)
    std::printf("Euler characteristic: %d of the mesh, %d of the panels\n", report.euler_before,
                report.euler_after);
  std::printf("corners by valence:");
  for (const auto& [valence, corners] : report.corners_by_valence) std::printf(" %d: %d", valence, corners);
  std::printf("\n");
  print_distance("distance", report.panels_to_mesh, "of panels", "of the mesh", unit.c_str());
  print_distance("anchor polygons, not planar, for comparison", report.anchors_to_mesh, "of polygons",
                 "of the mesh", unit.c_str());
  if (report.acute.empty()) return;
  const auto sharpest =
      std::min_element(report.acute.begin(), report.acute.end(),
                       [](const AcuteCorner& a, const AcuteCorner& b) { return a.degrees < b.degrees; });
  std::printf(
      "panels with an angle below %g degrees: %zu, the sharpest is panel %d (%.3g degrees at point %d)\n",
      kAcuteDegrees, report.acute.size(), sharpest->panel, sharpest->degrees, sharpest->point);
}

bool clustering_done(const ClusterReport& report, const std::string& begin) {
  if (report.stopped)
    std::fprintf(stderr, "%sthe clustering was stopped before it was done\n", begin.c_str());
  if (report.target_met) return !report.stopped;
  std::fprintf(stderr, "%s%d regions do not meet the error that was asked for\n", begin.c_str(),
               report.clusters);
  return false;
}

}  // namespace planewright::cli
