#include "core/export/json_parts.h"

#include "core/base/version.h"

namespace planewright {

Json heading(const std::string& input) {
  return {{"tool", "planewright"}, {"version", kVersion}, {"input", input}};
}

const char* key(ComplexKind kind) {
  switch (kind) {
    case ComplexKind::Dual:
      return "dual";
    case ComplexKind::Planarize:
      return "planarize";
    case ComplexKind::Cluster:
      break;
  }
  return "cluster";
}

Json element_json(const ElementRef& element) {
  return {{"kind", name(element.kind)}, {"index", element.index}};
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

Json counts_json(const Diagnosis& diagnosis) {
  if (!diagnosis.solved) return {};
  Json counts = Json::object();
  for (const FindingKind kind : all_finding_kinds()) counts[info(kind).name] = diagnosis.count(kind);
  return counts;
}

std::string written(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace planewright
