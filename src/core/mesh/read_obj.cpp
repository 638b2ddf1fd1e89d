// Wavefront OBJ: lines "v x y z ..." and "f a b c ..."; everything else describes looks and is passed over.
#include <string>

#include "core/mesh/readers.h"
#include "core/mesh/text_scanner.h"

namespace planewright {
namespace {

class ObjReader {
 public:
  ObjReader(std::string_view content, const std::string& name)
      : scanner_(content, name, {.hash_comments = true, .continuation = true}), size_(content.size()) {}

  Result<PolygonSoup> read() {
    for (; !scanner_.at_end(); scanner_.skip_line()) {
      const std::string_view keyword = scanner_.token_in_line();
      Result<void> ok;
      if (keyword == "v")
        ok = read_vertex();
      else if (keyword == "f" || keyword == "fo")
        ok = read_face();  // "fo": an old spelling
      if (!ok) return tl::unexpected(ok.error());
    }
    if (coordinates_.empty() && faces_.empty())
      return fail(ErrorCode::Unreadable, "the file holds no vertex and no face of an OBJ file",
                  scanner_.name(), "Check that it is an OBJ file");
    // Only now: a face may name vertices that come later in the file.
    return make_soup(coordinates_, std::move(faces_), false,
                     [this](int f) { return scanner_.where(face_lines_[f]); });
  }

 private:
  // What follows the three coordinates (a weight, a colour) is left to skip_line().
  Result<void> read_vertex() {
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view token = scanner_.token_in_line();
      if (token.empty())
        return scanner_.error("the vertex has " + std::to_string(axis) + " coordinates instead of 3",
                              "Correct the line or export the file again");
      const auto value = read_coordinate(scanner_, token);
      if (!value) return tl::unexpected(value.error());
      coordinates_.push_back(*value);
    }
    return {};
  }

  Result<void> read_face() {
    const int line = scanner_.token_line();
    corners_.clear();
    while (true) {
      const std::string_view token = scanner_.token_in_line();
      if (token.empty()) break;
      const auto corner = read_corner(token);
      if (!corner) return tl::unexpected(corner.error());
      corners_.push_back(*corner);
    }
    if (corners_.empty()) return scanner_.error("the face has no corners", "Remove the line");
    faces_.push_back(corners_);
    face_lines_.push_back(line);
    return {};
  }

  // "7", "7/1", "7//3" or "7/1/3"; negative numbers count back from the last vertex so far.
  Result<int> read_corner(std::string_view token) const {
    const size_t slash = token.find('/');
    const auto index = to_integer(token.substr(0, slash));
    if (!index || !is_attribute_list(slash == token.npos ? std::string_view{} : token.substr(slash)))
      return scanner_.error(in_quotes(token) + " is not a corner of a face",
                            "Correct the line or export the file again");
    if (*index == 0)
      return scanner_.error("the face names vertex 0, but OBJ files count from 1",
                            "Export the file again with indices from 1");
    if (*index > static_cast<long long>(size_) || *index < -static_cast<long long>(size_))
      return scanner_.error(
          "the face names vertex " + std::string(token.substr(0, slash)) + ", more than the file can hold",
          "Correct the line or export the file again");
    if (*index > 0) return static_cast<int>(*index - 1);
    const long long counted_back = static_cast<long long>(coordinates_.size() / 3) + *index;
    if (counted_back < 0)
      return scanner_.error("the face names vertex " + std::to_string(*index) + ", before the first of the " +
                                std::to_string(coordinates_.size() / 3) + " vertices so far",
                            "Correct the line or export the file again");
    return static_cast<int>(counted_back);
  }

  // What may follow the vertex: "/1", "//3", "/1/3".
  static bool is_attribute_list(std::string_view text) {
    int slashes = 0;
    for (char c : text) {
      if (c == '/')
        ++slashes;
      else if ((c < '0' || c > '9') && c != '-')
        return false;
    }
    return slashes <= 2;
  }

  TextScanner scanner_;
  size_t size_;
  std::vector<double> coordinates_;
  Polygons faces_;
  std::vector<int> face_lines_;
  std::vector<int> corners_;
};

}  // namespace

Result<PolygonSoup> read_obj(std::string_view content, const std::string& name) {
  return ObjReader(content, name).read();
}

}  // namespace planewright
