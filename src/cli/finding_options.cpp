#include "cli/finding_options.h"

#include <charconv>
#include <cmath>
#include <set>

namespace planewright::cli {
namespace {

Result<FindingKind> kind_of(const std::string& name, const char* option) {
  auto kind = find_finding_kind(name);
  if (kind) return kind;
  Error error = kind.error();
  error.where = option;
  return tl::unexpected(std::move(error));
}

}  // namespace

void declare_thresholds(CLI::App& command, std::vector<std::string>& thresholds) {
  command
      .add_option("--threshold", thresholds,
                  "Measure beyond which a place is bad, KIND=VALUE in the kind's unit (mean panel edges, "
                  "degrees); may be given several times")
      ->expected(1)
      ->take_all();
}

Result<FindingSettings> parse_finding_settings(const std::vector<std::string>& only,
                                               const std::vector<std::string>& thresholds) {
  FindingSettings settings;
  if (!only.empty())
    for (const FindingKind kind : all_finding_kinds()) settings[kind].on = false;
  for (const std::string& name : only) {
    const auto kind = kind_of(name, "--only");
    if (!kind) return tl::unexpected(kind.error());
    settings[*kind].on = true;
  }
  std::set<FindingKind> given;
  for (const std::string& text : thresholds) {
    const size_t equals = text.find('=');
    if (equals == std::string::npos)
      return fail(ErrorCode::Usage, "'" + text + "' is not of the form KIND=VALUE", "--threshold",
                  "Write for example --threshold close-points=0.1");
    const auto kind = kind_of(text.substr(0, equals), "--threshold");
    if (!kind) return tl::unexpected(kind.error());
    const std::string number = text.substr(equals + 1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (error != std::errc() || end != number.data() + number.size() || !std::isfinite(value) || value < 0.0)
      return fail(ErrorCode::Usage, "the threshold '" + number + "' is not a number of at least 0",
                  "--threshold",
                  std::string("Give it in ") + (info(*kind).unit[0] ? info(*kind).unit : "units of 1"));
    if (!given.insert(*kind).second)
      return fail(ErrorCode::Usage, "'" + text.substr(0, equals) + "' is given twice", "--threshold",
                  "Give each kind once");
    settings[*kind].threshold = value;
  }
  return settings;
}

}  // namespace planewright::cli
