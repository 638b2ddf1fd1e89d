#include "core/export/cluster_json.h"

namespace planewright {
namespace {

const char* key(SeedKind seeds) {
  switch (seeds) {
    case SeedKind::Random:
      return "random";
    case SeedKind::Farthest:
      return "farthest";
    case SeedKind::Given:
      break;
  }
  return "given";
}

Json distance_json(const std::optional<TwoSidedDistance>& distance, const char* first) {
  if (!distance) return {};
  const auto one_side = [](const SurfaceDistance& side) {
    return Json{{"max", side.max}, {"rms", side.rms}};
  };
  return {{std::string(first) + "_to_mesh", one_side(distance->from_first)},
          {std::string("mesh_to_") + first, one_side(distance->from_second)},
          {"both", {{"max", distance->max()}, {"rms", distance->rms()}}}};
}

}  // namespace

Json cluster_json(const ClusterReport& report) {
  const ClusterOptions& options = report.options;
  Json repairs = Json::array(), valences = Json::object(), acute = Json::array();
  for (const RegionRepair& repair : report.repairs)
    repairs.push_back({{"region", repair.region},
                       {"other", repair.other},
                       {"faces", repair.faces},
                       {"what", describe(repair)}});
  for (const auto& [valence, corners] : report.corners_by_valence)
    valences[std::to_string(valence)] = corners;
  for (const AcuteCorner& corner : report.acute)
    acute.push_back({{"panel", corner.panel}, {"point", corner.point}, {"degrees", corner.degrees}});
  const auto target = options.target_normal ? options.target_normal : options.target_distance;
  return {{"asked", options.panels},
          {"target", target ? Json(*target) : Json()},
          {"target_met", target ? Json(report.target_met) : Json()},
          {"metric",
           {{"normal", options.metric.normal},
            {"distance", options.metric.distance},
            {"compactness", options.metric.compactness}}},
          {"seeds", report.given ? "regions" : key(options.seeds)},
          {"seed", !report.given && options.seeds == SeedKind::Random ? Json(options.seed_number) : Json()},
          {"stopped", report.stopped},
          {"clusters", report.clusters},
          {"iterations", report.iterations},
          {"teleports", report.teleports},
          {"l21_error", report.l21},
          {"error", report.error},
          {"distance_error", report.distance},
          {"repairs", repairs},
          {"euler_characteristic", {{"mesh", report.euler_before}, {"panels", report.euler_after}}},
          {"corners_by_valence", valences},
          {"distance", distance_json(report.panels_to_mesh, "panels")},
          {"anchor_polygons", distance_json(report.anchors_to_mesh, "anchors")},
          {"acute_below_degrees", kAcuteDegrees},
          {"acute_panels", acute}};
}

}  // namespace planewright
