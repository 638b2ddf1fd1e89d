#include "core/export/solve_record.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/export/cluster_json.h"
#include "core/export/json_parts.h"
#include "core/problem/constraint.h"
#include "core/problem/demands/demand_catalogue.h"

namespace planewright {
namespace {

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

Json waivers_json(const std::vector<Waiver>& waivers) {
  Json list = Json::array();
  for (const Waiver& waiver : waivers)
    list.push_back({{"demand", waiver.demand}, {"element", element_json(waiver.element)}});
  return list;
}

Json demands_json(const Demands& demands) {
  Json list = Json::array();
  for (const Demand& demand : demands.list) {
    if (!demand.on) continue;
    Json values = Json::array();
    for (const double value : demand.values)
      values.push_back(std::abs(value) < kNoLimit ? Json(value) : Json());
    Json entry = {{"name", demand.name}, {"values", values}};
    if (!demand.selection.empty()) entry["selection"] = demand.selection;
    list.push_back(std::move(entry));
  }
  return list;
}

Json constraints_json(const SolveReport& solve) {
  Json constraints = Json::object();
  for (const auto& constraint : solve.constraints)
    constraints[constraint.name] = {
        {"max_violation", constraint.max_violation},
        {"violated", constraint.violated},
        {"rows", constraint.rows},
        {"waived", constraint.waived},
        {"unit", constraint.unit},
        {"worst", constraint.max_violation > 0.0 ? Json(text(constraint.worst)) : Json()}};
  return constraints;
}

Json diagnosis_json(const SolveRecord& record) {
  Json degenerate = Json::array(), short_edges = Json::array();
  for (const IllDetermined& point : record.ill_determined)
    degenerate.push_back({{"point", point.point}, {"singular_value", point.singular_value}});
  for (const ShortEdge& edge : record.short_edges)
    short_edges.push_back({{"edge", edge.edge}, {"length", edge.length}});
  return {{"degenerate_points", degenerate},
          {"short_edges", short_edges},
          {"crossing_panels", record.self_crossing},
          {"findings", counts_json(record.diagnosis)}};
}

Json planarity_json(const Planarity& planarity) {
  return {{"max", planarity.max},
          {"mean", planarity.mean},
          {"max_relative_to_bbox", planarity.max_relative_to_bbox}};
}

Json crosses_json(const LayerCrossings& crosses) {
  Json json = Json::object();
  for (const auto& [layer, pairs] : crosses) json[layer] = pairs;
  return json;
}

Json offset_json(const OffsetRecord& offset) {
  Json blunted = Json::array(), residuals = Json::array();
  for (const auto& corner : offset.blunted)
    blunted.push_back({{"point", corner.point}, {"wanted_move", corner.wanted_move}});
  for (const auto& corner : offset.residuals)
    residuals.push_back({{"point", corner.point}, {"residual", corner.residual}});
  return {{"file", offset.file},
          {"thickness", offset.thickness},
          {"planarity", planarity_json(offset.planarity)},
          {"blunted", blunted},
          {"residuals", residuals},
          {"crossings", offset.crossings},
          {"crosses", crosses_json(offset.crosses)}};
}

// What was asked of one layer.
void add_settings(Json& json, const SolveRecord& record) {
  const LayerSettings& settings = record.settings;
  Json weights = Json::object();
  for (const auto& [name, weight] : settings.weights) weights[name] = weight;
  json["mode"] = key(settings.mode);
  json["freedom"] = key(settings.freedom);
  json["offset"] = settings.offset;
  json["side"] = settings.side_sign() < 0.0 ? "inside" : "outside";
  json["preset"] = record.preset.empty() ? Json() : Json(record.preset);
  json["weights"] = weights;
  json["demands"] = demands_json(settings.demands);
  json["margin"] = settings.demands.margin;
  json["no_penetration"] = settings.no_penetration;
  json["pins"] = settings.demands.pins.size();
  json["plane_pins"] = settings.demands.plane_pins.size();
  json["waived"] = waivers_json(settings.demands.waived);
  json["reference"] = record.reference.empty() ? Json() : Json(record.reference);
}

// How one layer ended and what came of it.
void add_outcome(Json& json, const SolveRecord& record) {
  const SolveReport& solve = record.solve;
  Json energies = Json::object();
  for (const auto& energy : solve.energies) energies[energy.name] = energy.value;
  json["solver"] = solve.solver;
  json["status"] = name(solve.status);
  json["stop_reason"] = solve.stop_reason;
  json["iterations"] = solve.iterations;
  json["rounds"] = solve.rounds;
  json["first_order_residual"] = solve.first_order_residual;
  json["seconds"] = {
      {"build", record.seconds_build}, {"solve", solve.seconds}, {"total", record.seconds_total}};
  json["panels"] = record.panels;
  json["points"] = record.points;
  json["mean_edge"] = record.mean_edge;
  json["planarity"] = planarity_json(record.planarity);
  json["displacement"] = {{"rms", record.displacement.rms},
                          {"max", record.displacement.max},
                          {"rms_edges", record.displacement.rms / record.mean_edge},
                          {"max_edges", record.displacement.max / record.mean_edge}};
  json["energies"] = energies;
  json["constraints"] = constraints_json(solve);
  json["conflicts"] = waivers_json(solve.conflicts);
  json["demands_without_rows"] = demands_without_rows(record);
  json["crossings"] = solve.crossings < 0 ? Json() : Json(solve.crossings);
  json["crossings_waived"] = solve.crossings < 0 ? Json() : Json(solve.crossings_waived);
  if (!record.layer.empty()) json["crosses"] = crosses_json(record.crosses);
  json["diagnosis"] = diagnosis_json(record);
  if (record.clusters) json["cluster"] = cluster_json(*record.clusters);
  if (record.offset_layer) json["parallel_offset"] = offset_json(*record.offset_layer);
  if (record.beams)
    json["beams"] = {{"file", record.beams->file},
                     {"with", record.beams->with},
                     {"count", record.beams->count},
                     {"max_planarity", record.beams->max_planarity},
                     {"max_twist", record.beams->max_twist},
                     {"most_twisted_edge",
                      record.beams->most_twisted_edge < 0 ? Json() : Json(record.beams->most_twisted_edge)},
                     {"turned_round", record.beams->turned_round}};
}

// The order of the exit statuses; among those of one status, how little there is to use.
int badness(SolveStatus status) {
  switch (status) {
    case SolveStatus::Converged:
      return 0;
    case SolveStatus::Planar:
      return 1;
    case SolveStatus::Stopped:
      return 2;
    case SolveStatus::NotPlanar:
      return 3;
    case SolveStatus::Failed:
      return 4;
    case SolveStatus::Infeasible:
      return 5;
  }
  return 5;
}

std::optional<ElementKind> kind_named(const std::string& text) {
  for (const ElementKind kind : {ElementKind::Point, ElementKind::Panel, ElementKind::PanelEdge})
    if (text == name(kind)) return kind;
  return {};
}

// Nothing where an entry is none that waivers_json wrote.
std::optional<Waiver> read_waiver(const Json& entry) {
  if (!entry.is_object() || !entry.contains("demand") || !entry["demand"].is_string() ||
      !entry.contains("element") || !entry["element"].is_object())
    return {};
  const Json& element = entry["element"];
  if (!element.contains("kind") || !element["kind"].is_string() || !element.contains("index") ||
      !element["index"].is_number_integer())
    return {};
  const auto kind = kind_named(element["kind"].get<std::string>());
  const auto index = element["index"].get<long long>();
  if (!kind || index < 0 || index > std::numeric_limits<int>::max()) return {};
  return Waiver{entry["demand"].get<std::string>(), {*kind, static_cast<int>(index)}};
}

// Besides the demands of the catalogue those that a solve makes rows of by itself.
bool is_demand_name(const std::string& name) {
  return name == "pin" || name == "plane pin" || name == "no-penetration" || find_demand(name).has_value();
}

// -1: the report has no such count.
int count_in(const Json& record, const char* key) {
  if (!record.contains(key) || !record[key].is_number_integer()) return -1;
  const auto count = record[key].get<long long>();
  return count < 0 || count > std::numeric_limits<int>::max() ? -1 : static_cast<int>(count);
}

}  // namespace

bool is_demand(const SolveReport::Constraint& constraint) {
  return constraint.name != "incidence" && constraint.name != "unit normal";
}

std::vector<std::string> demands_without_rows(const SolveRecord& record) {
  std::vector<std::string> names;
  if (record.solve.constraints.empty()) return names;  // it got nowhere, or nothing was optimised
  for (const Demand& demand : record.settings.demands.list) {
    const bool holds = std::any_of(record.solve.constraints.begin(), record.solve.constraints.end(),
                                   [&](const auto& c) { return c.name == demand.name && c.rows > 0; });
    if (demand.on && !holds && std::find(names.begin(), names.end(), demand.name) == names.end())
      names.push_back(demand.name);
  }
  return names;
}

std::vector<int> forbidden_self_crossings(const SolveRecord& record) {
  const Demands& demands = record.settings.demands;
  std::vector<int> panels;
  for (const int panel : record.self_crossing) {
    const bool forbidden = std::any_of(demands.list.begin(), demands.list.end(), [&](const Demand& demand) {
      const Waiver here{demand.name, {ElementKind::Panel, panel}};
      return demand.on && demand.selection.empty() && (demand.name == "uncrossed" || demand.name == "star") &&
             std::find(demands.waived.begin(), demands.waived.end(), here) == demands.waived.end();
    });
    if (forbidden) panels.push_back(panel);
  }
  return panels;
}

double peak_memory_mb() {
  rusage usage{};
  if (::getrusage(RUSAGE_SELF, &usage) != 0) return 0.0;
  return static_cast<double>(usage.ru_maxrss) / 1024.0;  // Linux counts kilobytes
}

std::string to_json(const SolveRecord& record) {
  Json json = heading(record.input);
  add_settings(json, record);
  add_outcome(json, record);
  json["peak_memory_mb"] = peak_memory_mb();
  json["health"] = health_json(record.health);
  return written(json);
}

std::string to_json(const std::vector<SolveRecord>& layers) {
  Json json = heading(layers.front().input);
  const auto worst = std::max_element(layers.begin(), layers.end(), [](const auto& a, const auto& b) {
    return badness(a.solve.status) < badness(b.solve.status);
  });
  json["status"] = name(worst->solve.status);
  Json list = Json::array();
  for (const SolveRecord& record : layers) {
    Json entry = {{"name", record.layer}};
    add_settings(entry, record);
    add_outcome(entry, record);
    list.push_back(std::move(entry));
  }
  json["layers"] = std::move(list);
  json["peak_memory_mb"] = peak_memory_mb();
  json["health"] = health_json(layers.front().health);
  return written(json);
}

Result<EarlierReport> read_waivers(std::string_view json, const std::string& name, const std::string& layer) {
  constexpr const char* kRemedy = "Give a report that an earlier solve of this design wrote with --report";
  const Json report = Json::parse(json, nullptr, false);
  if (report.is_discarded() || !report.is_object() || !report.contains("tool"))
    return fail(ErrorCode::Unreadable, "the file is no report of a solve", name, kRemedy);
  const Json* record = &report;
  if (report.contains("layers") != !layer.empty())
    return fail(
        ErrorCode::Unreadable,
        layer.empty() ? "the report is one of several layers" : "the report is not one of several layers",
        name, layer.empty() ? "Solve with the same --layers" : "Solve without --layers");
  if (!layer.empty()) {
    record = nullptr;
    std::string known;
    if (report["layers"].is_array())
      for (const Json& entry : report["layers"]) {
        if (!entry.is_object() || !entry.contains("name") || !entry["name"].is_string()) continue;
        const auto title = entry["name"].get<std::string>();
        if (title == layer) record = &entry;
        known += (known.empty() ? "" : ", ") + title;
      }
    if (!record)
      return fail(ErrorCode::Unreadable, "the report has no layer '" + layer + "'", name, "It has: " + known);
  }
  EarlierReport read;
  read.panels = count_in(*record, "panels");
  read.points = count_in(*record, "points");
  if (read.panels < 0 || read.points < 0)
    return fail(ErrorCode::Unreadable, "the report does not say how many panels and points it is about", name,
                kRemedy);
  for (const char* list : {"waived", "conflicts"}) {
    if (!record->contains(list) || !(*record)[list].is_array())
      return fail(ErrorCode::Unreadable, std::string("the report has no list '") + list + "'", name, kRemedy);
    for (const Json& entry : (*record)[list]) {
      auto waiver = read_waiver(entry);
      if (!waiver)
        return fail(ErrorCode::Unreadable,
                    std::string("an entry of '") + list + "' is no demand at an element: " + entry.dump(),
                    name, kRemedy);
      if (!is_demand_name(waiver->demand))
        return fail(
            ErrorCode::Unreadable,
            std::string("'") + list + "' names a constraint that there is not: '" + waiver->demand + "'",
            name, kRemedy);
      read.waivers.push_back(std::move(*waiver));
    }
  }
  return read;
}

}  // namespace planewright
