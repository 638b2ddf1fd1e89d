#include "core/fabricate/earlier_export.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"

namespace planewright {
namespace {

namespace fs = std::filesystem;

// Whether a name leads to somewhere below a folder, whatever the certificate says.
bool stays_below(const fs::path& name) {
  return !name.empty() && name.is_relative() &&
         std::none_of(name.begin(), name.end(), [](const fs::path& part) { return part == ".."; });
}

}  // namespace

std::vector<std::string> files_of_earlier_export(const fs::path& folder) {
  const auto text = read_file(folder / kCertificateJson);
  if (!text) return {};
  const auto json = nlohmann::json::parse(*text, nullptr, false);
  if (!json.is_object() || !json.contains("format") || json["format"] != "planewright certificate" ||
      !json.contains("files") || !json["files"].is_array())
    return {};
  std::vector<std::string> files;
  for (const auto& entry : json["files"])
    if (entry.is_object() && entry.contains("file") && entry["file"].is_string())
      files.push_back(entry["file"].get<std::string>());
  files.insert(files.end(), {kCertificateJson, kCertificatePage});
  std::erase_if(files, [&](const std::string& name) {
    std::error_code ignored;
    return !stays_below(name) || !fs::is_regular_file(folder / name, ignored);
  });
  return files;
}

}  // namespace planewright
