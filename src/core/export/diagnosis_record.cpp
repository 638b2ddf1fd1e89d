#include "core/export/diagnosis_record.h"

#include "core/export/json_parts.h"
#include "core/export/suggestion_json.h"

namespace planewright {
namespace {

Json finding_json(const Finding& finding, const TangentComplex& complex) {
  Json edges = Json::array();
  for (const int edge : finding.mesh_edges)
    edges.push_back({{"edge", edge}, {"vertices", complex.input.edges[static_cast<size_t>(edge)]}});
  return {{"kind", info(finding.kind).name},
          {"element", element_json(finding.element)},
          {"second", finding.second ? element_json(*finding.second) : Json()},
          {"place", {finding.place.x(), finding.place.y(), finding.place.z()}},
          {"measure", finding.measure},
          {"threshold", finding.threshold},
          {"unit", finding.unit},
          {"severity", finding.severity},
          {"cause", finding.cause},
          {"mesh_edges", edges}};
}

void add_layer(Json& json, const DiagnosisRecord& record, const PolygonMesh& mesh) {
  const TangentComplex& complex = *record.complex;
  Json findings = Json::array();
  for (const Finding& finding : record.diagnosis.findings) findings.push_back(finding_json(finding, complex));
  json["mode"] = key(complex.kind);
  json["status"] = record.solve ? Json(name(record.solve->status)) : Json();
  json["stop_reason"] = record.solve ? Json(record.solve->stop_reason) : Json();
  json["panels"] = complex.plane_count();
  json["points"] = complex.point_count();
  json["mean_edge"] = complex.mean_edge;
  json["solved"] = record.diagnosis.solved;
  json["off_planes"] = record.diagnosis.off_planes;
  json["counts"] = counts_json(record.diagnosis);
  json["findings"] = std::move(findings);
  json["suggestions"] = record.suggestions ? suggestions_json(*record.suggestions, mesh) : Json();
}

}  // namespace

std::string to_json(const std::string& input, const PolygonMesh& mesh,
                    const std::vector<DiagnosisRecord>& layers, const HealthReport& health) {
  Json json = heading(input);
  if (layers.size() == 1 && layers.front().layer.empty()) {
    add_layer(json, layers.front(), mesh);
  } else {
    Json list = Json::array();
    for (const DiagnosisRecord& record : layers) {
      Json entry = {{"name", record.layer}};
      add_layer(entry, record, mesh);
      list.push_back(std::move(entry));
    }
    json["layers"] = std::move(list);
  }
  json["health"] = health_json(health);
  return written(json);
}

}  // namespace planewright
