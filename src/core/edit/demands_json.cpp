#include "core/edit/demands_json.h"

#include <algorithm>
#include <set>

namespace planewright {
namespace {

using Json = nlohmann::json;
using Written = nlohmann::ordered_json;

constexpr std::pair<PointKind, const char*> kPointKinds[] = {{PointKind::Face, "face"},
                                                             {PointKind::BorderEdge, "border-edge"},
                                                             {PointKind::Corner, "corner"},
                                                             {PointKind::Vertex, "vertex"}};
constexpr std::pair<ElementKind, const char*> kElementKinds[] = {
    {ElementKind::Point, "point"}, {ElementKind::Panel, "panel"}, {ElementKind::PanelEdge, "panel-edge"}};

int count_of(const PolygonMesh& mesh, PointKind kind) {
  return kind == PointKind::Face         ? mesh.face_count()
         : kind == PointKind::BorderEdge ? mesh.edge_count()
                                         : mesh.vertex_count();
}

Written pin_json(const Pin& pin) {
  Written at = Written::array();
  for (const auto& coordinate : pin.at) at.push_back(coordinate ? Written(*coordinate) : Written());
  return {{"of", word_for<PointKind>(pin.point.kind, kPointKinds)},
          {"element", pin.point.element},
          {"at", std::move(at)}};
}

Written plane_pin_json(const PlanePin& pin) {
  Written json = {{"panel_of", pin.panel_origin}};
  if (pin.plane) {
    json["normal"] = pin.plane->normal;
    json["distance"] = pin.plane->distance;
  }
  return json;
}

Demand read_demand(JsonReading& reading, const Json& json, const std::string& path) {
  JsonObject object(reading, &json, path);
  Demand demand;
  if (object.needed("name")) object.read("name", demand.name);
  object.read("on", demand.on);
  object.read("selection", demand.selection);
  if (const Json* values = object.find("values"))
    demand.values = reading.numbers(*values, object.path_of("values"));
  return demand;
}

Pin read_pin(JsonReading& reading, const Json& json, const std::string& path, const PolygonMesh& mesh) {
  JsonObject object(reading, &json, path);
  Pin pin{{PointKind::Vertex, 0}, {}};
  if (object.needed("of")) object.read<PointKind>("of", pin.point.kind, kPointKinds);
  if (object.needed("element"))
    object.read("element", pin.point.element, 0, count_of(mesh, pin.point.kind) - 1);
  const Json* at = object.needed("at");
  if (!at || !reading.list(*at, object.path_of("at"))) return pin;
  if (at->size() != 3) {
    object.fail("at", "there are " + std::to_string(at->size()) + " coordinates instead of x, y and z",
                "Write null for one that stays free");
    return pin;
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (const Json& value = (*at)[axis]; !value.is_null())
      pin.at[axis] = reading.number(value, entry_path(object.path_of("at"), axis));
  return pin;
}

PlanePin read_plane_pin(JsonReading& reading, const Json& json, const std::string& path, int panels) {
  JsonObject object(reading, &json, path);
  PlanePin pin{0, {}};
  if (object.needed("panel_of")) object.read("panel_of", pin.panel_origin, 0, panels - 1);
  const Json* normal = object.find("normal");
  if (!normal) {
    if (object.find("distance")) object.fail("normal", "a plane has a distance, but no normal");
    return pin;
  }
  const std::vector<double> numbers = reading.numbers(*normal, object.path_of("normal"));
  PlanePin::Equation plane{{0.0, 0.0, 0.0}, 0.0};
  if (numbers.size() == 3) std::copy(numbers.begin(), numbers.end(), plane.normal.begin());
  if (plane.normal == std::array<double, 3>{})
    object.fail("normal", "this is no normal", "Give three numbers that are not all 0");
  if (object.needed("distance")) object.read("distance", plane.distance);
  pin.plane = plane;
  return pin;
}

Waiver read_waiver(JsonReading& reading, const Json& json, const std::string& path) {
  JsonObject object(reading, &json, path);
  Waiver waiver;
  if (object.needed("demand")) object.read("demand", waiver.demand);
  if (object.needed("of")) object.read<ElementKind>("of", waiver.element.kind, kElementKinds);
  if (object.needed("index")) object.read("index", waiver.element.index, 0);
  return waiver;
}

// Entries of a list, each by `read(entry, path)`.
template <class Entry, class Read>
void read_list(JsonReading& reading, JsonObject& object, const char* key, std::vector<Entry>& out,
               const Read& read) {
  const Json* json = object.find(key);
  if (!json || !reading.list(*json, object.path_of(key))) return;
  for (std::size_t k = 0; k < json->size() && !reading.failed(); ++k)
    out.push_back(read((*json)[k], entry_path(object.path_of(key), k)));
}

// Ascending, each once.
std::vector<int> read_elements(JsonReading& reading, JsonObject& object, const char* key, int count) {
  const Json* json = object.find(key);
  if (!json) return {};
  std::vector<int> elements = reading.integers(*json, object.path_of(key), 0, count - 1);
  std::sort(elements.begin(), elements.end());
  elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
  return elements;
}

}  // namespace

Written demands_json(const Demands& demands) {
  Written list = Written::array(), pins = Written::array(), plane_pins = Written::array(),
          waived = Written::array();
  for (const Demand& demand : demands.list)
    list.push_back({{"name", demand.name},
                    {"on", demand.on},
                    {"selection", demand.selection},
                    {"values", demand.values}});
  for (const Pin& pin : demands.pins) pins.push_back(pin_json(pin));
  for (const PlanePin& pin : demands.plane_pins) plane_pins.push_back(plane_pin_json(pin));
  for (const Waiver& waiver : demands.waived)
    waived.push_back({{"demand", waiver.demand},
                      {"of", word_for<ElementKind>(waiver.element.kind, kElementKinds)},
                      {"index", waiver.element.index}});
  return {{"list", std::move(list)},
          {"pins", std::move(pins)},
          {"plane_pins", std::move(plane_pins)},
          {"waived", std::move(waived)},
          {"margin", demands.margin}};
}

Written selections_json(const std::vector<Selection>& selections) {
  Written json = Written::array();
  for (const Selection& selection : selections)
    json.push_back({{"name", selection.name},
                    {"vertices", selection.vertices},
                    {"edges", selection.edges},
                    {"faces", selection.faces}});
  return json;
}

Demands read_demands(JsonReading& reading, const Json* json, const std::string& path, ComplexKind mode,
                     const PolygonMesh& mesh) {
  JsonObject object(reading, json, path);
  Demands demands;
  read_list(reading, object, "list", demands.list,
            [&](const Json& entry, const std::string& place) { return read_demand(reading, entry, place); });
  read_list(reading, object, "pins", demands.pins, [&](const Json& entry, const std::string& place) {
    return read_pin(reading, entry, place, mesh);
  });
  // A dual has a panel for a vertex, the others for a face at most.
  const int panels = mode == ComplexKind::Dual ? mesh.vertex_count() : mesh.face_count();
  read_list(reading, object, "plane_pins", demands.plane_pins,
            [&](const Json& entry, const std::string& place) {
              return read_plane_pin(reading, entry, place, panels);
            });
  read_list(reading, object, "waived", demands.waived,
            [&](const Json& entry, const std::string& place) { return read_waiver(reading, entry, place); });
  object.read_not_negative("margin", demands.margin);
  return demands;
}

std::vector<Selection> read_selections(JsonReading& reading, const Json& json, const std::string& path,
                                       const PolygonMesh& mesh) {
  std::vector<Selection> selections;
  if (!reading.list(json, path)) return selections;
  std::set<std::string> names;
  for (std::size_t k = 0; k < json.size() && !reading.failed(); ++k) {
    JsonObject object(reading, &json[k], entry_path(path, k));
    Selection selection;
    if (object.needed("name")) object.read("name", selection.name);
    selection.vertices = read_elements(reading, object, "vertices", mesh.vertex_count());
    selection.edges = read_elements(reading, object, "edges", mesh.edge_count());
    selection.faces = read_elements(reading, object, "faces", mesh.face_count());
    if (selection.name.empty()) object.fail("name", "the selection has no name");
    if (!names.insert(selection.name).second)
      object.fail("name", "there are two selections '" + selection.name + "'", "Rename one of them");
    selections.push_back(std::move(selection));
  }
  return selections;
}

}  // namespace planewright
