// Tolerance sheets as JSON: every key says its unit.
#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "core/workshop/nearest_word.h"
#include "core/workshop/tolerance_sheet.h"

namespace planewright {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "planewright tolerances";
constexpr int kVersion = 1;

struct Entry {
  const char* key;
  std::optional<double> ToleranceSheet::*value;
  double largest;  // infinity: none
};

constexpr double kNoLargest = std::numeric_limits<double>::infinity();

constexpr std::array<Entry, 10> kEntries{{
    {"planarity_mm", &ToleranceSheet::planarity, kNoLargest},
    {"distance_mm", &ToleranceSheet::distance, kNoLargest},
    {"edge_min_mm", &ToleranceSheet::edge_min, kNoLargest},
    {"edge_max_mm", &ToleranceSheet::edge_max, kNoLargest},
    {"area_min_m2", &ToleranceSheet::area_min, kNoLargest},
    {"area_max_m2", &ToleranceSheet::area_max, kNoLargest},
    {"interior_min_deg", &ToleranceSheet::interior_min, 360.0},
    {"interior_max_deg", &ToleranceSheet::interior_max, 360.0},
    {"dihedral_min_deg", &ToleranceSheet::dihedral_min, 360.0},
    {"dihedral_max_deg", &ToleranceSheet::dihedral_max, 360.0},
}};
constexpr const char* kStock = "stock_mm";

std::vector<std::string> known_keys() {
  std::vector<std::string> keys{"format", "version"};
  for (const Entry& entry : kEntries) keys.emplace_back(entry.key);
  keys.emplace_back(kStock);
  return keys;
}

tl::unexpected<Error> unreadable(const std::string& name, const std::string& key, std::string what,
                                 std::string remedy = {}) {
  return fail(ErrorCode::Unreadable, std::move(what), key.empty() ? name : name + ": '" + key + "'",
              std::move(remedy));
}

// nlohmann's messages begin with "[json.exception.parse_error.101] ".
std::string message(const std::exception& error) {
  const std::string text = error.what();
  const size_t end = text.find("] ");
  return end == std::string::npos ? text : text.substr(end + 2);
}

// The whole text, which has to be one object; a key that comes twice is an error as well.
Result<Json> parse_object(std::string_view text, const std::string& name) {
  std::set<std::string> seen;
  std::string twice;
  const auto watch = [&](int depth, Json::parse_event_t event, Json& parsed) {
    if (depth == 1 && event == Json::parse_event_t::key) {
      const auto key = parsed.get<std::string>();
      if (!seen.insert(key).second && twice.empty()) twice = key;
    }
    return true;
  };
  Json json;
  try {
    json = Json::parse(text.begin(), text.end(), watch);
  } catch (const Json::exception& error) {
    return unreadable(name, "", "this is no JSON: " + message(error));
  }
  if (!json.is_object()) return unreadable(name, "", "a tolerance sheet is one JSON object, in braces");
  if (!twice.empty()) return unreadable(name, twice, "the key comes twice", "Take one of them out");
  return json;
}

Result<void> check_heading(const Json& json, const std::string& name) {
  const auto format = json.find("format");
  if (format == json.end() || !format->is_string() || format->get<std::string>() != kFormat)
    return unreadable(name, "format", "this is no tolerance sheet",
                      "One has \"format\": \"" + std::string(kFormat) + "\"");
  const auto version = json.find("version");
  if (version == json.end() || !version->is_number_integer() || version->get<long long>() != kVersion)
    return unreadable(name, "version", "the version of the sheet has to be " + std::to_string(kVersion));
  const std::vector<std::string> known = known_keys();
  for (const auto& [key, value] : json.items())
    if (std::find(known.begin(), known.end(), key) == known.end())
      return unreadable(name, key, "there is no such tolerance",
                        "The nearest is '" + nearest_word(key, known) + "'");
  return {};
}

Result<double> read_number(const Json& value, const std::string& name, const std::string& key) {
  if (!value.is_number())
    return unreadable(name, key, "the value is no number",
                      "Leave the key out where nothing is to be checked");
  const double number = value.get<double>();
  if (!std::isfinite(number)) return unreadable(name, key, "the number is not finite");
  if (number < 0.0) return unreadable(name, key, value.dump() + " is negative");
  return number;
}

Result<std::optional<double>> read_entry(const Json& json, const std::string& name, const Entry& entry) {
  const auto found = json.find(entry.key);
  if (found == json.end()) return std::optional<double>();
  const auto number = read_number(*found, name, entry.key);
  if (!number) return tl::unexpected(number.error());
  if (*number > entry.largest)
    return unreadable(name, entry.key, found->dump() + " is more than the whole round, 360 degrees");
  return std::optional<double>(*number);
}

Result<SheetSize> read_stock(const Json& value, const std::string& name) {
  if (!value.is_array() || value.size() != 2)
    return unreadable(name, kStock, "a stock size is two lengths", "Write [3210, 6000]");
  std::array<double, 2> sides{};
  for (size_t i = 0; i < 2; ++i) {
    const auto side = read_number(value[i], name, kStock);
    if (!side) return tl::unexpected(side.error());
    if (!(*side > 0.0))
      return unreadable(name, kStock, "a sheet without " + std::string(i == 0 ? "width" : "height"));
    sides[i] = *side;
  }
  return SheetSize{sides[0], sides[1]};
}

}  // namespace

std::string to_json(const ToleranceSheet& sheet) {
  Json json{{"format", kFormat}, {"version", kVersion}};
  for (const Entry& entry : kEntries)
    if (sheet.*entry.value) json[entry.key] = *(sheet.*entry.value);
  if (sheet.stock) json[kStock] = {sheet.stock->width, sheet.stock->height};
  return json.dump(2) + "\n";
}

Result<ToleranceSheet> read_tolerance_sheet(std::string_view text, const std::string& name) {
  const auto json = parse_object(text, name);
  if (!json) return tl::unexpected(json.error());
  if (auto heading = check_heading(*json, name); !heading) return tl::unexpected(std::move(heading.error()));
  ToleranceSheet sheet;
  for (const Entry& entry : kEntries) {
    const auto value = read_entry(*json, name, entry);
    if (!value) return tl::unexpected(value.error());
    sheet.*entry.value = *value;
  }
  for (size_t low = 2; low < kEntries.size(); low += 2) {
    const auto &least = sheet.*kEntries[low].value, &most = sheet.*kEntries[low + 1].value;
    if (least && most && *least > *most)
      return unreadable(name, kEntries[low].key,
                        "the minimum is above the maximum, '" + std::string(kEntries[low + 1].key) + "'");
  }
  if (const auto stock = json->find(kStock); stock != json->end()) {
    const auto size = read_stock(*stock, name);
    if (!size) return tl::unexpected(size.error());
    sheet.stock = *size;
  }
  return sheet;
}

}  // namespace planewright
