// Valid files, cut off and changed at random (the same way every time): whatever comes out, the readers
// answer with a mesh or with an error that says where, and never crash or hang.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

#include "core/mesh/mesh_io.h"
#include "support/shapes.h"

namespace planewright {
namespace {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  size_t below(size_t n) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<size_t>(state_ >> 33) % n;
  }

 private:
  std::uint64_t state_;
};

void append_bytes(std::string& out, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) out += static_cast<char>(value >> (8 * i) & 0xff);
}

std::string binary_ply(const test::Shape& shape) {
  std::string out =
      "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(shape.positions.rows()) +
      "\nproperty float x\nproperty float y\nproperty float z\nproperty list uchar uchar extra\n"
      "element face " +
      std::to_string(shape.faces.size()) + "\nproperty list int int vertex_indices\nend_header\n";
  for (Eigen::Index v = 0; v < shape.positions.rows(); ++v) {
    for (int axis = 0; axis < 3; ++axis)
      append_bytes(out, std::bit_cast<std::uint32_t>(static_cast<float>(shape.positions(v, axis))));
    out += std::string("\2ab", 3);
  }
  for (int f = 0; f < shape.faces.size(); ++f) {
    append_bytes(out, static_cast<std::uint32_t>(shape.faces.valence(f)));
    for (int v : shape.faces[f]) append_bytes(out, static_cast<std::uint32_t>(v));
  }
  return out;
}

std::string binary_stl(const test::Shape& shape) {
  std::string out(80, 's');
  append_bytes(out, static_cast<std::uint32_t>(shape.faces.size()));
  for (int f = 0; f < shape.faces.size(); ++f) {
    out += std::string(12, '\0');
    for (int v : shape.faces[f])
      for (int axis = 0; axis < 3; ++axis)
        append_bytes(out, std::bit_cast<std::uint32_t>(static_cast<float>(shape.positions(v, axis))));
    out += std::string(2, '\0');
  }
  return out;
}

// A piece that parsers stumble over, or one byte.
std::string nasty_piece(Random& random) {
  static const char* kPieces[] = {"-",      "0",          "-1",     "4294967296", "99999999999999999999",
                                  "1e999",  "nan",        "\n",     "\r\n",       " ",
                                  "#",      "\\\n",       "f ",     "v ",         "/",
                                  "3",      "2147483647", "OFF",    "list",       "end_header\n",
                                  "vertex", "e",          "1e-999", "endloop"};
  if (random.below(2) == 0) return kPieces[random.below(std::size(kPieces))];
  return std::string(1, static_cast<char>(random.below(256)));
}

std::string mutated(std::string text, Random& random) {
  for (size_t changes = 1 + random.below(4); changes > 0 && !text.empty(); --changes) {
    const size_t at = random.below(text.size());
    switch (random.below(6)) {
      case 0:
        text.resize(at);
        break;
      case 1:
        text.insert(at, nasty_piece(random));
        break;
      case 2:
        text.erase(at, 1 + random.below(20));
        break;
      case 3:
        text.insert(at, text.substr(random.below(text.size()), random.below(60)));
        break;
      default:
        text[at] = nasty_piece(random)[0];
        break;
    }
  }
  return text;
}

void survive(const std::string& original, MeshFormat format, std::uint64_t seed) {
  ASSERT_TRUE(parse_mesh(original, format, "a"));
  Random random(seed);
  auto read = [&](const std::string& text) {
    const auto soup = parse_mesh(text, format, "a");
    if (!soup) {
      EXPECT_FALSE(soup.error().what.empty());
      EXPECT_EQ(soup.error().where.front(), 'a');
      EXPECT_FALSE(soup.error().remedy.empty()) << soup.error().text();
      return;
    }
    EXPECT_TRUE(soup->positions.allFinite());
    for (int v : soup->faces.indices()) {
      ASSERT_GE(v, 0);
      ASSERT_LT(v, soup->positions.rows());
    }
    const auto checked = check_and_repair(soup->positions, soup->faces);
    if (!checked) {
      EXPECT_EQ(checked.error().code, ErrorCode::Refused);
      EXPECT_TRUE(checked.error().what.starts_with("the mesh has no faces") ||
                  checked.error().what.starts_with("no face of the mesh"))
          << checked.error().text();
    }
  };
  for (size_t size = 0; size < original.size(); ++size) read(original.substr(0, size));
  for (int round = 0; round < 1500; ++round) read(mutated(original, random));
}

std::string text_of(MeshFormat format) {
  const test::Shape shape = test::cube();
  return format_mesh(format, shape.positions, shape.faces).value();
}

TEST(Mutation, Obj) {
  survive(text_of(MeshFormat::Obj) + "vt 0 0\nf 1/1/1 -2//3 3 \\\n 1\n", MeshFormat::Obj, 1);
}
TEST(Mutation, Off) {
  survive(text_of(MeshFormat::Off), MeshFormat::Off, 2);
}
TEST(Mutation, OffWithColours) {
  survive("COFF # colours\n3 1 0\n0 0 0 1 1 1\n1 0 0 1 1 1\n0 1 0 1 1 1\n3 0 1\n2\n", MeshFormat::Off, 3);
}
TEST(Mutation, PlyAscii) {
  survive(text_of(MeshFormat::Ply), MeshFormat::Ply, 4);
}
TEST(Mutation, PlyBinary) {
  survive(binary_ply(test::cube()), MeshFormat::Ply, 5);
}
TEST(Mutation, StlAscii) {
  survive(text_of(MeshFormat::Stl), MeshFormat::Stl, 6);
}
TEST(Mutation, StlBinary) {
  survive(binary_stl(test::octahedron()), MeshFormat::Stl, 7);
}

}  // namespace
}  // namespace planewright
