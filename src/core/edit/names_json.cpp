#include "core/edit/names_json.h"

#include <algorithm>
#include <utility>

#include "core/edit/design_json.h"

namespace planewright {
namespace {

using Json = nlohmann::json;
using Written = nlohmann::ordered_json;

Written counts_json(const NumberCounts& counts) {
  return {{"vertices", counts.vertices}, {"edges", counts.edges}, {"faces", counts.faces}};
}

NumberCounts read_counts(JsonReading& reading, JsonObject& parent, const char* key) {
  JsonObject object(reading, parent.needed(key), parent.path_of(key));
  NumberCounts counts;
  if (object.needed("vertices")) object.read("vertices", counts.vertices, 0);
  if (object.needed("edges")) object.read("edges", counts.edges, 0);
  if (object.needed("faces")) object.read("faces", counts.faces, 0);
  return counts;
}

// `count` different numbers of 0..given-1.
std::vector<int> read_numbers(JsonReading& reading, JsonObject& object, const char* key, int count,
                              int given) {
  const Json* json = object.needed(key);
  if (!json) return {};
  std::vector<int> numbers = reading.integers(*json, object.path_of(key), 0, given - 1);
  if (reading.failed()) return {};
  if (numbers.size() != static_cast<std::size_t>(count)) {
    object.fail(
        key, "there are " + std::to_string(numbers.size()) + " numbers instead of " + std::to_string(count));
    return {};
  }
  std::vector<int> sorted = numbers;
  std::sort(sorted.begin(), sorted.end());
  if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
    object.fail(key, "the number " + std::to_string(*twice) + " is given twice");
  return numbers;
}

Written series_json(const PanelSeries& series, const std::map<int, std::string>& names) {
  Written list = Written::array();
  for (const auto& [number, name] : names) {
    Written entry = Written::array();
    entry.push_back(number);
    entry.push_back(name);
    list.push_back(std::move(entry));
  }
  return {{"mode", word_for(series.kind, kModeWords)},
          {"border", word_for(series.border, kBorderWords)},
          {"names", std::move(list)}};
}

std::map<int, std::string> read_series_names(JsonReading& reading, const Json& json,
                                             const std::string& path) {
  std::map<int, std::string> names;
  if (!reading.list(json, path)) return names;
  for (std::size_t k = 0; k < json.size() && !reading.failed(); ++k) {
    const std::string place = entry_path(path, k);
    if (!json[k].is_array() || json[k].size() != 2) {
      reading.fail(place, "this is no pair of a panel's number and its name");
      break;
    }
    const int number = reading.integer(json[k][0], place, 0, std::numeric_limits<int>::max());
    if (!names.emplace(number, reading.text(json[k][1], place)).second)
      reading.fail(place, "panel " + std::to_string(number) + " is named twice");
  }
  if (reading.failed()) return {};
  if (auto checked = check_names(names); !checked) {
    const Error& error = checked.error();
    reading.fail(path, error.what, error.remedy);
  }
  return names;
}

}  // namespace

Written names_json(const ElementNames& names) {
  return {{"opened", counts_json(names.numbering.opened_counts())},
          {"given", counts_json(names.numbering.given())},
          {"vertices", names.ids.vertices},
          {"edges", names.ids.edges},
          {"faces", names.ids.faces},
          {"panels_closed", names.panels.closed()},
          {"panels_interior", names.panels.interior()}};
}

Written given_names_json(const GivenNames& given) {
  Written json = Written::array();
  for (const auto& [series, names] : given) json.push_back(series_json(series, names));
  return json;
}

ElementNames read_names(JsonReading& reading, const Json& json, const std::string& path,
                        const PolygonMesh& mesh) {
  JsonObject object(reading, &json, path);
  const NumberCounts opened = read_counts(reading, object, "opened");
  const NumberCounts given = read_counts(reading, object, "given");
  if (given.vertices < opened.vertices || given.edges < opened.edges || given.faces < opened.faces)
    object.fail("given", "fewer numbers are given than the mesh had elements when it was opened");
  ElementNames names;
  names.ids.vertices = read_numbers(reading, object, "vertices", mesh.vertex_count(), given.vertices);
  names.ids.edges = read_numbers(reading, object, "edges", mesh.edge_count(), given.edges);
  names.ids.faces = read_numbers(reading, object, "faces", mesh.face_count(), given.faces);
  names.numbering = ElementNumbering(opened, given);
  auto closed = read_numbers(reading, object, "panels_closed", opened.vertices, opened.vertices);
  auto interior = read_numbers(reading, object, "panels_interior", opened.vertices, opened.vertices);
  names.panels = PanelNumbers(std::move(closed), std::move(interior));
  return names;
}

GivenNames read_given_names(JsonReading& reading, const Json& json, const std::string& path) {
  GivenNames given;
  if (!reading.list(json, path)) return given;
  for (std::size_t k = 0; k < json.size() && !reading.failed(); ++k) {
    JsonObject object(reading, &json[k], entry_path(path, k));
    LayerSettings layer;
    object.read("mode", layer.mode, kModeWords);
    object.read("border", layer.border, kBorderWords);
    const Json* names = object.needed("names");
    if (!names) break;
    const auto read = read_series_names(reading, *names, object.path_of("names"));
    if (!given.emplace(panel_series(layer), read).second)
      object.fail("names", "the panels of this mode and border are named in an earlier entry, too",
                  "Join both lists");
  }
  return given;
}

}  // namespace planewright
