#include "core/export/improve_record.h"

#include "core/export/suggestion_json.h"

namespace planewright {
namespace {

Json left_json(const ImproveReport::Left& left) {
  const Finding& finding = left.finding;
  Json tried = Json::array();
  for (const ImproveReport::Tried& each : left.tried)
    tried.push_back({{"edit", each.what},
                     {"gain", each.gain ? Json(*each.gain) : Json()},
                     {"refused", each.refused.empty() ? Json() : Json(each.refused)}});
  return {{"kind", info(finding.kind).name},
          {"element", element_json(finding.element)},
          {"place", {finding.place.x(), finding.place.y(), finding.place.z()}},
          {"measure", finding.measure},
          {"unit", finding.unit},
          {"angle_defect", left.angle_defect},
          {"tried", tried}};
}

}  // namespace

std::string to_json(const ImproveRecord& record) {
  const ImproveReport& report = record.report;
  Json json = heading(record.input);
  json["panels"] = record.panels_file;
  json["mesh"] = record.mesh_file.empty() ? Json() : Json(record.mesh_file);
  json["stopped"] = report.stopped;
  json["before"] = measure_json(report.before);
  json["after"] = measure_json(report.after);
  json["status"] = name(report.solve.status);
  json["stop_reason"] = report.solve.stop_reason;
  json["planarity"] = {{"max", record.planarity.max},
                       {"max_relative_to_bbox", record.planarity.max_relative_to_bbox}};
  Json edits = Json::array();
  for (const ImproveReport::Applied& applied : report.applied)
    edits.push_back({{"edit", applied.what}, {"predicted", applied.predicted}, {"round", applied.round}});
  json["edits"] = std::move(edits);
  Json rounds = Json::array();
  for (const ImproveReport::Round& round : report.rounds)
    rounds.push_back({{"rated", round.rated},
                      {"edits", round.edits},
                      {"predicted", round.predicted},
                      {"gained", round.gained}});
  json["rounds"] = std::move(rounds);
  json["dropped"] = report.dropped;
  Json left = Json::array();
  for (const ImproveReport::Left& each : report.left) left.push_back(left_json(each));
  json["left"] = std::move(left);
  json["seconds"] = record.seconds;
  json["health"] = health_json(record.health);
  return written(json);
}

}  // namespace planewright
