#include "core/edit/project_file.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <memory>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/edit/clusters_json.h"
#include "core/edit/contract_json.h"
#include "core/edit/design_json.h"
#include "core/edit/json_reader.h"
#include "core/edit/json_text.h"
#include "core/edit/mesh_json.h"
#include "core/edit/names_json.h"
#include "core/edit/solved_json.h"

namespace planewright {
namespace {

using Json = nlohmann::json;
using Written = nlohmann::ordered_json;

constexpr std::size_t kLargestFile = std::numeric_limits<int>::max();
constexpr const char* kTooLarge = "project files of more than 2 GB are not read";

// Nothing else is looked at in a file that is not ours to read.
bool read_heading(JsonReading& reading, JsonObject& file) {
  const Json* format = file.find("format");
  if (!format || *format != kProjectFormat) {
    reading.fail("format", "the file is no project of Planewright",
                 "Its key 'format' has to say \"" + std::string(kProjectFormat) + "\"");
    return false;
  }
  int version = 0;
  if (file.needed("version")) file.read("version", version, 1);
  if (!reading.failed() && version > kProjectVersion)
    file.fail("version",
              "the project is of version " + std::to_string(version) + ", but this program reads up to " +
                  std::to_string(kProjectVersion),
              "Open it with a newer Planewright");
  return !reading.failed();
}

SharedClusters remade(JsonReading& reading, const Project& project) {
  auto made = clusters_of(std::make_shared<const PolygonMesh>(project.mesh), *project.clusters);
  if (made) return *made;
  const Error& error = made.error();
  reading.fail("clusters", error.where.empty() ? error.what : error.where + ": " + error.what, error.remedy);
  return nullptr;
}

Project read_parts(JsonReading& reading, JsonObject& file) {
  Project project;
  file.read("name", project.name);
  const Json* mesh = file.needed("mesh");
  if (mesh) project.mesh = read_mesh(reading, *mesh, "mesh");
  const Json *design = file.find("design"), *contract = file.find("workshop"), *names = file.find("numbers"),
             *given = file.find("panel_names"), *clusters = file.find("clusters"),
             *solved = file.find("solved");
  if (reading.failed()) return project;  // the rest is about the mesh
  project.design = read_design(reading, design, "design", project.mesh);
  project.contract = read_contract(reading, contract, "workshop");
  project.names =
      names ? read_names(reading, *names, "numbers", project.mesh) : names_of_opened(project.mesh);
  if (given) project.given_names = read_given_names(reading, *given, "panel_names");
  SharedClusters made;
  if (clusters && !reading.failed()) {
    project.clusters = read_clusters(reading, *clusters, "clusters", project.mesh.face_count());
    if (!reading.failed()) made = remade(reading, project);
  }
  if (!reading.failed())
    project.solved =
        read_solved(reading, solved, "solved", project.mesh, made ? &made->regions : nullptr, project.design);
  return project;
}

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace

Result<std::string> format_project(const Project& project) {
  Written json = {{"format", kProjectFormat},
                  {"version", kProjectVersion},
                  {"name", project.name},
                  {"workshop", contract_json(project.contract)},
                  {"design", design_json(project.design)},
                  {"mesh", mesh_json(project.mesh)}};
  if (project.names != names_of_opened(project.mesh)) json["numbers"] = names_json(project.names);
  if (!project.given_names.empty()) json["panel_names"] = given_names_json(project.given_names);
  if (project.clusters) json["clusters"] = clusters_json(*project.clusters);
  if (Written solved = solved_json(project.solved); !solved.empty()) json["solved"] = std::move(solved);
  return json_text(json);
}

Result<ReadProject> read_project(std::string_view text, const std::string& name) {
  if (text.find_first_not_of(" \t\r\n") == text.npos)
    return fail(ErrorCode::Unreadable, "the file is empty", name, "Take it from a backup, or save it again");
  if (text.size() > kLargestFile)
    return fail(ErrorCode::Unreadable, kTooLarge, name, "Split the design into smaller parts");
  const auto json = parse_json(text, name);
  if (!json) return tl::unexpected(json.error());
  JsonReading reading(name);
  ReadProject result;
  {
    JsonObject file(reading, &*json, {});
    if (!reading.failed() && read_heading(reading, file)) result.project = read_parts(reading, file);
  }
  if (reading.failed()) return tl::unexpected(*reading.error());
  if (result.project.name.empty()) result.project.name = std::filesystem::path(name).stem().string();
  result.warnings = reading.take_warnings();
  return result;
}

Result<void> save_project(const std::filesystem::path& path, const Project& project) {
  const auto text = format_project(project);
  if (text) return write_file_atomically(path, *text);
  Error error = text.error();
  error.where = path.string() + (error.where.empty() ? std::string() : ", " + error.where);
  return tl::unexpected(std::move(error));
}

Result<ReadProject> load_project(const std::filesystem::path& path) {
  std::error_code error;
  // A missing file and a folder get their text from read_file; a pipe or a device might never end.
  if (std::filesystem::is_other(std::filesystem::status(path, error)))
    return fail(ErrorCode::Unreadable, "is a device or a pipe, not a file", path.string(),
                "Save the project to a file first");
  if (const auto size = std::filesystem::file_size(path, error); !error && size > kLargestFile)
    return fail(ErrorCode::Unreadable, kTooLarge, path.string(), "Split the design into smaller parts");
  const auto text = read_file(path);
  if (!text) return tl::unexpected(text.error());
  return read_project(*text, path.string());
}

bool is_project_file(const std::filesystem::path& path) {
  if (equal_ignoring_case(path.extension().string(), kProjectEnding)) return true;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  std::array<char, 512> beginning{};
  std::ifstream file(path, std::ios::binary);
  file.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  const std::string_view text(beginning.data(), static_cast<std::size_t>(file.gcount()));
  const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return first != text.npos && text[first] == '{' && text.find(kProjectFormat) != text.npos;
}

}  // namespace planewright
