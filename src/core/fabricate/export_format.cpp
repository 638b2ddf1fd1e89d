// The formats by name.
#include <algorithm>
#include <array>
#include <utility>

#include "core/fabricate/export_run.h"

namespace planewright {
namespace {

constexpr std::array<std::pair<ExportFormat, std::string_view>, 10> kFormats{{
    {ExportFormat::Dxf, "dxf"},
    {ExportFormat::Svg, "svg"},
    {ExportFormat::Pdf, "pdf"},
    {ExportFormat::Csv, "csv"},
    {ExportFormat::Json, "json"},
    {ExportFormat::Obj, "obj"},
    {ExportFormat::Ply, "ply"},
    {ExportFormat::Stl, "stl"},
    {ExportFormat::ThreeMf, "3mf"},
    {ExportFormat::Gltf, "gltf"},
}};

}  // namespace

const std::vector<ExportFormat>& export_formats() {
  static const std::vector<ExportFormat> all = [] {
    std::vector<ExportFormat> formats;
    for (const auto& [format, name] : kFormats) formats.push_back(format);
    return formats;
  }();
  return all;
}

std::string_view name_of(ExportFormat format) {
  return kFormats[static_cast<std::size_t>(format)].second;
}

Result<std::set<ExportFormat>> parse_export_formats(const std::vector<std::string>& names,
                                                    std::string where) {
  std::set<ExportFormat> formats;
  for (const std::string& name : names) {
    if (name == "all") {
      formats.insert(export_formats().begin(), export_formats().end());
      continue;
    }
    const auto found = std::find_if(kFormats.begin(), kFormats.end(),
                                    [&](const auto& entry) { return entry.second == name; });
    if (found == kFormats.end()) {
      std::string known;
      for (const auto& entry : kFormats) known += std::string(entry.second) + ", ";
      return fail(ErrorCode::Usage, "there is no format '" + name + "'", std::move(where),
                  "use some of " + known + "or all");
    }
    formats.insert(found->first);
  }
  return formats;
}

}  // namespace planewright
