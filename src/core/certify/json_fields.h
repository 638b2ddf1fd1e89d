// Fields of JSON that may be missing, or other than they should. Internal to certify/. Threads: pure.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace planewright {

using Json = nlohmann::json;

inline std::optional<double> number_of(const Json& object, const char* key) {
  const auto at = object.find(key);
  if (at == object.end() || !at->is_number()) return {};
  return at->get<double>();
}
inline std::string text_of(const Json& object, const char* key) {
  const auto at = object.find(key);
  return at != object.end() && at->is_string() ? at->get<std::string>() : std::string();
}
inline const Json& list_of(const Json& object, const char* key) {
  static const Json none = Json::array();
  const auto at = object.is_object() ? object.find(key) : object.end();
  return object.is_object() && at != object.end() && at->is_array() ? *at : none;
}
inline std::optional<double> number_at(const Json& list, size_t i) {
  if (i >= list.size() || !list[i].is_number()) return {};
  return list[i].get<double>();
}

}  // namespace planewright
