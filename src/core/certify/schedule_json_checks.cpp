#include <algorithm>
#include <limits>
#include <map>

#include "core/certify/json_fields.h"
#include "core/certify/schedule_checks.h"
#include "core/certify/schedule_common.h"
#include "core/certify/schedule_entries.h"
#include "core/certify/schedule_places.h"
#include "core/certify/value_check.h"

namespace planewright {
namespace {

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

// What may be null, but nothing else that is no number.
std::optional<double> number_or_null(const Json& object, const char* key) {
  const auto at = object.find(key);
  if (at != object.end() && at->is_null()) return {};
  return number_of(object, key).value_or(std::numeric_limits<double>::quiet_NaN());
}
// "yes", "no", empty.
std::string yes_or_no(const Json& object, const char* key) {
  const auto at = object.find(key);
  return at == object.end() || !at->is_boolean() ? "" : at->get<bool>() ? "yes" : "no";
}

WrittenEntry entry_of(const Json& panel) {
  WrittenEntry entry{number_or_null(panel, "class"),
                     number_or_null(panel, "sheet"),
                     yes_or_no(panel, "mirrored"),
                     text_of(panel, "verdict"),
                     {}};
  const auto failures = panel.find("failures");
  if (failures == panel.end() || !failures->is_array()) return entry;
  entry.failures.emplace();
  for (const Json& f : *failures)
    if (f.is_object())
      entry.failures->push_back({text_of(f, "kind"), number_or_null(f, "side"), number_or_null(f, "measured"),
                                 number_or_null(f, "limit")});
    else
      entry.failures->push_back({});
  return entry;
}

Check totals(const Json& json, const ExportContent& content) {
  const auto& pass = content.verdicts->pass;
  const auto passed = std::count(pass.begin(), pass.end(), true);
  ValueCheck values;
  const auto compare = [&](const char* key, double wanted) {
    values.compare("panels", key, json.is_object() ? number_of(json, key) : std::nullopt, wanted);
  };
  compare("passed", static_cast<double>(passed));
  compare("failed", static_cast<double>(pass.size()) - static_cast<double>(passed));
  return values.check("totals");
}

Check class_list(const Json& json, const ExportContent& content) {
  ValueCheck values;
  const std::vector<CongruenceClass> none;
  const auto& wanted = content.classes ? *content.classes : none;
  const Json& written = list_of(json, "classes");
  values.compare("classes", "number", static_cast<double>(written.size()),
                 static_cast<double>(wanted.size()));
  for (size_t c = 0; c < std::min(written.size(), wanted.size()); ++c) {
    const auto& members = wanted[c].members;
    const std::string who = "class " + std::to_string(c + 1);
    const size_t count = written[c].is_array() ? written[c].size() : 0;
    values.compare(who, "size", static_cast<double>(count), static_cast<double>(members.size()));
    for (size_t i = 0; i < std::min(count, members.size()); ++i) {
      const Json entry = written[c][i].is_object() ? written[c][i] : Json::object();
      values.compare(who, "panel", text_of(entry, "panel"), name_of_panel(content, members[i].panel));
      values.compare(who, "mirrored", yes_or_no(entry, "mirrored"), members[i].mirrored ? "yes" : "no");
      values.compare(who, "shift", number_of(entry, "shift"), members[i].shift);
      values.compare(who, "deviation_mm", number_of(entry, "deviation_mm"), members[i].deviation);
    }
  }
  return values.check("members of classes");
}

}  // namespace

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
  EntryChecks entries(content);
  std::vector<std::string> names;
  const auto passports = passports_by_name(content);
  for (const Json& panel : panels) {
    names.push_back(panel.is_object() ? text_of(panel, "name") : std::string());
    const auto found = passports.find(names.back());
    if (found == passports.end()) continue;
    const PanelPassport& p = *found->second;
    const std::string& who = names.back();
    values.compare(who, "number", number_of(panel, "number"),
                   content.model->numbers[static_cast<size_t>(p.panel)]);
    values.compare(who, "area_m2", number_of(panel, "area_m2"), p.area * kSquareMetresOfMm2);
    values.compare(who, "perimeter_mm", number_of(panel, "perimeter_mm"), p.perimeter);
    values.compare(who, "width_mm", number_of(panel, "width_mm"), p.width);
    values.compare(who, "height_mm", number_of(panel, "height_mm"), p.height);
    values.compare(who, "planarity_mm", number_of(panel, "planarity_mm"), p.planarity);
    values.compare(who, "distance_mm", number_of(panel, "distance_mm"), p.distance);
    values.compare(who, "weight_kg", number_of(panel, "weight_kg"), p.weight);
    entries.compare(p.panel, entry_of(panel));
    compare_sides(panel, p, content, who, values);
    compare_corners(panel, p.panel, content, who, corners);
  }
  checks.push_back(names_once(names, content));
  checks.push_back(values.check("values of the passports"));
  checks.push_back(corners.check("corners"));
  entries.append_to(checks);
  checks.push_back(totals(json, content));
  checks.push_back(class_list(json, content));
  checks.push_back(check_places(json, content));
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
