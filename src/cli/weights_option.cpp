#include "cli/weights_option.h"

#include <charconv>
#include <cmath>
#include <sstream>
#include <utility>

#include "core/problem/energies/energy_catalogue.h"

namespace planewright::cli {

Result<std::map<std::string, double>> parse_weights(const std::string& text) {
  std::map<std::string, double> weights;
  std::istringstream stream(text);
  std::string entry;
  while (std::getline(stream, entry, ',')) {
    const size_t equals = entry.find('=');
    if (equals == std::string::npos)
      return fail(ErrorCode::Usage, "'" + entry + "' is not of the form name=value", "--weights",
                  "Write for example --weights position=1,fairing=0.1");
    const std::string name = entry.substr(0, equals), number = entry.substr(equals + 1);
    if (auto known = find_energy(name); !known) {
      Error error = known.error();
      error.where = "--weights";  // as the user gave it, not as the settings call it
      return tl::unexpected(std::move(error));
    }
    double value = 0.0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (error != std::errc() || end != number.data() + number.size() || !std::isfinite(value) || value < 0.0)
      return fail(ErrorCode::Usage,
                  "the weight '" + number + "' of '" + name + "' is not a number of at least 0", "--weights",
                  "Give 0 to switch an energy off");
    if (!weights.emplace(name, value).second)
      return fail(ErrorCode::Usage, "'" + name + "' is given twice", "--weights", "Give each energy once");
  }
  return weights;
}

}  // namespace planewright::cli
