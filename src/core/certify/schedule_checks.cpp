#include "core/certify/schedule_checks.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core/certify/check_text.h"
#include "core/certify/value_check.h"

namespace planewright {
namespace {

using Json = nlohmann::json;

constexpr double kSquareMetres = 1e-6;  // per mm^2

std::string name_of_panel(const ExportContent& content, int panel) {
  return panel >= 0 ? content.model->names[static_cast<size_t>(panel)] : std::string();
}
size_t sides_in_all(const ExportContent& content) {
  size_t all = 0;
  for (const PanelPassport& p : *content.passports) all += p.sides.size();
  return all;
}

Check row_count(size_t rows, size_t wanted, const char* of) {
  return {"number of rows", rows == wanted,
          counted(static_cast<long long>(rows)) + " rows for " + counted(static_cast<long long>(wanted)) +
              " " + of};
}

Check columns(const CsvTable& table, const std::vector<std::string>& wanted) {
  std::vector<std::string> missing;
  for (const std::string& c : wanted)
    if (table.column(c) < 0) missing.push_back(c);
  return {"columns", missing.empty(),
          missing.empty() ? counted(static_cast<long long>(wanted.size())) + ", units in their names"
                          : "missing: " + listed(missing)};
}

// Names in the first place of rows: each panel's exactly once.
Check names_once(const std::vector<std::string>& names, const ExportContent& content) {
  std::map<std::string, int> seen;
  for (const std::string& n : names) ++seen[n];
  std::vector<std::string> wrong;
  int right = 0;
  for (const std::string& n : content.model->names) {
    const auto found = seen.find(n);
    if (found != seen.end() && found->second == 1)
      ++right;
    else
      wrong.push_back(n + (found == seen.end() ? " is missing" : " more than once"));
    if (found != seen.end()) seen.erase(found);
  }
  for (const auto& [n, times] : seen) wrong.push_back("'" + n + "' is no panel");
  std::string detail = counted(right) + " of " + counted(content.model->panel_count()) + " names";
  if (!wrong.empty()) detail += "; " + listed(wrong);
  return {"every name once", wrong.empty(), detail};
}

std::map<std::string, const PanelPassport*> by_name(const ExportContent& content) {
  std::map<std::string, const PanelPassport*> all;
  for (const PanelPassport& p : *content.passports) all[name_of_panel(content, p.panel)] = &p;
  return all;
}

const char* verdict_of(const ExportContent& content, int panel) {
  return content.verdicts->pass[static_cast<size_t>(panel)] ? "pass" : "fail";
}

// --- JSON -------------------------------------------------------------------------------------------------

std::optional<double> number_of(const Json& object, const char* key) {
  const auto at = object.find(key);
  if (at == object.end() || !at->is_number()) return {};
  return at->get<double>();
}
std::string text_of(const Json& object, const char* key) {
  const auto at = object.find(key);
  return at != object.end() && at->is_string() ? at->get<std::string>() : std::string();
}
const Json& list_of(const Json& object, const char* key) {
  static const Json none = Json::array();
  const auto at = object.is_object() ? object.find(key) : object.end();
  return object.is_object() && at != object.end() && at->is_array() ? *at : none;
}

void compare_sides(const Json& panel, const PanelPassport& passport, const ExportContent& content,
                   const std::string& name, ValueCheck& values) {
  const Json& sides = list_of(panel, "sides");
  values.compare(name, "number of sides", static_cast<double>(sides.size()),
                 static_cast<double>(passport.sides.size()));
  for (size_t k = 0; k < std::min(sides.size(), passport.sides.size()); ++k) {
    const SidePassport& side = passport.sides[k];
    const std::string who = name + " side " + std::to_string(k + 1);
    values.compare(who, "neighbour", text_of(sides[k], "neighbour"), name_of_panel(content, side.neighbour));
    values.compare(who, "length_mm", number_of(sides[k], "length_mm"), side.length);
    values.compare(who, "interior_deg", number_of(sides[k], "interior_deg"), side.interior);
    values.compare(who, "dihedral_deg", number_of(sides[k], "dihedral_deg"), side.dihedral);
    values.compare(who, "bevel_deg", number_of(sides[k], "bevel_deg"), side.bevel);
  }
}

void compare_corners(const Json& panel, int index, const ExportContent& content, const std::string& name,
                     ValueCheck& values) {
  const WorkshopModel& model = *content.model;
  const Json& corners = list_of(panel, "corners_mm");
  const auto wanted = model.panels[index];
  values.compare(name, "number of corners", static_cast<double>(corners.size()),
                 static_cast<double>(wanted.size()));
  for (size_t k = 0; k < std::min(corners.size(), wanted.size()); ++k)
    for (size_t axis = 0; axis < 3; ++axis) {
      const bool there = corners[k].is_array() && corners[k].size() == 3 && corners[k][axis].is_number();
      const int a = static_cast<int>(axis);
      values.compare(name, "corner " + std::to_string(k + 1),
                     there ? std::optional(corners[k][axis].get<double>()) : std::nullopt,
                     model.points(wanted[k], a) + model.origin[a]);
    }
}

}  // namespace

std::vector<Check> check_panel_csv(const CsvTable& table, const ExportContent& content) {
  std::vector<Check> checks{row_count(table.rows.size(), content.passports->size(), "panels"),
                            columns(table, {"name", "number", "class", "mirrored", "corners", "area_m2",
                                            "perimeter_mm", "width_mm", "height_mm", "planarity_mm",
                                            "distance_mm", "weight_kg", "sheet", "verdict", "failures"})};
  if (!checks.back().pass) return checks;
  const auto cell = [&](const auto& row, std::string_view column) -> const std::string& {
    return row[static_cast<size_t>(table.column(column))];
  };
  std::vector<std::string> names;
  ValueCheck values;
  const auto passports = by_name(content);
  for (const auto& row : table.rows) {
    const std::string& name = cell(row, "name");
    names.push_back(name);
    const auto found = passports.find(name);
    if (found == passports.end()) continue;
    const PanelPassport& p = *found->second;
    const auto compare = [&](const char* column, std::optional<double> wanted) {
      values.compare(name, column, number_in(cell(row, column)), wanted);
    };
    compare("number", content.model->numbers[static_cast<size_t>(p.panel)]);
    compare("corners", content.model->panels.valence(p.panel));
    compare("area_m2", p.area * kSquareMetres);
    compare("perimeter_mm", p.perimeter);
    compare("width_mm", p.width);
    compare("height_mm", p.height);
    compare("planarity_mm", p.planarity);
    compare("distance_mm", p.distance);
    compare("weight_kg", p.weight);
    values.compare(name, "verdict", cell(row, "verdict"), verdict_of(content, p.panel));
  }
  checks.push_back(names_once(names, content));
  checks.push_back(values.check("values of the passports"));
  return checks;
}

std::vector<Check> check_edge_csv(const CsvTable& table, const ExportContent& content) {
  std::vector<Check> checks{row_count(table.rows.size(), sides_in_all(content), "sides"),
                            columns(table, {"panel", "side", "neighbour", "length_mm", "interior_deg",
                                            "dihedral_deg", "bevel_deg"})};
  if (!checks.back().pass) return checks;
  const auto cell = [&](const auto& row, std::string_view column) -> const std::string& {
    return row[static_cast<size_t>(table.column(column))];
  };
  ValueCheck values;
  const auto passports = by_name(content);
  std::set<std::pair<std::string, size_t>> seen;
  std::vector<std::string> wrong;
  for (const auto& row : table.rows) {
    const std::string& name = cell(row, "panel");
    const auto found = passports.find(name);
    const double number = number_in(cell(row, "side")).value_or(0.0);
    if (found == passports.end() || number < 1.0 ||
        number > static_cast<double>(found->second->sides.size()) ||
        !seen.emplace(name, static_cast<size_t>(number)).second) {
      wrong.push_back(name + " side " + cell(row, "side"));
      continue;
    }
    const SidePassport& side = found->second->sides[static_cast<size_t>(number) - 1];
    const std::string who = name + " side " + cell(row, "side");
    values.compare(who, "neighbour", cell(row, "neighbour"), name_of_panel(content, side.neighbour));
    values.compare(who, "length_mm", number_in(cell(row, "length_mm")), side.length);
    values.compare(who, "interior_deg", number_in(cell(row, "interior_deg")), side.interior);
    values.compare(who, "dihedral_deg", number_in(cell(row, "dihedral_deg")), side.dihedral);
    values.compare(who, "bevel_deg", number_in(cell(row, "bevel_deg")), side.bevel);
  }
  const bool once = wrong.empty() && seen.size() == sides_in_all(content);
  checks.push_back({"every side once", once,
                    counted(static_cast<long long>(seen.size())) + " of " +
                        counted(static_cast<long long>(sides_in_all(content))) + " sides" +
                        (wrong.empty() ? "" : "; twice or of no panel: " + listed(wrong))});
  checks.push_back(values.check("values of the passports"));
  return checks;
}

Result<std::vector<Check>> check_schedule_json(std::string_view text, const ExportContent& content,
                                               const std::string& name) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return fail(ErrorCode::Unreadable, "it is no JSON", name);
  const Json& panels = list_of(json, "panels");
  const std::string unit = json.is_object() ? text_of(json, "unit") : std::string();
  std::vector<Check> checks{
      {"scale", unit == "mm", unit.empty() ? "the file does not say its unit" : "unit " + unit},
      row_count(panels.size(), content.passports->size(), "panels")};
  ValueCheck values, corners;
  std::vector<std::string> names;
  const auto passports = by_name(content);
  for (const Json& panel : panels) {
    names.push_back(panel.is_object() ? text_of(panel, "name") : std::string());
    const auto found = passports.find(names.back());
    if (found == passports.end()) continue;
    const PanelPassport& p = *found->second;
    const std::string& who = names.back();
    values.compare(who, "number", number_of(panel, "number"),
                   content.model->numbers[static_cast<size_t>(p.panel)]);
    values.compare(who, "area_m2", number_of(panel, "area_m2"), p.area * kSquareMetres);
    values.compare(who, "perimeter_mm", number_of(panel, "perimeter_mm"), p.perimeter);
    values.compare(who, "width_mm", number_of(panel, "width_mm"), p.width);
    values.compare(who, "height_mm", number_of(panel, "height_mm"), p.height);
    values.compare(who, "planarity_mm", number_of(panel, "planarity_mm"), p.planarity);
    values.compare(who, "distance_mm", number_of(panel, "distance_mm"), p.distance);
    values.compare(who, "weight_kg", number_of(panel, "weight_kg"), p.weight);
    values.compare(who, "verdict", text_of(panel, "verdict"), verdict_of(content, p.panel));
    compare_sides(panel, p, content, who, values);
    compare_corners(panel, p.panel, content, who, corners);
  }
  checks.push_back(names_once(names, content));
  checks.push_back(values.check("values of the passports"));
  checks.push_back(corners.check("corners"));
  ValueCheck numbers;
  const Json& kept = list_of(json, "names");
  numbers.compare("list", "of names", static_cast<double>(kept.size()), content.model->panel_count());
  std::map<double, std::string> name_of_number;
  for (const Json& entry : kept)
    if (entry.is_object()) name_of_number[number_of(entry, "number").value_or(-1.0)] = text_of(entry, "name");
  for (size_t i = 0; i < content.model->names.size(); ++i)
    numbers.compare(content.model->names[i], "number", name_of_number[content.model->numbers[i]],
                    content.model->names[i]);
  checks.push_back(numbers.check("names by number"));
  return checks;
}

}  // namespace planewright
