// PLY: a text header that declares elements and their properties, then their values as text or binary.
// Positions and faces are taken; every other element and property is passed over by its declared type.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>

#include "core/mesh/readers.h"
#include "core/mesh/text_scanner.h"

namespace planewright {
namespace {

enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Int64, UInt64, Float32, Float64 };

struct PlyTypeName {
  const char *name, *other_name;
  PlyType type;
  int size;
};
// In the order of PlyType.
constexpr std::array<PlyTypeName, 10> kTypes{{
    {"char", "int8", PlyType::Int8, 1},
    {"uchar", "uint8", PlyType::UInt8, 1},
    {"short", "int16", PlyType::Int16, 2},
    {"ushort", "uint16", PlyType::UInt16, 2},
    {"int", "int32", PlyType::Int32, 4},
    {"uint", "uint32", PlyType::UInt32, 4},
    {"long", "int64", PlyType::Int64, 8},
    {"ulong", "uint64", PlyType::UInt64, 8},
    {"float", "float32", PlyType::Float32, 4},
    {"double", "float64", PlyType::Float64, 8},
}};

int size_of(PlyType type) {
  return kTypes[static_cast<size_t>(type)].size;
}

std::optional<PlyType> type_of(std::string_view word) {
  for (const PlyTypeName& t : kTypes)
    if (word == t.name || word == t.other_name) return t.type;
  return {};
}

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float32;
  bool list = false;
  PlyType count_type = PlyType::UInt8;
};

struct PlyElement {
  std::string name;
  long long count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyEncoding { Ascii, LittleEndian, BigEndian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::vector<PlyElement> elements;
};

constexpr const char* kCorrectHeader = "Correct the head of the file or export it again";

class PlyHeaderReader {
 public:
  explicit PlyHeaderReader(TextScanner& scanner) : scanner_(scanner) {}

  // Leaves the scanner at the first byte after the header.
  Result<PlyHeader> read() {
    if (scanner_.token_in_line() != "ply")
      return scanner_.error("a PLY file begins with \"ply\"", "Check that it is a PLY file");
    bool format_seen = false;
    while (true) {
      scanner_.skip_line();
      if (scanner_.at_end())
        return scanner_.error("the file ends inside its head", "It may have been cut off; export it again");
      const std::string_view keyword = scanner_.token_in_line();
      Result<void> ok;
      if (keyword == "end_header") break;
      if (keyword == "comment" || keyword == "obj_info") continue;
      if (keyword == "format") {
        format_seen = true;
        ok = read_format();
      } else if (keyword == "element") {
        ok = read_element();
      } else if (keyword == "property") {
        ok = read_property();
      } else {
        ok = scanner_.error(in_quotes(keyword) + " is unknown in the head of a PLY file", kCorrectHeader);
      }
      if (!ok) return tl::unexpected(ok.error());
    }
    scanner_.skip_line();
    if (!format_seen) return scanner_.error("the head names no format (ascii or binary)", kCorrectHeader);
    return std::move(header_);
  }

 private:
  Result<void> read_format() {
    const std::string_view word = scanner_.token_in_line();
    if (word == "ascii")
      header_.encoding = PlyEncoding::Ascii;
    else if (word == "binary_little_endian")
      header_.encoding = PlyEncoding::LittleEndian;
    else if (word == "binary_big_endian")
      header_.encoding = PlyEncoding::BigEndian;
    else
      return scanner_.error("the format " + in_quotes(word) + " is unknown", kCorrectHeader);
    return {};
  }

  Result<void> read_element() {
    PlyElement element;
    element.name = scanner_.token_in_line();
    const std::string_view token = scanner_.token_in_line();
    const auto count = to_integer(token);
    if (!count || *count < 0)
      return scanner_.error(in_quotes(token) + " is not a number of elements", kCorrectHeader);
    for (const PlyElement& earlier : header_.elements)
      if (earlier.name == element.name)
        return scanner_.error("the element " + in_quotes(element.name) + " is declared twice",
                              kCorrectHeader);
    element.count = *count;
    header_.elements.push_back(std::move(element));
    return {};
  }

  Result<void> read_property() {
    if (header_.elements.empty())
      return scanner_.error("a property stands before the first element", kCorrectHeader);
    PlyProperty property;
    std::string_view word = scanner_.token_in_line();
    property.list = word == "list";
    if (property.list) {
      word = scanner_.token_in_line();
      const auto count_type = type_of(word);
      if (!count_type || *count_type == PlyType::Float32 || *count_type == PlyType::Float64)
        return scanner_.error(in_quotes(word) + " is not a type for the length of a list", kCorrectHeader);
      property.count_type = *count_type;
      word = scanner_.token_in_line();
    }
    const auto type = type_of(word);
    if (!type) return scanner_.error(in_quotes(word) + " is not a known type", kCorrectHeader);
    property.type = *type;
    property.name = scanner_.token_in_line();
    if (property.name.empty()) return scanner_.error("the property has no name", kCorrectHeader);
    header_.elements.back().properties.push_back(std::move(property));
    return {};
  }

  TextScanner& scanner_;
  PlyHeader header_;
};

// The values as text. A source yields one value after the other; nothing at its end or for what is no number.
class AsciiSource {
 public:
  explicit AsciiSource(TextScanner& scanner) : scanner_(scanner) {}

  std::optional<double> value(PlyType) {
    const std::string_view token = scanner_.token();
    ended_ = token.empty();
    const auto number = to_number(token);
    if (!number) bad_token_ = token;
    return number;
  }
  bool skip(PlyType, long long count) {
    for (; count > 0; --count)
      if (scanner_.token().empty()) {
        ended_ = true;
        return false;
      }
    return true;
  }
  static long long least_size(PlyType) { return 2; }             // a digit and a blank
  size_t remaining() const { return scanner_.remaining() + 1; }  // the last blank may be missing
  bool goes_on() { return !scanner_.at_end(); }
  bool ended() const { return ended_; }
  std::string bad_value() const { return in_quotes(bad_token_) + " is not a number"; }
  int line() const { return scanner_.token_line(); }

 private:
  TextScanner& scanner_;
  bool ended_ = false;
  std::string_view bad_token_;
};

class BinarySource {
 public:
  BinarySource(std::string_view data, bool big_endian)
      : data_(data), swap_(big_endian != (std::endian::native == std::endian::big)) {}

  std::optional<double> value(PlyType type) {
    if (data_.size() < static_cast<size_t>(size_of(type))) return {};
    switch (type) {
      case PlyType::Int8:
        return take<std::int8_t>();
      case PlyType::UInt8:
        return take<std::uint8_t>();
      case PlyType::Int16:
        return take<std::int16_t>();
      case PlyType::UInt16:
        return take<std::uint16_t>();
      case PlyType::Int32:
        return take<std::int32_t>();
      case PlyType::UInt32:
        return take<std::uint32_t>();
      case PlyType::Int64:
        return static_cast<double>(take<std::int64_t>());
      case PlyType::UInt64:
        return static_cast<double>(take<std::uint64_t>());
      case PlyType::Float32:
        return take<float>();
      case PlyType::Float64:
        return take<double>();
    }
    return {};
  }
  bool skip(PlyType type, long long count) {
    if (count > static_cast<long long>(data_.size()) / size_of(type)) return false;
    data_.remove_prefix(static_cast<size_t>(count * size_of(type)));
    return true;
  }
  static long long least_size(PlyType type) { return size_of(type); }
  size_t remaining() const { return data_.size(); }
  bool goes_on() const { return data_.find_first_not_of("\r\n") != data_.npos; }
  bool ended() const { return true; }  // every byte is a value, so only the end can be wrong
  std::string bad_value() const { return {}; }
  int line() const { return 0; }

 private:
  template <class T>
  T take() {
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), data_.data(), sizeof(T));
    data_.remove_prefix(sizeof(T));
    if (swap_) std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<T>(bytes);
  }

  std::string_view data_;
  bool swap_;
};

template <class Source>
class PlyBodyReader {
 public:
  PlyBodyReader(const PlyHeader& header, Source source, std::string name)
      : header_(header), source_(std::move(source)), name_(std::move(name)) {}

  Result<PolygonSoup> read() {
    if (auto ok = check_elements(); !ok) return tl::unexpected(ok.error());
    for (const PlyElement& element : header_.elements) {
      element_ = &element;
      if (auto ok = check_count(); !ok) return tl::unexpected(ok.error());
      if (element.properties.empty()) continue;
      if (element.name == "vertex") coordinates_.reserve(3 * static_cast<size_t>(element.count));
      for (index_ = 0; index_ < element.count; ++index_) {
        Result<void> ok = element.name == "vertex" ? read_vertex()
                          : element.name == "face" ? read_face()
                                                   : pass_over();
        if (!ok) return tl::unexpected(ok.error());
      }
    }
    if (source_.goes_on())
      return fail(ErrorCode::Unreadable, "the file goes on after the elements that its head promises", name_,
                  "Correct the counts at its head or export the file again");
    return make_soup(coordinates_, std::move(faces_), true, [this](int f) {
      const std::string face = "face " + std::to_string(f);
      return name_ + (face_lines_.empty() ? ", " : ":" + std::to_string(face_lines_[f]) + ", ") + face;
    });
  }

 private:
  static bool is_corner_list(const PlyProperty& p) {
    return p.list && (p.name == "vertex_indices" || p.name == "vertex_index");
  }

  // "roof.ply:17, vertex 3" or, for binary, "roof.ply, vertex 3".
  std::string where() const {
    return name_ + (source_.line() > 0 ? ":" + std::to_string(source_.line()) : "") + ", " + element_->name +
           " " + std::to_string(index_);
  }

  tl::unexpected<Error> unreadable_value() const {
    if (!source_.ended())
      return fail(ErrorCode::Unreadable, source_.bad_value(), where(),
                  "Correct the line or export the file again");
    return fail(ErrorCode::Unreadable,
                "the file ends inside " + element_->name + " " + std::to_string(index_) + " (of " +
                    std::to_string(element_->count) + ", counted from 0)",
                where(), "It may have been cut off; export it again");
  }

  // Positions and corners must be declared.
  Result<void> check_elements() {
    bool vertices = false, faces = false, strips = false;
    for (const PlyElement& element : header_.elements) {
      if (element.name == "tristrips") strips = true;
      if (element.name == "face") {
        faces = true;
        if (std::none_of(element.properties.begin(), element.properties.end(), is_corner_list))
          return fail(ErrorCode::Unreadable, "the faces have no list named vertex_indices or vertex_index",
                      name_, kExportAgain);
      }
      if (element.name != "vertex") continue;
      vertices = true;
      for (int axis = 0; axis < 3; ++axis) {
        const std::string wanted(1, static_cast<char>('x' + axis));
        const auto found = std::find_if(element.properties.begin(), element.properties.end(),
                                        [&](const PlyProperty& p) { return p.name == wanted && !p.list; });
        if (found == element.properties.end())
          return fail(ErrorCode::Unreadable, "the vertices have no property " + wanted, name_, kExportAgain);
        axis_property_[axis] = static_cast<size_t>(found - element.properties.begin());
      }
    }
    if (!vertices)
      return fail(ErrorCode::Unreadable, "the file declares no vertices", name_,
                  "Check that it holds a mesh");
    if (!faces && strips)
      return fail(ErrorCode::Unreadable, "triangle strips are not read", name_,
                  "Export the mesh with single faces");
    return {};
  }

  // Refuses a count that the rest of the file cannot hold.
  Result<void> check_count() const {
    long long least = 0;
    for (const PlyProperty& p : element_->properties)
      least += Source::least_size(p.list ? p.count_type : p.type);
    if (least == 0 || element_->count <= static_cast<long long>(source_.remaining()) / least) return {};
    return fail(ErrorCode::Unreadable,
                "the file promises " + std::to_string(element_->count) + " elements \"" + element_->name +
                    "\", more than its last " + std::to_string(source_.remaining()) + " bytes can hold",
                name_, "It may have been cut off; export it again");
  }

  Result<void> pass_over(const PlyProperty& p) {
    long long count = 1;
    if (p.list) {
      const auto length = read_length(p);
      if (!length) return tl::unexpected(length.error());
      count = *length;
    }
    if (!source_.skip(p.type, count)) return unreadable_value();
    return {};
  }

  Result<void> pass_over() {
    for (const PlyProperty& p : element_->properties)
      if (auto ok = pass_over(p); !ok) return ok;
    return {};
  }

  Result<long long> read_length(const PlyProperty& p) {
    const auto value = source_.value(p.count_type);
    if (!value) return unreadable_value();
    if (!(*value >= 0.0) || *value != std::floor(*value))
      return fail(ErrorCode::Unreadable, "a list has an impossible length", where(), kExportAgain);
    if (*value > static_cast<double>(source_.remaining())) {
      return fail(ErrorCode::Unreadable, "a list is longer than the rest of the file", where(),
                  "It may have been cut off; export it again");
    }
    return static_cast<long long>(*value);
  }

  Result<void> read_vertex() {
    double position[3] = {0.0, 0.0, 0.0};
    for (size_t i = 0; i < element_->properties.size(); ++i) {
      const PlyProperty& p = element_->properties[i];
      const auto axis = std::find(axis_property_.begin(), axis_property_.end(), i) - axis_property_.begin();
      if (axis == 3) {
        if (auto ok = pass_over(p); !ok) return ok;
        continue;
      }
      const auto value = source_.value(p.type);
      if (!value) return unreadable_value();
      if (!std::isfinite(*value))
        return fail(ErrorCode::Unreadable, "a coordinate is not a finite number", where(),
                    "Correct or remove the vertex");
      position[axis] = *value;
    }
    coordinates_.insert(coordinates_.end(), position, position + 3);
    return {};
  }

  Result<void> read_face() {
    bool taken = false;
    for (const PlyProperty& p : element_->properties) {
      if (taken || !is_corner_list(p)) {
        if (auto ok = pass_over(p); !ok) return ok;
        continue;
      }
      taken = true;
      if (auto ok = read_corners(p); !ok) return ok;
    }
    return {};
  }

  Result<void> read_corners(const PlyProperty& p) {
    const auto length = read_length(p);
    if (!length) return tl::unexpected(length.error());
    corners_.clear();
    for (long long k = 0; k < *length; ++k) {
      const auto value = source_.value(p.type);
      if (!value) return unreadable_value();
      if (!(*value >= 0.0) || *value > 2147483647.0 || *value != std::floor(*value))
        return fail(ErrorCode::Unreadable, "a corner is not the number of a vertex", where(),
                    "Correct the face or export the file again");
      corners_.push_back(static_cast<int>(*value));
    }
    faces_.push_back(corners_);
    if (source_.line() > 0) face_lines_.push_back(source_.line());
    return {};
  }

  const PlyHeader& header_;
  Source source_;
  std::string name_;
  const PlyElement* element_ = nullptr;
  long long index_ = 0;
  std::array<size_t, 3> axis_property_{};  // which properties of a vertex are x, y and z
  std::vector<double> coordinates_;
  Polygons faces_;
  std::vector<int> face_lines_;  // text only
  std::vector<int> corners_;
};

}  // namespace

Result<PolygonSoup> read_ply(std::string_view content, const std::string& name) {
  TextScanner scanner(content, name);
  const auto header = PlyHeaderReader(scanner).read();
  if (!header) return tl::unexpected(header.error());
  if (header->encoding == PlyEncoding::Ascii)
    return PlyBodyReader<AsciiSource>(*header, AsciiSource(scanner), name).read();
  const std::string_view body = content.substr(scanner.position());
  const BinarySource source(body, header->encoding == PlyEncoding::BigEndian);
  return PlyBodyReader<BinarySource>(*header, source, name).read();
}

}  // namespace planewright
