#include "core/mesh/mesh_io.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "core/base/atomic_file.h"
#include "core/mesh/readers.h"
#include "core/mesh/text_scanner.h"

namespace planewright {
namespace {

// Indices are ints, and no format takes less than a byte for one.
constexpr size_t kLargestFile = std::numeric_limits<int>::max();

std::string_view without_byte_order_mark(std::string_view content) {
  if (content.starts_with("\xEF\xBB\xBF")) content.remove_prefix(3);
  return content;
}

// The format that the content itself proves. An OBJ file has no mark of its own.
std::optional<MeshFormat> certain_format(std::string_view content) {
  content = without_byte_order_mark(content);
  if (is_binary_stl(content)) return MeshFormat::Stl;
  if (content.starts_with("ply\n") || content.starts_with("ply\r")) return MeshFormat::Ply;
  if (begins_as_off(content)) return MeshFormat::Off;
  TextScanner scanner(content.substr(0, 4096), {});
  if (equal_ignoring_case(scanner.token(), "solid")) {
    scanner.skip_line();
    const std::string_view next = scanner.token();
    if (equal_ignoring_case(next, "facet") || equal_ignoring_case(next, "endsolid")) return MeshFormat::Stl;
  }
  return {};
}

Error at_file(Error error, const std::string& name) {
  error.where = error.where.empty() ? name : name + ", " + error.where;
  return error;
}

}  // namespace

Result<MeshFormat> format_of(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  if (equal_ignoring_case(ending, ".obj")) return MeshFormat::Obj;
  if (equal_ignoring_case(ending, ".off")) return MeshFormat::Off;
  if (equal_ignoring_case(ending, ".ply")) return MeshFormat::Ply;
  if (equal_ignoring_case(ending, ".stl")) return MeshFormat::Stl;
  return fail(ErrorCode::Usage,
              ending.empty() ? std::string("the name has no ending that says the format")
                             : "the ending " + in_quotes(ending) + " is not that of a known format",
              path.string(), "Use .obj, .off, .ply or .stl");
}

Result<PolygonSoup> parse_mesh(std::string_view content, MeshFormat format, const std::string& name) {
  if (content.empty()) return fail(ErrorCode::Unreadable, "the file is empty", name, "Export the mesh again");
  if (content.size() > kLargestFile)
    return fail(ErrorCode::Unreadable, "files of more than 2 GB are not read", name,
                "Split the mesh into smaller parts");
  content = without_byte_order_mark(content);
  switch (format) {
    case MeshFormat::Ply:
      return read_ply(content, name);
    case MeshFormat::Stl:
      return read_stl(content, name);
    case MeshFormat::Obj:
    case MeshFormat::Off:
      break;
  }
  if (content.find('\0') != content.npos)
    return fail(ErrorCode::Unreadable, "the file holds binary data instead of text", name,
                std::string("Check that it is an ") + (format == MeshFormat::Obj ? "OBJ" : "OFF") + " file");
  return format == MeshFormat::Obj ? read_obj(content, name) : read_off(content, name);
}

Result<PolygonSoup> make_soup(const std::vector<double>& coordinates, Polygons faces, bool may_count_from_1,
                              const std::function<std::string(int)>& where_face) {
  PolygonSoup soup;
  const int vertex_count = static_cast<int>(coordinates.size() / 3);
  soup.positions = Eigen::Map<const Points>(coordinates.data(), vertex_count, 3);

  const std::vector<int>& indices = faces.indices();
  if (may_count_from_1 && !indices.empty()) {
    const auto [least, greatest] = std::minmax_element(indices.begin(), indices.end());
    soup.one_based_indices = *least >= 1 && *greatest == vertex_count;
  }
  for (int f = 0; f < faces.size(); ++f)
    for (int& v : faces[f]) {
      if (soup.one_based_indices) --v;
      if (v < 0 || v >= vertex_count)
        return fail(ErrorCode::Unreadable,
                    "the face names vertex " + std::to_string(may_count_from_1 ? v : v + 1) +
                        ", but the file has " + std::to_string(vertex_count) + " vertices" +
                        (may_count_from_1 ? " (counted from 0)" : ""),
                    where_face(f), "Correct the face or export the file again");
    }
  soup.faces = std::move(faces);
  return soup;
}

Result<CheckedMesh> load_mesh(const std::filesystem::path& path) {
  const std::string name = path.string();
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  // A missing file and a folder get their text from read_file; a pipe or a device might never end.
  if (std::filesystem::is_other(status))
    return fail(ErrorCode::Unreadable, "is a device or a pipe, not a file", name,
                "Save the mesh to a file first");
  if (const auto size = std::filesystem::file_size(path, error); !error && size > kLargestFile)
    return fail(ErrorCode::Unreadable, "files of more than 2 GB are not read", name,
                "Split the mesh into smaller parts");
  const auto content = read_file(path);
  if (!content) return tl::unexpected(content.error());

  MeshFormat format;
  if (const auto certain = certain_format(*content)) {
    format = *certain;
  } else {
    const auto by_name = format_of(path);
    if (!by_name) return tl::unexpected(by_name.error());
    format = *by_name;
  }
  const auto soup = parse_mesh(*content, format, name);
  if (!soup) return tl::unexpected(soup.error());
  auto checked = check_and_repair(soup->positions, soup->faces);
  if (!checked) return tl::unexpected(at_file(checked.error(), name));
  if (soup->one_based_indices)
    checked->health.defects.push_back({DefectKind::IndexBase, 1, {}, "read as counting from 1"});
  return checked;
}

Result<void> save_mesh(const std::filesystem::path& path, const Points& positions, const Polygons& faces) {
  const auto format = format_of(path);
  if (!format) return tl::unexpected(format.error());
  const auto content = format_mesh(*format, positions, faces);
  if (!content) return tl::unexpected(at_file(content.error(), path.string()));
  return write_file_atomically(path, *content);
}

}  // namespace planewright
