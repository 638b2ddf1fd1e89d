#include "core/certify/schedule_checks.h"

#include <limits>
#include <set>

#include "core/certify/check_text.h"
#include "core/certify/schedule_common.h"
#include "core/certify/schedule_entries.h"
#include "core/certify/value_check.h"

namespace planewright {
namespace {

size_t sides_in_all(const ExportContent& content) {
  size_t all = 0;
  for (const PanelPassport& p : *content.passports) all += p.sides.size();
  return all;
}

Check columns(const CsvTable& table, const std::vector<std::string>& wanted) {
  std::vector<std::string> missing;
  for (const std::string& c : wanted)
    if (table.column(c) < 0) missing.push_back(c);
  return {"columns", missing.empty(),
          missing.empty() ? counted(static_cast<long long>(wanted.size())) + ", units in their names"
                          : "missing: " + listed(missing)};
}

// A cell that may be empty, but nothing else that is no number.
std::optional<double> count_in(const std::string& cell) {
  if (cell.empty()) return {};
  return number_in(cell).value_or(std::numeric_limits<double>::quiet_NaN());
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
  EntryChecks entries(content);
  const auto passports = passports_by_name(content);
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
    compare("area_m2", p.area * kSquareMetresOfMm2);
    compare("perimeter_mm", p.perimeter);
    compare("width_mm", p.width);
    compare("height_mm", p.height);
    compare("planarity_mm", p.planarity);
    compare("distance_mm", p.distance);
    compare("weight_kg", p.weight);
    entries.compare(p.panel,
                    {count_in(cell(row, "class")), count_in(cell(row, "sheet")), cell(row, "mirrored"),
                     cell(row, "verdict"), failures_in(cell(row, "failures"))});
  }
  checks.push_back(names_once(names, content));
  checks.push_back(values.check("values of the passports"));
  entries.append_to(checks);
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
  const auto passports = passports_by_name(content);
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

}  // namespace planewright
