#include "core/edit/design_json.h"

#include "core/edit/demands_json.h"

namespace planewright {
namespace {

using Json = nlohmann::json;
using Written = nlohmann::ordered_json;

constexpr std::pair<ComplexKind, const char*> kModes[] = {
    {ComplexKind::Dual, "dual"}, {ComplexKind::Planarize, "planarize"}, {ComplexKind::Cluster, "cluster"}};
constexpr std::pair<BorderPolicy, const char*> kBorders[] = {{BorderPolicy::Closed, "closed"},
                                                             {BorderPolicy::Interior, "interior"}};
constexpr std::pair<Freedom, const char*> kFreedoms[] = {
    {Freedom::Fixed, "fixed"}, {Freedom::Normals, "normals"}, {Freedom::NormalsAndOffsets, "all"}};
constexpr std::pair<Side, const char*> kSides[] = {
    {Side::ByOffset, "by-offset"}, {Side::Outside, "outside"}, {Side::Inside, "inside"}};

Written settings_json(const LayerSettings& settings) {
  Written weights = Written::object();
  for (const auto& [energy, weight] : settings.weights) weights[energy] = weight;
  return {{"mode", word_for<ComplexKind>(settings.mode, kModes)},
          {"offset", settings.offset},
          {"border", word_for<BorderPolicy>(settings.border, kBorders)},
          {"freedom", word_for<Freedom>(settings.freedom, kFreedoms)},
          {"side", word_for<Side>(settings.side, kSides)},
          {"weights", std::move(weights)},
          {"demands", demands_json(settings.demands)},
          {"no_penetration", settings.no_penetration},
          {"max_iterations", settings.max_iterations},
          {"tolerance", settings.tolerance}};
}

void read_weights(JsonReading& reading, JsonObject& settings, std::map<std::string, double>& weights) {
  const Json* json = settings.find("weights");
  if (!json) return;
  weights.clear();
  if (!json->is_object()) return settings.fail("weights", "the weights are no object of names and numbers");
  for (auto weight = json->begin(); weight != json->end(); ++weight) {
    const std::string path = settings.path_of("weights") + "." + weight.key();
    const double value = reading.number(*weight, path);
    if (value < 0.0) reading.fail(path, "the weight is negative", "Give 0 to switch it off");
    weights[weight.key()] = value;
  }
}

LayerSettings read_settings(JsonReading& reading, const Json* json, const std::string& path,
                            const PolygonMesh& mesh) {
  JsonObject object(reading, json, path);
  LayerSettings settings;
  object.read<ComplexKind>("mode", settings.mode, kModes);
  object.read("offset", settings.offset);
  object.read<BorderPolicy>("border", settings.border, kBorders);
  object.read<Freedom>("freedom", settings.freedom, kFreedoms);
  object.read<Side>("side", settings.side, kSides);
  read_weights(reading, object, settings.weights);
  settings.demands =
      read_demands(reading, object.find("demands"), object.path_of("demands"), settings.mode, mesh);
  object.read("no_penetration", settings.no_penetration);
  object.read("max_iterations", settings.max_iterations, 0);
  object.read("tolerance", settings.tolerance);
  if (!(settings.tolerance > 0.0)) object.fail("tolerance", "the tolerance is not positive");
  return settings;
}

Layer read_layer(JsonReading& reading, const Json& json, const std::string& path, int earlier,
                 const PolygonMesh& mesh) {
  JsonObject object(reading, &json, path);
  Layer layer;
  object.read("name", layer.name);
  object.read("visible", layer.visible);
  object.read("thickness", layer.thickness);
  object.read("coplanar_with", layer.coplanar_with, -1, earlier - 1);
  layer.settings = read_settings(reading, object.find("settings"), object.path_of("settings"), mesh);
  return layer;
}

}  // namespace

const std::span<const std::pair<ComplexKind, const char*>> kModeWords = kModes;
const std::span<const std::pair<BorderPolicy, const char*>> kBorderWords = kBorders;

Written design_json(const Design& design) {
  Written layers = Written::array();
  for (const Layer& layer : design.layers)
    layers.push_back({{"name", layer.name},
                      {"visible", layer.visible},
                      {"thickness", layer.thickness},
                      {"coplanar_with", layer.coplanar_with},
                      {"settings", settings_json(layer.settings)}});
  return {{"reference", design.reference},
          {"layers", std::move(layers)},
          {"selections", selections_json(design.selections)}};
}

Design read_design(JsonReading& reading, const Json* json, const std::string& path, const PolygonMesh& mesh) {
  JsonObject object(reading, json, path);
  Design design;
  object.read("reference", design.reference);
  if (const Json* layers = object.find("layers"); layers && reading.list(*layers, object.path_of("layers"))) {
    design.layers.clear();
    for (std::size_t k = 0; k < layers->size() && !reading.failed(); ++k)
      design.layers.push_back(read_layer(reading, (*layers)[k], entry_path(object.path_of("layers"), k),
                                         static_cast<int>(k), mesh));
    if (design.layers.empty()) {
      object.fail("layers", "there is no layer", "Give one at least, or leave the key out");
      design.layers.emplace_back();
    }
  }
  if (const Json* selections = object.find("selections"))
    design.selections = read_selections(reading, *selections, object.path_of("selections"), mesh);
  return design;
}

}  // namespace planewright
