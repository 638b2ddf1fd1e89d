#include "core/edit/given_names.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "core/edit/element_names.h"

namespace planewright {
namespace {

bool may_stand_in_a_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
         c == '.';
}

}  // namespace

PanelSeries panel_series(const LayerSettings& settings) {
  return {settings.mode, settings.mode == ComplexKind::Dual ? settings.border : BorderPolicy::Closed};
}

Result<void> check_names(const std::map<int, std::string>& names) {
  std::unordered_map<std::string_view, int> number_of;
  for (const auto& [number, name] : names) {
    if (number < 0)
      return fail(ErrorCode::Refused, "there is no panel " + std::to_string(number), {},
                  "Panels are numbered from 0");
    if (name.empty() || !std::all_of(name.begin(), name.end(), may_stand_in_a_name))
      return fail(ErrorCode::Refused, "'" + name + "' is no name for a panel", panel_name(number),
                  "Use letters, digits, '-', '_' and '.'");
    if (const auto [earlier, is_new] = number_of.emplace(name, number); !is_new)
      return fail(ErrorCode::Refused,
                  "panels " + std::to_string(earlier->second) + " and " + std::to_string(number) +
                      " are both called '" + name + "'",
                  panel_name(number), "Give each panel a name of its own");
  }
  return {};
}

Result<void> add_names(GivenNames& given, const PanelSeries& series,
                       const std::map<int, std::string>& names) {
  std::map<int, std::string> all = names;
  if (const auto earlier = given.find(series); earlier != given.end())
    all.insert(earlier->second.begin(), earlier->second.end());
  if (auto checked = check_names(all); !checked) return checked;
  if (!all.empty()) given[series] = std::move(all);
  return {};
}

}  // namespace planewright
