#include "core/export/solve_record.h"

#include <sys/resource.h>

#include <nlohmann/json.hpp>

#include "core/base/version.h"

namespace planewright {
namespace {

using Json = nlohmann::ordered_json;

const char* key(ComplexKind kind) {
  return kind == ComplexKind::Dual ? "dual" : "planarize";
}

const char* key(Freedom freedom) {
  switch (freedom) {
    case Freedom::Fixed:
      return "fixed";
    case Freedom::Normals:
      return "normals";
    case Freedom::NormalsAndOffsets:
      return "normals-and-offsets";
  }
  return "";
}

Json health_json(const HealthReport& health) {
  Json defects = Json::array();
  for (const Defect& defect : health.defects)
    defects.push_back({{"kind", name(defect.kind)},
                       {"count", defect.count},
                       {"action", defect.action},
                       {"elements", defect.elements}});
  return {{"vertices", health.vertices},
          {"faces", health.faces},
          {"components", health.components},
          {"border_loops", health.border_loops},
          {"border_edges", health.border_edges},
          {"repaired", health.repaired},
          {"defects", defects}};
}

}  // namespace

double peak_memory_mb() {
  rusage usage{};
  if (::getrusage(RUSAGE_SELF, &usage) != 0) return 0.0;
  return static_cast<double>(usage.ru_maxrss) / 1024.0;  // Linux counts kilobytes
}

std::string to_json(const SolveRecord& record) {
  const SolveReport& solve = record.solve;
  Json energies = Json::object(), constraints = Json::object();
  for (const auto& energy : solve.energies) energies[energy.name] = energy.value;
  for (const auto& constraint : solve.constraints)
    constraints[constraint.name] = {{"max_violation", constraint.max_violation},
                                    {"violated", constraint.violated}};
  Json weights = Json::object();
  for (const auto& [name, weight] : record.settings.weights) weights[name] = weight;
  Json degenerate = Json::array();
  for (const IllDetermined& point : record.ill_determined)
    degenerate.push_back({{"point", point.point}, {"singular_value", point.singular_value}});

  Json short_edges = Json::array();
  for (const ShortEdge& edge : record.short_edges)
    short_edges.push_back({{"edge", edge.edge}, {"length", edge.length}});

  const Json json = {
      {"tool", "planewright"},
      {"version", kVersion},
      {"input", record.input},
      {"mode", key(record.settings.mode)},
      {"freedom", key(record.settings.freedom)},
      {"offset", record.settings.offset},
      {"weights", weights},
      {"solver", solve.solver},
      {"status", name(solve.status)},
      {"stop_reason", solve.stop_reason},
      {"iterations", solve.iterations},
      {"first_order_residual", solve.first_order_residual},
      {"peak_memory_mb", peak_memory_mb()},
      {"seconds",
       {{"build", record.seconds_build}, {"solve", solve.seconds}, {"total", record.seconds_total}}},
      {"panels", record.panels},
      {"points", record.points},
      {"mean_edge", record.mean_edge},
      {"planarity",
       {{"max", record.planarity.max},
        {"mean", record.planarity.mean},
        {"max_relative_to_bbox", record.planarity.max_relative_to_bbox}}},
      {"displacement",
       {{"rms", record.displacement.rms},
        {"max", record.displacement.max},
        {"rms_edges", record.displacement.rms / record.mean_edge},
        {"max_edges", record.displacement.max / record.mean_edge}}},
      {"energies", energies},
      {"constraints", constraints},
      {"diagnosis",
       {{"degenerate_points", degenerate},
        {"short_edges", short_edges},
        {"crossing_panels", record.self_crossing}}},
      {"health", health_json(record.health)},
  };
  // A file's name may be any bytes; those that are not UTF-8 are replaced.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace planewright
