#include "cli/layers_option.h"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <utility>

#include "cli/constraint_option.h"
#include "core/base/atomic_file.h"
#include "core/design/presets.h"
#include "core/problem/energies/energy_catalogue.h"

namespace planewright::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kNameCharacters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";

// The names become parts of file names.
Result<void> check_names(const std::vector<LayerRequest>& layers, ErrorCode code, const std::string& where) {
  if (layers.empty()) return fail(code, "no layer is given", where, "Write for example outer=0.3,inner=-0.2");
  for (size_t k = 0; k < layers.size(); ++k) {
    const std::string& name = layers[k].name;
    if (name.empty() || name.find_first_not_of(kNameCharacters) != std::string::npos)
      return fail(code, "'" + name + "' is no name for a layer", where,
                  "Use letters, digits, '-', '_' and '.', as it becomes part of file names");
    for (size_t j = 0; j < k; ++j)
      if (layers[j].name == name)
        return fail(code, "the layer '" + name + "' is given twice", where,
                    "Give each layer a name of its own");
  }
  return {};
}

Result<std::vector<LayerRequest>> parse_list(const std::string& text) {
  constexpr const char* kForm = "Write for example --layers outer=0.3,inner=-0.2";
  std::vector<LayerRequest> layers;
  std::istringstream stream(text);
  std::string entry;
  while (std::getline(stream, entry, ',')) {
    const size_t equals = entry.find('=');
    if (equals == std::string::npos)
      return fail(ErrorCode::Usage, "'" + entry + "' is not of the form name=offset", "--layers", kForm);
    const std::string number = entry.substr(equals + 1);
    double offset = 0.0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), offset);
    if (error != std::errc() || end != number.data() + number.size() || !std::isfinite(offset))
      return fail(ErrorCode::Usage, "the offset '" + number + "' is not a finite number", "--layers", kForm);
    LayerRequest layer;
    layer.name = entry.substr(0, equals);
    layer.offset = offset;
    layers.push_back(std::move(layer));
  }
  if (auto named = check_names(layers, ErrorCode::Usage, "--layers"); !named)
    return tl::unexpected(named.error());
  return layers;
}

// One layer of a file. `where`: "layers.json, layer 2".
class LayerReader {
 public:
  LayerReader(const std::vector<LayerRequest>& earlier, std::string where)
      : earlier_(earlier), where_(std::move(where)) {}

  Result<LayerRequest> read(const Json& json) {
    if (!json.is_object()) return error("a layer is an object");
    for (const auto& [key, value] : json.items())
      if (auto taken = take(key, value); !taken) return tl::unexpected(taken.error());
    if (layer_.name.empty()) return error("the layer has no name");
    return std::move(layer_);
  }

 private:
  tl::unexpected<Error> error(std::string what, std::string remedy = {}) const {
    return fail(ErrorCode::Unreadable, std::move(what), where_, std::move(remedy));
  }
  // An error of a parser that knows nothing of this file.
  Result<void> from(Error cause) const {
    cause.code = ErrorCode::Unreadable;
    cause.where = where_;
    return tl::unexpected(std::move(cause));
  }

  Result<void> take(const std::string& key, const Json& value) {
    const struct {
      const char* key;
      Result<void> (LayerReader::*take)(const Json&);
    } known[] = {{"name", &LayerReader::take_name},
                 {"offset", &LayerReader::take_offset},
                 {"thickness", &LayerReader::take_thickness},
                 {"margin", &LayerReader::take_margin},
                 {"side", &LayerReader::take_side},
                 {"no_penetration", &LayerReader::take_no_penetration},
                 {"preset", &LayerReader::take_preset},
                 {"weights", &LayerReader::take_weights},
                 {"constraints", &LayerReader::take_constraints},
                 {"coplanar_with", &LayerReader::take_coplanar_with}};
    std::string keys;
    for (const auto& entry : known) {
      if (key == entry.key) return (this->*entry.take)(value);
      keys += (keys.empty() ? "" : ", ") + std::string(entry.key);
    }
    return error("a layer has no '" + key + "'", "Known: " + keys);
  }

  Result<double> number(const char* key, const Json& value) const {
    if (!value.is_number() || !std::isfinite(value.get<double>()))
      return error(std::string("'") + key + "' is not a finite number: " + value.dump());
    return value.get<double>();
  }
  Result<std::string> string(const char* key, const Json& value) const {
    if (!value.is_string()) return error(std::string("'") + key + "' is not a text: " + value.dump());
    return value.get<std::string>();
  }

  Result<void> take_name(const Json& value) {
    return string("name", value).map([&](std::string&& text) { layer_.name = std::move(text); });
  }
  Result<void> take_offset(const Json& value) {
    return number("offset", value).map([&](double offset) { layer_.offset = offset; });
  }
  Result<void> take_thickness(const Json& value) {
    return number("thickness", value).map([&](double thickness) { layer_.thickness = thickness; });
  }
  Result<void> take_margin(const Json& value) {
    const auto margin = number("margin", value);
    if (!margin) return tl::unexpected(margin.error());
    if (*margin < 0.0) return error("'margin' is negative");
    layer_.steering.margin = *margin;
    return {};
  }
  Result<void> take_side(const Json& value) {
    if (value == "outside")
      layer_.steering.side = Side::Outside;
    else if (value == "inside")
      layer_.steering.side = Side::Inside;
    else
      return error("'side' is neither \"outside\" nor \"inside\": " + value.dump());
    return {};
  }
  Result<void> take_no_penetration(const Json& value) {
    if (!value.is_boolean()) return error("'no_penetration' is neither true nor false: " + value.dump());
    layer_.steering.no_penetration = value.get<bool>();
    return {};
  }
  Result<void> take_preset(const Json& value) {
    const auto text = string("preset", value);
    if (!text) return tl::unexpected(text.error());
    if (auto preset = find_preset(*text); !preset) return from(preset.error());
    layer_.steering.preset = *text;
    return {};
  }
  Result<void> take_weights(const Json& value) {
    if (!value.is_object()) return error("'weights' is no object of names and numbers");
    for (const auto& [energy, json] : value.items()) {
      if (auto known = find_energy(energy); !known) return from(known.error());
      const auto weight = number(energy.c_str(), json);
      if (!weight) return tl::unexpected(weight.error());
      if (*weight < 0.0)
        return error("the weight of '" + energy + "' is negative", "Give 0 to switch it off");
      layer_.steering.weights[energy] = *weight;
    }
    return {};
  }
  Result<void> take_constraints(const Json& value) {
    if (!value.is_array()) return error("'constraints' is no list");
    for (const Json& json : value) {
      const auto text = string("constraints", json);
      if (!text) return tl::unexpected(text.error());
      auto demand = parse_constraint(*text);
      if (!demand) return from(demand.error());
      layer_.steering.demands.push_back(std::move(*demand));
    }
    return {};
  }
  Result<void> take_coplanar_with(const Json& value) {
    const auto text = string("coplanar_with", value);
    if (!text) return tl::unexpected(text.error());
    for (size_t k = 0; k < earlier_.size(); ++k)
      if (earlier_[k].name == *text) layer_.coplanar_with = static_cast<int>(k);
    if (layer_.coplanar_with < 0)
      return error("'coplanar_with' names no earlier layer: '" + *text + "'",
                   "Put that layer before this one");
    return {};
  }

  const std::vector<LayerRequest>& earlier_;
  std::string where_;
  LayerRequest layer_;
};

Result<std::vector<LayerRequest>> parse_layers_file(const std::string& path) {
  const auto content = read_file(path);
  if (!content) return tl::unexpected(content.error());
  Json json;
  try {
    json = Json::parse(*content);
  } catch (const Json::exception& wrong) {  // besides its grammar also a number that no double holds
    return fail(ErrorCode::Unreadable, std::string("the file cannot be read as JSON: ") + wrong.what(), path);
  }
  if (!json.is_object() || json.size() != 1 || !json.contains("layers") || !json["layers"].is_array())
    return fail(ErrorCode::Unreadable, "the file is not of the form {\"layers\": [...]}", path,
                "Give one object per layer in the list 'layers'");
  std::vector<LayerRequest> layers;
  for (const Json& entry : json["layers"]) {
    auto layer = LayerReader(layers, path + ", layer " + std::to_string(layers.size() + 1)).read(entry);
    if (!layer) return tl::unexpected(layer.error());
    layers.push_back(std::move(*layer));
  }
  if (auto named = check_names(layers, ErrorCode::Unreadable, path); !named)
    return tl::unexpected(named.error());
  return layers;
}

}  // namespace

Result<std::vector<LayerRequest>> parse_layers(const std::string& spec) {
  return spec.ends_with(".json") ? parse_layers_file(spec) : parse_list(spec);
}

}  // namespace planewright::cli
