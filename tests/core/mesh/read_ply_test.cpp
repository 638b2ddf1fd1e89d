#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>

#include "core/mesh/mesh_io.h"
#include "support/shapes.h"

namespace planewright {
namespace {

Result<PolygonSoup> parse(std::string_view text) {
  return parse_mesh(text, MeshFormat::Ply, "a.ply");
}

const Points kSquare = test::make_points({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
const Polygons kFaces{{0, 1, 2}, {0, 2, 3}};

void expect_square(std::string_view text) {
  const auto soup = parse(text);
  ASSERT_TRUE(soup) << soup.error().text();
  EXPECT_EQ(soup->positions, kSquare);
  EXPECT_EQ(soup->faces, kFaces);
}

void expect_error(std::string_view text, const std::string& where, const std::string& what) {
  const auto soup = parse(text);
  ASSERT_FALSE(soup);
  EXPECT_EQ(soup.error().code, ErrorCode::Unreadable);
  EXPECT_EQ(soup.error().where, where);
  EXPECT_NE(soup.error().what.find(what), std::string::npos) << soup.error().text();
  EXPECT_FALSE(soup.error().remedy.empty());
}

std::string head(const std::string& format, const std::string& elements) {
  return "ply\nformat " + format + " 1.0\ncomment made for a test\n" + elements + "end_header\n";
}

constexpr const char* kPlain =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 2\n"
    "property list uchar int vertex_indices\n";

// Values appended as bytes, in either order.
class Bytes {
 public:
  explicit Bytes(bool big_endian) : swap_(big_endian != (std::endian::native == std::endian::big)) {}
  template <class T>
  Bytes& add(T value) {
    auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if (swap_) std::reverse(bytes.begin(), bytes.end());
    text_.append(bytes.data(), bytes.size());
    return *this;
  }
  const std::string& text() const { return text_; }

 private:
  bool swap_;
  std::string text_;
};

TEST(ReadPly, ReadsAscii) {
  expect_square(head("ascii", kPlain) + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
  expect_square(
      "ply\r\nformat ascii 1.0\r\nelement vertex 4\r\nproperty double x\r\nproperty double y\r\n"
      "property double z\r\nelement face 2\r\nproperty list uchar int vertex_index\r\nend_header\r\n"
      "0 0 0\r\n1 0 0\r\n1 1 0\r\n0 1 0\r\n3 0 1 2\r\n3 0 2 3");
}

TEST(ReadPly, PassesOverOtherElementsAndProperties) {
  expect_square(
      head("ascii",
           "obj_info x\nelement camera 1\nproperty float view\nproperty list uchar float lens\n"
           "element vertex 4\nproperty float nx\nproperty float y\nproperty double z\nproperty uchar red\n"
           "property int32 x\nproperty list uchar int extra\nelement face 2\nproperty uchar flag\n"
           "property list uint8 uint32 vertex_indices\nproperty list uchar float texcoord\n"
           "element edge 1\nproperty int vertex1\nproperty int vertex2\nelement nothing 3\n") +
      "1.5 2 7 8\n"
      "nan 0 0 255 0 0\nnan 0 0 255 1 1 5\nnan 1 0 255 1 2 5 6\nnan 1 0 255 0 0\n"
      "1 3 0 1 2 6 0 0 0 0 0 0\n0 3 0 2 3 0\n0 1\n");
}

TEST(ReadPly, ReadsBinaryBothWays) {
  for (bool big_endian : {false, true}) {
    Bytes body(big_endian);
    for (int v = 0; v < 4; ++v)
      for (int axis = 0; axis < 3; ++axis) body.add(static_cast<float>(kSquare(v, axis)));
    for (int f = 0; f < 2; ++f) {
      body.add(std::uint8_t{3});
      for (int v : kFaces[f]) body.add(std::int32_t{v});
    }
    const std::string format = big_endian ? "binary_big_endian" : "binary_little_endian";
    expect_square(head(format, kPlain) + body.text());
    // With Windows line ends in the head.
    std::string windows = head(format, kPlain);
    for (size_t i = 0; (i = windows.find('\n', i)) != windows.npos; i += 2) windows.insert(i, 1, '\r');
    expect_square(windows + body.text());
    // Cut off anywhere, it must say so.
    for (size_t size = 0; size < body.text().size(); ++size)
      EXPECT_FALSE(parse(head(format, kPlain) + body.text().substr(0, size)));
    expect_error(head(format, kPlain) + body.text() + "more", "a.ply", "goes on");
  }
}

TEST(ReadPly, ReadsEveryBinaryType) {
  const std::string elements =
      "element vertex 4\nproperty short a\nproperty double x\nproperty uint b\nproperty char y\nproperty "
      "list ushort "
      "double c\nproperty ushort z\nelement extra 1\nproperty int64 d\nproperty uint64 e\nelement face "
      "2\nproperty "
      "list int uint16 vertex_indices\nproperty int8 f\n";
  for (bool big_endian : {false, true}) {
    Bytes body(big_endian);
    for (int v = 0; v < 4; ++v) {
      body.add(std::int16_t{-5})
          .add(kSquare(v, 0))
          .add(std::uint32_t{7})
          .add(static_cast<std::int8_t>(kSquare(v, 1)));
      body.add(std::uint16_t{2}).add(1.0).add(2.0).add(static_cast<std::uint16_t>(kSquare(v, 2)));
    }
    body.add(std::int64_t{1}).add(std::uint64_t{2});
    for (int f = 0; f < 2; ++f) {
      body.add(std::int32_t{3});
      for (int v : kFaces[f]) body.add(static_cast<std::uint16_t>(v));
      body.add(std::int8_t{1});
    }
    expect_square(head(big_endian ? "binary_big_endian" : "binary_little_endian", elements) + body.text());
  }
}

TEST(ReadPly, NamesTheElementOfABadBinaryValue) {
  Bytes body(false);
  for (int v = 0; v < 4; ++v)
    for (int axis = 0; axis < 3; ++axis)
      body.add(v == 2 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(kSquare(v, axis)));
  for (int f = 0; f < 2; ++f) body.add(std::uint8_t{3}).add(0).add(1).add(2);
  expect_error(head("binary_little_endian", kPlain) + body.text(), "a.ply, vertex 2", "not a finite number");
}

TEST(ReadPly, NamesTheLineOfABadValue) {
  const std::string plain = head("ascii", kPlain);  // 11 lines
  const std::string vertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  expect_error(plain + "0 0 0\n1 x 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n", "a.ply:12, vertex 1",
               "\"x\" is not a number");
  expect_error(plain + "0 0 0\n1 inf 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n", "a.ply:12, vertex 1",
               "not a finite number");
  expect_error(plain + vertices + "3 0 1 2\n3 0 2 9\n", "a.ply:16, face 1", "vertex 9, but the file has 4");
  expect_error(plain + vertices + "3 0 1 2\n3 0 2 -1\n", "a.ply:16, face 1", "not the number of a vertex");
  expect_error(plain + vertices + "3 0 1 2\n3 0 2 0.5\n", "a.ply:16, face 1", "not the number of a vertex");
  expect_error(plain + vertices + "3 0 1 2\n-3 0 2 3\n", "a.ply:16, face 1", "impossible length");
  expect_error(plain + vertices + "3 0 1 2\n99999999 0 2 3\n", "a.ply:16, face 1", "longer than the rest");
  expect_error(plain + vertices + "3 0 1 2\n3 0 2", "a.ply:16, face 1", "ends inside face 1");
  expect_error(plain + vertices + "3 0 1 2\n3 0 2 3\n3 1 2 3\n", "a.ply", "goes on");
}

TEST(ReadPly, ReadsFilesThatCountFromOne) {
  const auto soup = parse(head("ascii", kPlain) + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 1 2 3\n3 1 3 4\n");
  ASSERT_TRUE(soup);
  EXPECT_TRUE(soup->one_based_indices);
  EXPECT_EQ(soup->faces, kFaces);
}

TEST(ReadPly, NamesTheLineOfABadHead) {
  expect_error("plx\n", "a.ply:1", "begins with \"ply\"");
  expect_error("ply\nformat ascii 1.0\nelement vertex 3\n", "a.ply:3", "ends inside its head");
  expect_error("ply\nformat utf 1.0\n", "a.ply:2", "\"utf\" is unknown");
  expect_error("ply\nfrmat ascii 1.0\n", "a.ply:2", "\"frmat\" is unknown");
  expect_error("ply\nformat ascii 1.0\nproperty float x\n", "a.ply:3", "before the first element");
  expect_error("ply\nformat ascii 1.0\nelement vertex -3\n", "a.ply:3", "\"-3\"");
  expect_error("ply\nformat ascii 1.0\nelement vertex 3\nproperty half x\n", "a.ply:4",
               "\"half\" is not a known type");
  expect_error("ply\nformat ascii 1.0\nelement vertex 3\nproperty float\n", "a.ply:4", "no name");
  expect_error("ply\nformat ascii 1.0\nelement f 3\nproperty list float int v\n", "a.ply:4",
               "length of a list");
  expect_error("ply\nformat ascii 1.0\nelement f 3\nelement f 3\n", "a.ply:4", "declared twice");
  expect_error("ply\nelement vertex 0\nend_header\n", "a.ply:3", "no format");
}

TEST(ReadPly, RefusesFilesWithoutPositionsOrFaces) {
  expect_error(head("ascii", "element face 0\nproperty list uchar int vertex_indices\n"), "a.ply",
               "no vertices");
  expect_error(head("ascii", "element vertex 0\nproperty float x\nproperty float y\n"), "a.ply",
               "no property z");
  expect_error(head("ascii",
                    "element vertex 0\nproperty float x\nproperty float y\nproperty float z\nelement face 0\n"
                    "property list uchar int corners\n"),
               "a.ply", "vertex_indices");
  expect_error(head("ascii",
                    "element vertex 0\nproperty float x\nproperty float y\nproperty float z\n"
                    "element tristrips 0\nproperty list int int vertex_indices\n"),
               "a.ply", "triangle strips");
}

TEST(ReadPly, RefusesImpossibleCountsAtOnce) {
  std::string elements = kPlain;
  elements.replace(elements.find('4'), 1, "4000000000000000000");
  for (const char* format : {"ascii", "binary_little_endian"})
    expect_error(head(format, elements) + "0 0 0\n", "a.ply", "promises 4000000000000000000");
}

}  // namespace
}  // namespace planewright
