// OFF: a header [ST][C][N][4]OFF, the counts, one vertex after the other, one face after the other. Colours,
// normals and texture coordinates follow the coordinates and are passed over.
#include <algorithm>
#include <string>

#include "core/mesh/readers.h"
#include "core/mesh/text_scanner.h"

namespace planewright {
namespace {

struct OffHeader {
  bool valid = false;
  bool homogeneous = false;    // 4OFF: x y z w
  bool any_dimension = false;  // nOFF
  bool extras = false;         // colours, normals or texture coordinates at every vertex
};

// [ST][C][N][4][n]OFF in this order.
OffHeader parse_header(std::string_view word) {
  OffHeader header;
  auto take = [&](std::string_view prefix) {
    if (!word.starts_with(prefix)) return false;
    word.remove_prefix(prefix.size());
    return true;
  };
  if (word == "off") return {.valid = true};
  const bool texture = take("ST"), colours = take("C"), normals = take("N");
  header.extras = texture || colours || normals;
  header.homogeneous = take("4");
  header.any_dimension = take("n");
  header.valid = word == "OFF";
  return header;
}

// Lines: whatever follows a vertex or a face on its line is an extra, and passed over; the common case.
// Tokens: no extras; several vertices or faces may share a line.
enum class OffLayout { Lines, Tokens };

class OffReader {
 public:
  OffReader(std::string_view content, const std::string& name, OffLayout layout)
      : scanner_(content, name, {.hash_comments = true}), layout_(layout) {}

  Result<PolygonSoup> read() {
    if (auto ok = read_header(); !ok) return tl::unexpected(ok.error());
    if (auto ok = read_counts(); !ok) return tl::unexpected(ok.error());
    for (int v = 0; v < vertex_count_; ++v)
      if (auto ok = read_vertex(v); !ok) return tl::unexpected(ok.error());
    for (int f = 0; f < face_count_; ++f)
      if (auto ok = read_face(f); !ok) return tl::unexpected(ok.error());
    if (!scanner_.at_end()) {
      scanner_.token();
      return scanner_.error(
          "the file goes on after the " + std::to_string(face_count_) + " faces that it promises",
          "Correct the counts at its head or export the file again");
    }
    return make_soup(coordinates_, std::move(faces_), true, [this](int f) {
      return scanner_.where(face_lines_[f]) + ", face " + std::to_string(f);
    });
  }

  bool has_extras() const { return header_.extras; }

 private:
  Result<void> read_header() {
    TextScanner ahead = scanner_;
    const std::string_view word = ahead.token();
    header_ = parse_header(word);
    if (!header_.valid) {
      header_ = {};
      // Some files begin with the counts at once.
      if (to_integer(word)) return {};
      scanner_ = ahead;
      return scanner_.error("an OFF file begins with \"OFF\", not with " + in_quotes(word),
                            "Check that it is an OFF file");
    }
    scanner_ = ahead;
    if (header_.any_dimension)
      return scanner_.error("OFF files with points of any dimension (nOFF) are not read",
                            "Export the file as plain OFF");
    const std::string_view next = ahead.token_in_line();
    if (equal_ignoring_case(next, "BINARY"))
      return ahead.error("binary OFF files are not read", "Export the file as plain OFF, OBJ or PLY");
    return {};
  }

  Result<long long> read_count(const char* what) {
    const std::string_view token = scanner_.token();
    const auto count = to_integer(token);
    if (token.empty())
      return scanner_.error(std::string("the file ends before its number of ") + what, kExportAgain);
    if (!count || *count < 0)
      return scanner_.error(in_quotes(token) + " is not a number of " + what,
                            "Correct the counts at the head");
    return *count;
  }

  Result<void> read_counts() {
    const auto vertices = read_count("vertices");
    if (!vertices) return tl::unexpected(vertices.error());
    const auto faces = read_count("faces");
    if (!faces) return tl::unexpected(faces.error());
    const std::string counts_at = scanner_.where();
    if (layout_ == OffLayout::Lines) {
      scanner_.skip_line();  // with the number of edges, which nobody needs
    } else if (auto edges = read_count("edges"); !edges) {
      return tl::unexpected(edges.error());
    }
    // A vertex takes at least "0 0 0\n", a face "0\n"; the last line may lack its end.
    const long long left = static_cast<long long>(scanner_.remaining()) + 1;
    if (*vertices > left / 6 || *faces > left / 2 || 6 * *vertices + 2 * *faces > left)
      return fail(ErrorCode::Unreadable,
                  "the file promises " + std::to_string(*vertices) + " vertices and " +
                      std::to_string(*faces) + " faces, more than its " +
                      std::to_string(scanner_.position() + scanner_.remaining()) + " bytes can hold",
                  counts_at, "Correct the counts at its head or export the file again");
    vertex_count_ = static_cast<int>(*vertices);
    face_count_ = static_cast<int>(*faces);
    coordinates_.reserve(3 * static_cast<size_t>(vertex_count_));
    return {};
  }

  tl::unexpected<Error> ends_inside(const char* what, int i, int count) const {
    return scanner_.error("the file ends inside " + std::string(what) + " " + std::to_string(i) + " (of " +
                              std::to_string(count) + ", counted from 0)",
                          "It may have been cut off; export it again");
  }

  Result<void> read_vertex(int v) {
    double values[4] = {0.0, 0.0, 0.0, 1.0};
    const int dimension = header_.homogeneous ? 4 : 3;
    for (int axis = 0; axis < dimension; ++axis) {
      const std::string_view token = scanner_.token();
      if (token.empty()) return ends_inside("vertex", v, vertex_count_);
      const auto value = read_coordinate(scanner_, token);
      if (!value) return tl::unexpected(value.error());
      values[axis] = *value;
    }
    if (header_.homogeneous && values[3] == 0.0)
      return scanner_.error("the vertex lies at infinity (its fourth coordinate is 0)",
                            "Correct or remove the vertex");
    for (int axis = 0; axis < 3; ++axis) coordinates_.push_back(values[axis] / values[3]);
    if (layout_ == OffLayout::Lines) scanner_.skip_line();
    return {};
  }

  Result<void> read_face(int f) {
    const std::string_view first = scanner_.token();
    if (first.empty()) return ends_inside("face", f, face_count_);
    face_lines_.push_back(scanner_.token_line());
    const auto count = to_integer(first);
    if (!count || *count < 0)
      return scanner_.error(in_quotes(first) + " is not a number of corners",
                            "Correct the line or export the file again");
    if (*count > static_cast<long long>(scanner_.remaining() / 2) + 1)
      return ends_inside("face", f, face_count_);
    corners_.clear();
    for (long long k = 0; k < *count; ++k) {
      const std::string_view token = scanner_.token();
      if (token.empty()) return ends_inside("face", f, face_count_);
      const auto index = to_integer(token);
      if (!index)
        return scanner_.error(in_quotes(token) + " is not a corner of a face",
                              "Correct the line or export the file again");
      if (*index < 0 || *index > vertex_count_)
        return scanner_.error("face " + std::to_string(f) + " names vertex " + std::string(token) +
                                  ", but the file has " + std::to_string(vertex_count_) + " vertices",
                              "Correct the line or export the file again");
      corners_.push_back(static_cast<int>(*index));
    }
    faces_.push_back(corners_);
    if (layout_ == OffLayout::Lines) scanner_.skip_line();
    return {};
  }

  TextScanner scanner_;
  OffLayout layout_;
  OffHeader header_;
  int vertex_count_ = 0, face_count_ = 0;
  std::vector<double> coordinates_;
  Polygons faces_;
  std::vector<int> face_lines_;
  std::vector<int> corners_;
};

}  // namespace

bool begins_as_off(std::string_view content) {
  TextScanner scanner(content.substr(0, 4096), {}, {.hash_comments = true});
  return parse_header(scanner.token()).valid;
}

Result<PolygonSoup> read_off(std::string_view content, const std::string& name) {
  OffReader by_lines(content, name, OffLayout::Lines);
  auto soup = by_lines.read();
  if (soup || by_lines.has_extras()) return soup;
  if (auto by_tokens = OffReader(content, name, OffLayout::Tokens).read()) return by_tokens;
  return soup;
}

}  // namespace planewright
