// STL, text and binary: triangles without shared vertices. Corners with exactly equal coordinates are joined.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>

#include "core/mesh/point_index.h"
#include "core/mesh/readers.h"
#include "core/mesh/text_scanner.h"

namespace planewright {
namespace {

constexpr size_t kHeaderSize = 84;    // 80 bytes of anything, then the number of triangles
constexpr size_t kTriangleSize = 50;  // normal, three corners, 2 bytes of anything

// Binary STL is little-endian.
std::uint32_t read_uint32(std::string_view content, size_t at) {
  std::uint32_t value = 0;
  for (size_t i = 0; i < 4; ++i)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(content[at + i])) << (8 * i);
  return value;
}

PolygonSoup joined(const PointIndex& index, Polygons faces) {
  PolygonSoup soup;
  soup.positions.resize(static_cast<Eigen::Index>(index.points().size()), 3);
  for (size_t v = 0; v < index.points().size(); ++v)
    soup.positions.row(static_cast<Eigen::Index>(v)) =
        Eigen::Map<const Eigen::RowVector3d>(index.points()[v].data());
  soup.faces = std::move(faces);
  return soup;
}

Result<PolygonSoup> read_binary(std::string_view content, const std::string& name) {
  const std::uint32_t count = read_uint32(content, 80);
  PointIndex index;
  Polygons faces;
  faces.reserve(static_cast<int>(count), 3 * static_cast<int>(count));
  for (std::uint32_t t = 0; t < count; ++t) {
    std::array<int, 3> corners;
    for (size_t k = 0; k < 3; ++k) {
      std::array<double, 3> point;
      for (size_t axis = 0; axis < 3; ++axis) {
        const size_t at = kHeaderSize + t * kTriangleSize + 12 + 12 * k + 4 * axis;
        point[axis] = std::bit_cast<float>(read_uint32(content, at));
        if (!std::isfinite(point[axis]))
          return fail(ErrorCode::Unreadable, "a coordinate is not a finite number",
                      name + ", triangle " + std::to_string(t), "Correct or remove the triangle");
      }
      corners[k] = index.insert(point[0], point[1], point[2]);
    }
    faces.push_back(corners);
  }
  return joined(index, std::move(faces));
}

class AsciiStlReader {
 public:
  AsciiStlReader(std::string_view content, const std::string& name) : scanner_(content, name) {}

  Result<PolygonSoup> read() {
    while (!scanner_.at_end()) {
      if (auto ok = expect("solid"); !ok) return tl::unexpected(ok.error());
      scanner_.skip_line();  // its name
      while (true) {
        const std::string_view keyword = scanner_.token();
        if (equal_ignoring_case(keyword, "endsolid")) break;
        if (!equal_ignoring_case(keyword, "facet")) return tl::unexpected(unexpected_word(keyword, "facet"));
        if (auto ok = read_facet(); !ok) return tl::unexpected(ok.error());
      }
      scanner_.skip_line();
    }
    return joined(index_, std::move(faces_));
  }

 private:
  Error unexpected_word(std::string_view found, const char* wanted) const {
    if (found.empty())
      return scanner_
          .error("the file ends inside triangle " + std::to_string(faces_.size()) + ", where \"" + wanted +
                     "\" should stand",
                 "It may have been cut off; export it again")
          .value();
    return scanner_
        .error(in_quotes(found) + " stands where \"" + wanted + "\" should",
               "Correct the line or export the file again")
        .value();
  }

  Result<void> expect(const char* word) {
    const std::string_view token = scanner_.token();
    if (!equal_ignoring_case(token, word)) return tl::unexpected(unexpected_word(token, word));
    return {};
  }

  // facet normal x y z / outer loop / vertex x y z, three times or more / endloop / endfacet
  Result<void> read_facet() {
    if (auto ok = expect("normal"); !ok) return ok;
    for (int axis = 0; axis < 3; ++axis)
      if (scanner_.token().empty()) return tl::unexpected(unexpected_word({}, "outer"));
    for (const char* word : {"outer", "loop"})
      if (auto ok = expect(word); !ok) return ok;
    corners_.clear();
    while (true) {
      const std::string_view keyword = scanner_.token();
      if (equal_ignoring_case(keyword, "endloop")) break;
      if (!equal_ignoring_case(keyword, "vertex")) return tl::unexpected(unexpected_word(keyword, "vertex"));
      std::array<double, 3> point;
      for (double& coordinate : point) {
        const std::string_view token = scanner_.token();
        if (token.empty()) return tl::unexpected(unexpected_word(token, "a coordinate"));
        const auto value = read_coordinate(scanner_, token);
        if (!value) return tl::unexpected(value.error());
        coordinate = *value;
      }
      corners_.push_back(index_.insert(point[0], point[1], point[2]));
    }
    if (auto ok = expect("endfacet"); !ok) return ok;
    faces_.push_back(corners_);
    return {};
  }

  TextScanner scanner_;
  PointIndex index_;
  Polygons faces_;
  std::vector<int> corners_;
};

}  // namespace

// Many binary files begin with "solid" too, so only the size tells.
bool is_binary_stl(std::string_view content) {
  return content.size() >= kHeaderSize &&
         content.size() == kHeaderSize + kTriangleSize * static_cast<size_t>(read_uint32(content, 80));
}

Result<PolygonSoup> read_stl(std::string_view content, const std::string& name) {
  if (is_binary_stl(content)) return read_binary(content, name);
  const bool text =
      content.find('\0') == content.npos && equal_ignoring_case(TextScanner(content, name).token(), "solid");
  if (text) return AsciiStlReader(content, name).read();
  if (content.size() < kHeaderSize)
    return fail(ErrorCode::Unreadable,
                "the file is too short for a binary STL file and does not begin with \"solid\"", name,
                "Check that it is an STL file");
  return fail(ErrorCode::Unreadable,
              "the file promises " + std::to_string(read_uint32(content, 80)) +
                  " triangles, which does not fit its size of " + std::to_string(content.size()) + " bytes",
              name, "It may have been cut off, or it is no STL file; export it again");
}

}  // namespace planewright
