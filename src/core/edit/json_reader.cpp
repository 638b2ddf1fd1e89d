#include "core/edit/json_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace planewright {
namespace {

using Json = nlohmann::json;

// "a list", of what stands where something else should.
const char* described(const Json& json) {
  switch (json.type()) {
    case Json::value_t::null:
      return "null";
    case Json::value_t::object:
      return "an object";
    case Json::value_t::array:
      return "a list";
    case Json::value_t::string:
      return "a text";
    case Json::value_t::boolean:
      return "true or false";
    default:
      return "a number";
  }
}

std::string instead(const Json& json, const std::string& wanted) {
  return "there is " + std::string(described(json)) + " instead of " + wanted;
}

}  // namespace

std::string entry_path(const std::string& path, std::size_t index) {
  return path + "[" + std::to_string(index) + "]";
}

void JsonReading::fail(const std::string& path, std::string what, std::string remedy) {
  fail({ErrorCode::Unreadable, std::move(what), path.empty() ? file_ : file_ + ", " + path,
        remedy.empty() ? "Correct it, or take the file from a backup" : std::move(remedy)});
}

void JsonReading::fail(Error error) {
  if (!error_) error_ = std::move(error);
}

void JsonReading::warn(const std::string& path, const std::string& what) {
  warnings_.push_back((path.empty() ? file_ : file_ + ", " + path) + ": " + what);
}

double JsonReading::number(const Json& json, const std::string& path) {
  if (!json.is_number()) {
    fail(path, instead(json, "a number"),
         json.is_null() ? "Give a finite number; JSON has no NaN and no infinity" : "");
    return 0.0;
  }
  return json.get<double>();  // finite: the parser refuses others
}

int JsonReading::integer(const Json& json, const std::string& path, int low, int high) {
  if (!json.is_number_integer()) {
    fail(path, instead(json, "a whole number"));
    return low;
  }
  const bool fits = json.is_number_unsigned()
                        ? std::cmp_less_equal(json.get<std::uint64_t>(), high) &&
                              std::cmp_greater_equal(json.get<std::uint64_t>(), low)
                        : json.get<std::int64_t>() >= low && json.get<std::int64_t>() <= high;
  if (!fits) {
    fail(path, json.dump() + " is out of range",
         high < low ? std::string("There is nothing that it could name")
         : high == std::numeric_limits<int>::max()
             ? "Give " + std::to_string(low) + " or more"
             : "Give a number from " + std::to_string(low) + " to " + std::to_string(high));
    return low;
  }
  return json.get<int>();
}

std::string JsonReading::text(const Json& json, const std::string& path) {
  if (json.is_string()) return json.get<std::string>();
  fail(path, instead(json, "a text"));
  return {};
}

const Json* JsonReading::list(const Json& json, const std::string& path) {
  if (json.is_array()) return &json;
  fail(path, instead(json, "a list"));
  return nullptr;
}

std::vector<double> JsonReading::numbers(const Json& json, const std::string& path) {
  std::vector<double> values;
  if (!list(json, path)) return values;
  values.reserve(json.size());
  for (std::size_t k = 0; k < json.size() && !failed(); ++k)
    values.push_back(json[k].is_number() ? json[k].get<double>() : number(json[k], entry_path(path, k)));
  return values;
}

std::vector<int> JsonReading::integers(const Json& json, const std::string& path, int low, int high) {
  std::vector<int> values;
  if (!list(json, path)) return values;
  values.reserve(json.size());
  for (std::size_t k = 0; k < json.size() && !failed(); ++k)
    values.push_back(integer(json[k], entry_path(path, k), low, high));
  return values;
}

Points JsonReading::points(const Json& json, const std::string& path) {
  Points points(0, 3);
  if (!list(json, path)) return points;
  points.resize(static_cast<Eigen::Index>(json.size()), 3);
  for (std::size_t k = 0; k < json.size() && !failed(); ++k) {
    const std::vector<double> row = numbers(json[k], entry_path(path, k));
    if (!failed() && row.size() != 3)
      fail(entry_path(path, k), "there are " + std::to_string(row.size()) + " numbers instead of x, y and z");
    if (failed()) break;
    for (int axis = 0; axis < 3; ++axis)
      points(static_cast<Eigen::Index>(k), axis) = row[static_cast<std::size_t>(axis)];
  }
  return points;
}

JsonObject::JsonObject(JsonReading& reading, const Json* json, std::string path)
    : reading_(reading), json_(json), path_(std::move(path)) {
  if (json_ && !json_->is_object()) {
    reading_.fail(path_, instead(*json_, "an object"));
    json_ = nullptr;
  }
}

JsonObject::~JsonObject() {
  if (!json_ || reading_.failed()) return;
  for (auto member = json_->begin(); member != json_->end(); ++member)
    if (!known_.contains(member.key()))
      reading_.warn(path_of(member.key()), "this program does not know the key and leaves it out");
}

std::string JsonObject::path_of(std::string_view key) const {
  return path_.empty() ? std::string(key) : path_ + "." + std::string(key);
}

const Json* JsonObject::find(const char* key) {
  known_.insert(key);
  if (!json_) return nullptr;
  const auto member = json_->find(key);
  return member == json_->end() ? nullptr : &*member;
}

const Json* JsonObject::needed(const char* key) {
  const Json* json = find(key);
  if (!json) fail(key, "the key is missing");
  return json;
}

void JsonObject::fail(std::string_view key, std::string what, std::string remedy) {
  reading_.fail(path_of(key), std::move(what), std::move(remedy));
}

void JsonObject::read(const char* key, double& value) {
  if (const Json* json = find(key)) value = reading_.number(*json, path_of(key));
}

void JsonObject::read(const char* key, bool& value) {
  const Json* json = find(key);
  if (!json) return;
  if (json->is_boolean())
    value = json->get<bool>();
  else
    fail(key, instead(*json, "true or false"));
}

void JsonObject::read(const char* key, std::string& value) {
  if (const Json* json = find(key)) value = reading_.text(*json, path_of(key));
}

void JsonObject::read(const char* key, int& value, int low, int high) {
  if (const Json* json = find(key)) value = reading_.integer(*json, path_of(key), low, high);
}

void JsonObject::read_not_negative(const char* key, double& value) {
  read(key, value);
  if (!(value >= 0.0)) fail(key, "the number is negative", "Give 0 or more");
}

}  // namespace planewright
