#include "core/edit/contract_json.h"

namespace planewright {
namespace {

using Json = nlohmann::json;
using Written = nlohmann::ordered_json;

constexpr std::pair<NameStyle, const char*> kStyles[] = {{NameStyle::RowLetter, "row-letter"},
                                                         {NameStyle::Plain, "plain"}};

}  // namespace

Written contract_json(const WorkshopContract& contract) {
  return {{"unit", symbol(contract.unit)},   {"tolerances", Written::parse(to_json(contract.tolerances))},
          {"thickness", contract.thickness}, {"gap", contract.gap},
          {"density", contract.density},     {"names", word_for<NameStyle>(contract.names, kStyles)}};
}

WorkshopContract read_contract(JsonReading& reading, const Json* json, const std::string& path) {
  JsonObject object(reading, json, path);
  WorkshopContract contract;
  std::string unit(symbol(contract.unit));
  object.read("unit", unit);
  if (auto known = parse_length_unit(unit, reading.file() + ", " + object.path_of("unit"))) {
    contract.unit = *known;
  } else {
    Error error = known.error();
    error.code = ErrorCode::Unreadable;
    reading.fail(std::move(error));
  }
  if (const Json* sheet = object.find("tolerances")) {
    auto tolerances =
        read_tolerance_sheet(sheet->dump(), reading.file() + ", " + object.path_of("tolerances"));
    if (tolerances)
      contract.tolerances = *tolerances;
    else
      reading.fail(tolerances.error());
  }
  object.read_not_negative("thickness", contract.thickness);
  object.read_not_negative("gap", contract.gap);
  object.read_not_negative("density", contract.density);
  object.read<NameStyle>("names", contract.names, kStyles);
  return contract;
}

}  // namespace planewright
