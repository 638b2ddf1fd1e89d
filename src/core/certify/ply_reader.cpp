#include "core/certify/ply_reader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

#include "core/certify/file_bytes.h"

namespace planewright {
namespace {

enum class Encoding { Text, Little, Big };

std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> all;
  for (size_t at = 0; at < line.size();) {
    const size_t begin = line.find_first_not_of(" \t\r", at);
    if (begin == std::string_view::npos) break;
    at = std::min(line.find_first_of(" \t\r", begin), line.size());
    all.push_back(line.substr(begin, at - begin));
  }
  return all;
}

// "char" ... "float64" as its size, and whether it is signed or real.
struct Type {
  int bytes = 0;
  char kind = 0;  // 'i', 'u', 'f'
};
std::optional<Type> type_of(std::string_view name) {
  if (name == "char" || name == "int8") return Type{1, 'i'};
  if (name == "uchar" || name == "uint8") return Type{1, 'u'};
  if (name == "short" || name == "int16") return Type{2, 'i'};
  if (name == "ushort" || name == "uint16") return Type{2, 'u'};
  if (name == "int" || name == "int32") return Type{4, 'i'};
  if (name == "uint" || name == "uint32") return Type{4, 'u'};
  if (name == "float" || name == "float32") return Type{4, 'f'};
  if (name == "double" || name == "float64") return Type{8, 'f'};
  return {};
}

struct Property {
  std::string name;
  Type type;
  std::optional<Type> count;  // of a list
};
struct Element {
  std::string name;
  long long count = 0;
  std::vector<Property> properties;
};

class Reader {
 public:
  Reader(std::string_view content, const std::string& name) : content_(content), name_(name) {}

  Result<ReadMesh> read() {
    if (auto done = header(); !done) return tl::unexpected(done.error());
    for (const Element& e : elements_)
      for (long long i = 0; i < e.count; ++i)
        if (auto done = entry(e, i); !done) return tl::unexpected(done.error());
    if (encoding_ == Encoding::Text) skip_blanks();
    if (at_ != content_.size()) return error("more data than the header says");
    mesh_.points =
        Eigen::Map<const Points>(coordinates_.data(), static_cast<Eigen::Index>(coordinates_.size() / 3), 3);
    if (!mesh_.points.allFinite()) return error("a coordinate is not finite");
    for (const int corner : mesh_.faces.indices())
      if (corner < 0 || corner >= mesh_.points.rows()) return error("a face has a corner that is not there");
    if (mesh_.faces.empty()) return error("no faces");
    return std::move(mesh_);
  }

 private:
  tl::unexpected<Error> error(std::string what) const {
    return fail(ErrorCode::Unreadable, std::move(what), name_);
  }

  std::optional<std::string_view> next_line() {
    const size_t end = content_.find('\n', at_);
    if (end == std::string_view::npos) return {};
    const std::string_view line = content_.substr(at_, end - at_);
    at_ = end + 1;
    return line;
  }

  Result<void> header() {
    const auto magic = next_line();
    if (!magic || words(*magic) != std::vector<std::string_view>{"ply"})
      return error("it does not begin with 'ply'");
    while (true) {
      const auto line = next_line();
      if (!line) return error("the header does not end");
      const auto w = words(*line);
      if (w.empty()) continue;
      if (w[0] == "end_header") break;
      if (w[0] == "comment" || w[0] == "obj_info") {
        comment(w);
      } else if (w[0] == "format" && w.size() >= 2) {
        if (w[1] == "ascii")
          encoding_ = Encoding::Text;
        else if (w[1] == "binary_little_endian")
          encoding_ = Encoding::Little;
        else if (w[1] == "binary_big_endian")
          encoding_ = Encoding::Big;
        else
          return error("an unknown format");
      } else if (w[0] == "element" && w.size() == 3) {
        Element e{std::string(w[1]), 0, {}};
        const auto end = std::from_chars(w[2].data(), w[2].data() + w[2].size(), e.count);
        if (end.ec != std::errc() || e.count < 0 || static_cast<size_t>(e.count) > content_.size())
          return error("a number of elements that cannot be");
        elements_.push_back(std::move(e));
      } else if (w[0] == "property" && !elements_.empty()) {
        if (auto done = property(w); !done) return done;
      } else {
        return error("a line of the header that is none: '" + std::string(line->substr(0, 40)) + "'");
      }
    }
    return {};
  }

  Result<void> property(const std::vector<std::string_view>& w) {
    Property p;
    const bool list = w.size() == 5 && w[1] == "list";
    if (!list && w.size() != 3) return error("a property that is none");
    const auto type = type_of(w[list ? 3 : 1]);
    if (!type) return error("a property of unknown type");
    p.type = *type;
    p.name = std::string(w.back());
    if (list) {
      p.count = type_of(w[2]);
      if (!p.count) return error("a property of unknown type");
    }
    if (elements_.back().name == "vertex" && p.type.kind == 'f' && p.type.bytes == 4)
      mesh_.single_precision = true;
    elements_.back().properties.push_back(std::move(p));
    return {};
  }

  // "panel 3 C-17" names object 3; everything else may say the unit.
  void comment(const std::vector<std::string_view>& w) {
    if (w.size() == 4 && w[1] == "panel") {
      size_t number = 0;
      std::string_view digits = w[2];
      if (digits.ends_with(':')) digits.remove_suffix(1);
      const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), number);
      if (end.ec == std::errc() && end.ptr == digits.data() + digits.size() && number < content_.size()) {
        if (mesh_.objects.size() <= number) mesh_.objects.resize(number + 1);
        mesh_.objects[number] = std::string(w[3]);
        return;
      }
    }
    for (size_t i = 1; i < w.size(); ++i) mesh_.unit += (mesh_.unit.empty() ? "" : " ") + std::string(w[i]);
  }

  void skip_blanks() {
    while (at_ < content_.size() && std::strchr(" \t\r\n", content_[at_])) ++at_;
  }

  Result<double> value(const Type& type) {
    if (encoding_ == Encoding::Text) {
      skip_blanks();
      double number = 0.0;
      const char* begin = content_.data() + at_;
      const char* stop = content_.data() + content_.size();
      if (begin < stop && *begin == '+') ++begin;
      const auto end = std::from_chars(begin, stop, number);
      if (end.ec != std::errc() || (end.ptr < stop && !std::strchr(" \t\r\n", *end.ptr)))
        return error(begin == stop ? "the file ends early" : "something that is no number");
      at_ = static_cast<size_t>(end.ptr - content_.data());
      return number;
    }
    const auto bytes = static_cast<size_t>(type.bytes);
    if (at_ + bytes > content_.size()) return error("the file ends early");
    std::uint64_t bits = 0;
    for (size_t i = 0; i < bytes; ++i) {
      const size_t from = encoding_ == Encoding::Little ? bytes - 1 - i : i;
      bits = (bits << 8) | static_cast<unsigned char>(content_[at_ + from]);
    }
    at_ += bytes;
    if (type.kind == 'f')
      return bytes == 8 ? std::bit_cast<double>(bits)
                        : static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    if (type.kind == 'i' && bytes < 8 && (bits >> (8 * bytes - 1)) != 0)
      return static_cast<double>(bits) - std::exp2(8.0 * type.bytes);
    return static_cast<double>(bits);
  }

  static bool is_index(double v) { return v == std::floor(v) && std::abs(v) < 2e9; }

  Result<void> entry(const Element& e, long long) {
    const bool vertex = e.name == "vertex", face = e.name == "face";
    std::array<std::optional<double>, 3> xyz;
    int object = -1;
    bool has_corners = false;
    for (const Property& p : e.properties) {
      if (!p.count) {
        const auto v = value(p.type);
        if (!v) return tl::unexpected(v.error());
        if (vertex && p.name.size() == 1 && p.name[0] >= 'x' && p.name[0] <= 'z')
          xyz[static_cast<size_t>(p.name[0] - 'x')] = *v;
        if (face && p.name == "panel") {
          if (!is_index(*v)) return error("a panel number that is none");
          object = static_cast<int>(*v);
        }
        continue;
      }
      const auto n = value(*p.count);
      if (!n) return tl::unexpected(n.error());
      if (!is_index(*n) || *n < 0.0 || *n > static_cast<double>(content_.size()))
        return error("a list whose length cannot be");
      std::vector<int> corners;
      for (int k = 0; k < static_cast<int>(*n); ++k) {
        const auto v = value(p.type);
        if (!v) return tl::unexpected(v.error());
        if (face && !is_index(*v)) return error("a corner that is no number of a point");
        corners.push_back(static_cast<int>(*v));
      }
      if (face && (p.name == "vertex_indices" || p.name == "vertex_index")) {
        if (corners.size() < 3) return error("a face of fewer than three corners");
        mesh_.faces.push_back(corners);
        has_corners = true;
      }
    }
    if (vertex) {
      for (const auto& c : xyz) {
        if (!c) return error("a vertex without x, y and z");
        coordinates_.push_back(*c);
      }
    }
    if (face) {
      if (!has_corners) return error("a face without corners");
      mesh_.object_of_face.push_back(object);
    }
    return {};
  }

  std::string_view content_;
  const std::string& name_;
  size_t at_ = 0;
  Encoding encoding_ = Encoding::Text;
  std::vector<Element> elements_;
  std::vector<double> coordinates_;
  ReadMesh mesh_;
};

}  // namespace

std::string ply_reader_name() {
  return "own PLY (double)";
}

Result<ReadMesh> read_ply_file(const std::filesystem::path& path) {
  const auto bytes = file_bytes(path);
  if (!bytes) return tl::unexpected(bytes.error());
  const std::string name = path.filename().string();
  return Reader(*bytes, name).read();
}

}  // namespace planewright
