#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "core/writers/clean_text.h"
#include "core/writers/schedule_parts.h"
#include "core/writers/schedule_writers.h"

namespace planewright {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "planewright schedule";

// null where there is no finite number.
Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}
Json number(const std::optional<double>& value) {
  return value ? number(*value) : Json();
}

Json contour_json(const Contour& contour) {
  Json list = Json::array();
  for (Eigen::Index i = 0; i < contour.rows(); ++i)
    list.push_back({number(contour(i, 0)), number(contour(i, 1))});
  return list;
}

Json point_json(const Vector3d& p) {
  return {number(p.x()), number(p.y()), number(p.z())};
}

Json sides_json(const ScheduleSources& sources, const PanelPassport& passport) {
  Json list = Json::array();
  for (const SidePassport& side : passport.sides)
    list.push_back(
        {{"neighbour",
          side.neighbour >= 0 ? Json(clean_text(sources.model->names.at(side.neighbour))) : Json()},
         {"length_mm", number(side.length)},
         {"interior_deg", number(side.interior)},
         {"dihedral_deg", number(side.dihedral)},
         {"bevel_deg", number(side.bevel)}});
  return list;
}

Json panel_json(const ScheduleSources& sources, const ScheduleIndex& index, const PanelPassport& passport) {
  const WorkshopModel& model = *sources.model;
  const int p = passport.panel;
  Json corners = Json::array(), failures = Json::array();
  for (const int corner : model.panels[p])
    corners.push_back(point_json(model.points.row(corner).transpose() + model.origin));
  for (const ToleranceFailure* failure : index.failures(p))
    failures.push_back({{"kind", failure_key(failure->kind)},
                        {"side", failure->side >= 0 ? Json(failure->side + 1) : Json()},
                        {"measured", number(failure->measured)},
                        {"limit", number(failure->limit)}});
  Json json{{"name", clean_text(model.names.at(p))},
            {"number", model.numbers.at(p)},
            {"class", index.class_of(p) >= 0 ? Json(index.class_of(p) + 1) : Json()},
            {"mirrored", index.mirrored(p)},
            {"area_m2", number(passport.area * kSquareMetres)},
            {"perimeter_mm", number(passport.perimeter)},
            {"width_mm", number(passport.width)},
            {"height_mm", number(passport.height)},
            {"planarity_mm", number(passport.planarity)},
            {"distance_mm", number(passport.distance)},
            {"weight_kg", number(passport.weight)},
            {"crosses_itself", passport.crosses_itself},
            {"sheet", index.sheet_of(p) >= 0 ? Json(index.sheet_of(p) + 1) : Json()},
            {"verdict", index.verdict(p)},
            {"failures", failures},
            {"outside", point_json(model.normals.row(p))},
            {"corners_mm", corners},
            {"sides", sides_json(sources, passport)}};
  if (sources.patterns) {
    const FlatPattern& pattern = sources.patterns->at(p);
    if (!pattern.empty())
      json["pattern_mm"] = {{"nominal", contour_json(pattern.nominal)},
                            {"outer", contour_json(pattern.outer)},
                            {"inner", contour_json(pattern.inner)},
                            {"cut", contour_json(pattern.cut)},
                            {"up", {number(pattern.up.x()), number(pattern.up.y())}},
                            {"lies_flat", pattern.lies_flat}};
  }
  if (sources.solids) json["has_solid"] = !sources.solids->panels.at(p).empty();
  return json;
}

Json classes_json(const ScheduleSources& sources) {
  Json list = Json::array();
  for (const CongruenceClass& group : *sources.classes) {
    Json members = Json::array();
    for (const CongruenceMember& member : group.members)
      members.push_back({{"panel", clean_text(sources.model->names.at(member.panel))},
                         {"mirrored", member.mirrored},
                         {"shift", member.shift},
                         {"deviation_mm", number(member.deviation)}});
    list.push_back(std::move(members));
  }
  return list;
}

Json nesting_json(const ScheduleSources& sources) {
  if (!sources.nesting) return {};
  const Nesting& nesting = *sources.nesting;
  const auto name = [&](int panel) { return clean_text(sources.model->names.at(panel)); };
  Json sheets = Json::array(), unplaced = Json::array();
  for (const NestedSheet& sheet : nesting.sheets) {
    Json parts = Json::array();
    for (const PlacedPart& part : sheet.parts)
      parts.push_back({{"panel", name(part.panel)},
                       {"rotation_rad", number(part.rotation)},
                       {"shift_mm", {number(part.shift.x()), number(part.shift.y())}}});
    sheets.push_back({{"filled", number(sheet.filled)}, {"parts", std::move(parts)}});
  }
  for (const int panel : nesting.unplaced) unplaced.push_back(name(panel));
  return {{"width_mm", number(nesting.sheet.width)},
          {"height_mm", number(nesting.sheet.height)},
          {"filled", number(nesting.filled)},
          {"unplaced", std::move(unplaced)},
          {"sheets", std::move(sheets)}};
}

tl::unexpected<Error> unreadable(const std::string& name, std::string what) {
  return fail(ErrorCode::Unreadable, std::move(what), name, "Give the schedule (JSON) of an earlier export");
}

}  // namespace

std::string format_schedule_json(const ScheduleSources& sources) {
  const ScheduleIndex index(sources);
  const WorkshopModel& model = *sources.model;
  Json panels = Json::array(), names = Json::array();
  for (const PanelPassport& passport : *sources.passports)
    panels.push_back(panel_json(sources, index, passport));
  for (int p = 0; p < model.panel_count(); ++p)
    names.push_back({{"number", model.numbers.at(p)}, {"name", clean_text(model.names.at(p))}});
  Json warnings = Json::array();
  for (const std::string& warning : model.warnings) warnings.push_back(clean_text(warning));
  const Json json{{"format", kFormat},
                  {"version", 1},
                  {"title", clean_text(model.title)},
                  {"unit", "mm"},
                  {"up", point_json(model.up)},
                  {"thickness_mm", number(sources.thickness)},
                  {"gap_mm", number(sources.gap)},
                  {"passed", sources.verdicts->passed},
                  {"failed", sources.verdicts->failed},
                  {"warnings", warnings},
                  {"names", names},
                  {"classes", classes_json(sources)},
                  {"nesting", nesting_json(sources)},
                  {"panels", panels}};
  return json.dump(1) + '\n';
}

Result<std::vector<std::pair<int, std::string>>> read_kept_names(std::string_view json,
                                                                 const std::string& name) {
  const Json read = Json::parse(json, nullptr, false);
  if (read.is_discarded()) return unreadable(name, "it is not JSON");
  if (!read.is_object() || !read.contains("format") || read["format"] != kFormat)
    return unreadable(name, "it is not a schedule of Planewright's");
  if (!read.contains("version") || read["version"] != 1)
    return unreadable(name, "it is a schedule of another version");
  if (!read.contains("names") || !read["names"].is_array())
    return unreadable(name, "it has no list \"names\"");
  std::vector<std::pair<int, std::string>> kept;
  std::set<int> numbers;
  std::set<std::string> names;
  for (const Json& entry : read["names"]) {
    const std::string place = "entry " + std::to_string(kept.size() + 1) + " of \"names\"";
    if (!entry.is_object() || !entry.contains("number") || !entry["number"].is_number_integer() ||
        !entry.contains("name") || !entry["name"].is_string())
      return unreadable(name, place + " is not a number and a name");
    const auto number = entry["number"].get<std::int64_t>();
    if (number < 0 || number > std::numeric_limits<int>::max())
      return unreadable(name, place + " has a number that is none of a panel");
    std::string text = entry["name"].get<std::string>();
    if (text.empty()) return unreadable(name, place + " has an empty name");
    if (!numbers.insert(static_cast<int>(number)).second)
      return unreadable(name, place + " names panel " + std::to_string(number) + " again");
    if (!names.insert(text).second) return unreadable(name, place + " gives the name \"" + text + "\" again");
    kept.emplace_back(static_cast<int>(number), std::move(text));
  }
  return kept;
}

}  // namespace planewright
