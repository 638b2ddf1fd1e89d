#include "ui/export_choice_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace planewright::ui {
namespace {

constexpr double kLargest = 1e6;  // mm, of a sheet

void read(const nlohmann::json& json, const char* key, bool& value) {
  if (const auto found = json.find(key); found != json.end() && found->is_boolean())
    value = found->get<bool>();
}

void read(const nlohmann::json& json, const char* key, double& value, double least, double most = kLargest) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_number()) return;
  const double number = found->get<double>();
  if (std::isfinite(number) && number >= least && number <= most) value = number;
}

}  // namespace

nlohmann::ordered_json to_json(const ExportChoice& choice) {
  nlohmann::ordered_json formats = nlohmann::ordered_json::array();
  for (const ExportFormat format : choice.formats) formats.push_back(std::string(name_of(format)));
  const ExportLayout& layout = choice.layout;
  return {
      {"formats", formats},
      {"dxf", choice.dxf == DxfVersion::R12 ? "r12" : "r2000"},
      {"sheets", layout.sheets},
      {"sheet_width", layout.sheet.width},
      {"sheet_height", layout.sheet.height},
      {"spacing", layout.spacing},
      {"margin", layout.margin},
      {"rotate", layout.rotate},
      {"text_height", layout.text_height},
      {"edge_names", layout.edge_names},
      {"engrave_names", layout.engrave_names},
      {"page", kPages[static_cast<std::size_t>(choice.page)].name},
      {"drawn_by", choice.drawn_by},
      {"refuse_failing", choice.on_failure == OnFailure::Refuse},
  };
}

ExportChoice read_export_choice(const nlohmann::json& json) {
  ExportChoice choice;
  if (!json.is_object()) return choice;
  if (const auto formats = json.find("formats"); formats != json.end() && formats->is_array()) {
    std::set<ExportFormat> known;
    for (const auto& name : *formats)
      for (const ExportFormat format : export_formats())
        if (name.is_string() && name.get_ref<const std::string&>() == name_of(format)) known.insert(format);
    if (!known.empty() || formats->empty()) choice.formats = known;
  }
  if (const auto dxf = json.find("dxf"); dxf != json.end() && *dxf == "r12") choice.dxf = DxfVersion::R12;
  ExportLayout& layout = choice.layout;
  read(json, "sheets", layout.sheets);
  read(json, "sheet_width", layout.sheet.width, 1.0);
  read(json, "sheet_height", layout.sheet.height, 1.0);
  read(json, "spacing", layout.spacing, 0.0);
  read(json, "margin", layout.margin, 0.0);
  read(json, "rotate", layout.rotate);
  read(json, "text_height", layout.text_height, 1.0, 1000.0);
  read(json, "edge_names", layout.edge_names);
  read(json, "engrave_names", layout.engrave_names);
  if (const auto page = json.find("page"); page != json.end())
    for (std::size_t i = 0; i < kPages.size(); ++i)
      if (*page == kPages[i].name) choice.page = static_cast<PageSize>(i);
  if (const auto name = json.find("drawn_by"); name != json.end() && name->is_string())
    choice.drawn_by = name->get<std::string>();
  bool refuse = false;
  read(json, "refuse_failing", refuse);
  if (refuse) choice.on_failure = OnFailure::Refuse;
  return choice;
}

}  // namespace planewright::ui
