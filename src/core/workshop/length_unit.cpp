#include "core/workshop/length_unit.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace planewright {
namespace {

struct Entry {
  LengthUnit unit;
  double millimetres;
  std::array<std::string_view, 5> names;  // the first is its symbol
};

constexpr std::array<Entry, 5> kUnits{{
    {LengthUnit::Millimetre, 1.0, {"mm", "millimetre", "millimetres", "millimeter", "millimeters"}},
    {LengthUnit::Centimetre, 10.0, {"cm", "centimetre", "centimetres", "centimeter", "centimeters"}},
    {LengthUnit::Metre, 1000.0, {"m", "metre", "metres", "meter", "meters"}},
    {LengthUnit::Inch, 25.4, {"in", "inch", "inches", "\"", "in"}},
    {LengthUnit::Foot, 304.8, {"ft", "foot", "feet", "'", "ft"}},
}};

const Entry& entry(LengthUnit unit) {
  return kUnits[static_cast<std::size_t>(unit)];
}

}  // namespace

const std::vector<LengthUnit>& length_units() {
  static const std::vector<LengthUnit> all = [] {
    std::vector<LengthUnit> units;
    for (const Entry& e : kUnits) units.push_back(e.unit);
    return units;
  }();
  return all;
}

double millimetres_per(LengthUnit unit) {
  return entry(unit).millimetres;
}

std::string_view symbol(LengthUnit unit) {
  return entry(unit).names.front();
}

Result<LengthUnit> parse_length_unit(std::string_view text, std::string where) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const Entry& e : kUnits)
    if (std::find(e.names.begin(), e.names.end(), lower) != e.names.end()) return e.unit;
  return fail(ErrorCode::Usage, "there is no unit of length '" + std::string(text) + "'", std::move(where),
              "use mm, cm, m, in or ft");
}

}  // namespace planewright
