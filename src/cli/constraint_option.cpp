#include "cli/constraint_option.h"

#include <charconv>
#include <cmath>
#include <utility>

#include "core/problem/demands/demand_catalogue.h"

namespace planewright::cli {
namespace {

constexpr const char* kOption = "--constraint";

// "offset-band=low:high", or "vertex" for a demand without values.
std::string form(const DemandInfo& info) {
  std::string text = info.name;
  for (size_t k = 0; k < info.parameters.size(); ++k) text += (k == 0 ? "=" : ":") + info.parameters[k].name;
  return text;
}

Result<double> parse_value(const std::string& text, const DemandInfo& info, size_t index) {
  if (text.empty()) return info.parameters[index].default_value;
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    return fail(ErrorCode::Usage,
                "'" + text + "' for " + info.parameters[index].name + " of '" + info.name +
                    "' is not a finite number",
                kOption, "Write " + form(info));
  return value;
}

}  // namespace

Result<Demand> parse_constraint(const std::string& text) {
  Demand demand;
  std::string rest = text;
  if (const size_t at = rest.find('@'); at != std::string::npos) {
    demand.selection = rest.substr(at + 1);
    rest.resize(at);
    if (demand.selection.empty())
      return fail(ErrorCode::Usage, "'" + text + "' names no selection after '@'", kOption,
                  "Leave the '@' out for the whole model");
  }
  const size_t equals = rest.find('=');
  demand.name = rest.substr(0, equals);
  const auto info = find_demand(demand.name);
  if (!info) {
    Error error = info.error();
    error.where = kOption;  // as the user gave it, not as the settings call it
    return tl::unexpected(std::move(error));
  }
  if (equals == std::string::npos) return demand;
  for (size_t begin = equals + 1; begin <= rest.size();) {
    const size_t end = std::min(rest.find(':', begin), rest.size());
    if (demand.values.size() == (*info)->parameters.size())
      return fail(ErrorCode::Usage, "'" + text + "' has more values than the constraint takes", kOption,
                  "Write " + form(**info));
    const auto value = parse_value(rest.substr(begin, end - begin), **info, demand.values.size());
    if (!value) return tl::unexpected(value.error());
    demand.values.push_back(*value);
    begin = end + 1;
  }
  return demand;
}

}  // namespace planewright::cli
