#include "core/writers/solid_writers.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>

#include "support/python.h"
#include "support/writer_scenes.h"

namespace planewright {
namespace {

using namespace test;
using Json = nlohmann::json;

// All print [[name, [points, mm], [faces]], ...] and what else the format says.
constexpr const char* kObj = R"(
import sys, json
points, parts, head = [], [], []
for l in open(sys.argv[1]):
    w = l.split()
    if l[0] == "#": head.append(l.strip())
    elif w[0] == "v": points.append([float(x) for x in w[1:]])
    elif w[0] in "og": parts.append([w[1], None, []])
    elif w[0] == "f": parts[-1][2].append([int(x) - 1 for x in w[1:]])
for p in parts: p[1] = points
print(json.dumps({"parts": parts, "head": head, "count": len(points)}))
)";
constexpr const char* kPly = R"(
import sys, json
lines = open(sys.argv[1]).read().split("\n")
end = lines.index("end_header")
names = {int(l.split()[2]): l.split()[3] for l in lines[:end] if l.startswith("comment panel ")}
nv, nf = [int(l.split()[2]) for l in lines[:end] if l.startswith("element")]
body = lines[end + 1:]
points = [[float(x) for x in l.split()] for l in body[:nv]]
parts = {}
for l in body[nv:nv + nf]:
    w = [int(x) for x in l.split()]
    assert len(w) == w[0] + 2
    parts.setdefault(w[-1], []).append(w[1:-1])
assert body[nv + nf:] == [""]
print(json.dumps({"parts": [[names[p], points, f] for p, f in sorted(parts.items())], "head": lines[:end],
                  "count": nv}))
)";
constexpr const char* kGltf = R"(
import sys, json, struct
b = open(sys.argv[1], "rb").read()
magic, version, length, n, kind = struct.unpack("<IIIII", b[:20])
assert magic == 0x46546C67 and version == 2 and length == len(b) and kind == 0x4E4F534A
g = json.loads(b[20:20 + n]); data = b[28 + n:]
def values(k, fmt, size):
    a = g["accessors"][k]; v = g["bufferViews"][a["bufferView"]]; o = v.get("byteOffset", 0)
    return [struct.unpack_from(fmt, data, o + i * size) for i in range(a["count"])]
parts = []
for k in g["scenes"][g["scene"]]["nodes"]:
    node = g["nodes"][k]; mesh = g["meshes"][node["mesh"]]; t = node["translation"]
    assert all(struct.unpack("<f", struct.pack("<f", x))[0] == x for x in t)
    p = mesh["primitives"][0]
    up = [[q[i] + t[i] for i in range(3)] for q in values(p["attributes"]["POSITION"], "<fff", 12)]
    i = [x[0] for x in values(p["indices"], "<I", 4)]
    parts.append([node["name"], [[x * 1000, -z * 1000, y * 1000] for x, y, z in up],
                  [i[j:j + 3] for j in range(0, len(i), 3)]])
print(json.dumps({"parts": parts}))
)";
constexpr const char* k3mf = R"(
import sys, json, zipfile
import xml.etree.ElementTree as ET
S = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
root = ET.fromstring(zipfile.ZipFile(sys.argv[1]).read("3D/3dmodel.model"))
objects = {o.get("id"): o for o in root.iter(S + "object")}
parts = []
for item in root.iter(S + "item"):
    o = objects[item.get("objectid")]
    m = [float(x) for x in item.get("transform").split()]
    assert m[:9] == [1, 0, 0, 0, 1, 0, 0, 0, 1]
    points = [[float(v.get(a)) + m[9 + i] for i, a in enumerate("xyz")] for v in o.iter(S + "vertex")]
    parts.append([o.get("name"), points, [[int(t.get(a)) for a in ("v1", "v2", "v3")] for t in o.iter(S + "triangle")]])
print(json.dumps({"parts": parts, "unit": root.get("unit")}))
)";
constexpr const char* kStl = R"(
import sys, json, struct
b = open(sys.argv[1], "rb").read()
n, = struct.unpack_from("<I", b, 80)
assert len(b) == 84 + 50 * n
points, faces, turned = [], [], 0
for i in range(n):
    v = struct.unpack_from("<12f", b, 84 + 50 * i)
    faces.append([len(points), len(points) + 1, len(points) + 2])
    points += [list(v[3:6]), list(v[6:9]), list(v[9:12])]
print(json.dumps({"parts": [["", points, faces]], "head": b[:80].decode("ascii").rstrip()}))
)";

double volume(const Json& part) {
  double six = 0.0;
  const auto point = [&](const Json& index) {
    const Json& p = part[1][index.get<size_t>()];
    return Vector3d(p[0].get<double>(), p[1].get<double>(), p[2].get<double>());
  };
  const Vector3d first = point(0);
  for (const Json& face : part[2])
    for (size_t k = 1; k + 1 < face.size(); ++k) {
      const Vector3d a = point(face[0]) - first, b = point(face[k]) - first, c = point(face[k + 1]) - first;
      six += a.x() * (b.y() * c.z() - b.z() * c.y()) + a.y() * (b.z() * c.x() - b.x() * c.z()) +
             a.z() * (b.x() * c.y() - b.y() * c.x());
    }
  return six / 6.0;
}

// Each directed edge once, its reverse once.
bool closed(const Json& part) {
  std::map<std::pair<int, int>, int> edges;
  for (const Json& face : part[2])
    for (size_t k = 0; k < face.size(); ++k)
      ++edges[{face[k].get<int>(), face[(k + 1) % face.size()].get<int>()}];
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (count != 1 || back == edges.end() || back->second != 1) return false;
  }
  return !edges.empty();
}

struct Case {
  SolidFormat format;
  const char *name, *script, *file;
  double tolerance;  // mm
};
const Case kCases[] = {{SolidFormat::Obj, "Obj", kObj, "a.obj", 1e-9},
                       {SolidFormat::Ply, "Ply", kPly, "a.ply", 1e-9},
                       {SolidFormat::ThreeMf, "ThreeMf", k3mf, "a.3mf", 1e-4},
                       {SolidFormat::Gltf, "Gltf", kGltf, "a.glb", 1e-4}};

class SolidWriter : public testing::TestWithParam<Case> {
 protected:
  const Vector3d far_{4.0e6 + 0.3, -2.5e5, 1234.5};
  const WorkshopModel model_ = named_cube(1000.0 / 3.0, far_);
};

TEST_P(SolidWriter, SolidsAreClosedNamedAndInTheirPlace) {
  const std::string python = python_with("struct");
  if (python.empty()) GTEST_SKIP() << "no python";
  const ThickPanels solids = prisms(model_, 20.0);
  const auto bytes = format_solids(model_, solids, GetParam().format);
  ASSERT_TRUE(bytes) << bytes.error().text();
  const Json json = read_with_python(python, GetParam().script, *bytes, GetParam().file);
  ASSERT_TRUE(json.is_object());
  ASSERT_EQ(json["parts"].size(), 6u);
  for (size_t p = 0; p < 6; ++p) {
    const Json& part = json["parts"][p];
    EXPECT_EQ(part[0], model_.names[p]);
    EXPECT_TRUE(closed(part)) << p;
    EXPECT_NEAR(volume(part), 20.0 * 1e6 / 9.0, 20.0 * 1e6 * 1e-6) << p;
    const Points& points = solids.panels[p].points;
    // Text formats number the points of all parts through.
    const size_t first = part[1].size() == static_cast<size_t>(points.rows()) ? 0 : p * points.rows();
    for (int i = 0; i < points.rows(); ++i)
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(part[1][first + i][axis].get<double>(), points(i, axis) + far_[axis],
                    GetParam().tolerance);
  }
  if (GetParam().format == SolidFormat::ThreeMf) {
    EXPECT_EQ(json["unit"], "millimeter");
  }
  if (json.contains("head")) {
    EXPECT_NE(json["head"].dump().find("units: mm"), std::string::npos);
  }
}

TEST_P(SolidWriter, PanelsAreOneSurfaceOrRefused) {
  const std::string python = python_with("struct");
  if (python.empty()) GTEST_SKIP() << "no python";
  const auto bytes = format_panels(model_, GetParam().format);
  if (GetParam().format == SolidFormat::ThreeMf) {
    ASSERT_FALSE(bytes);
    EXPECT_EQ(bytes.error().code, ErrorCode::Usage);
    return;
  }
  ASSERT_TRUE(bytes);
  const Json json = read_with_python(python, GetParam().script, *bytes, GetParam().file);
  ASSERT_EQ(json["parts"].size(), 6u);
  if (!json.contains("count")) return;
  EXPECT_EQ(json["count"], 8);
  Json whole{"", json["parts"][0][1], Json::array()};
  for (int p = 0; p < 6; ++p) {
    EXPECT_EQ(json["parts"][p][0], model_.names[p]);
    EXPECT_EQ(json["parts"][p][2][0],
              Json(std::vector<int>(model_.panels[p].begin(), model_.panels[p].end())));
    whole[2].push_back(json["parts"][p][2][0]);
  }
  EXPECT_TRUE(closed(whole));
  EXPECT_NEAR(volume(whole), 1e9 / 27.0, 1.0);
}

TEST_P(SolidWriter, LeavesEmptySolidsOutAndRefusesBadNumbers) {
  ThickPanels solids = prisms(model_, 20.0);
  solids.panels[2].faces = {};
  solids.panels[2].points.resize(0, 3);
  EXPECT_TRUE(format_solids(model_, solids, GetParam().format));
  solids.panels[1].points(3, 0) = std::numeric_limits<double>::quiet_NaN();
  auto refused = format_solids(model_, solids, GetParam().format);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::Refused);
  EXPECT_NE(refused.error().text().find("B-1"), std::string::npos);
  solids.panels[1].faces = {{0, 1, 99}};
  EXPECT_FALSE(format_solids(model_, solids, GetParam().format));
}

INSTANTIATE_TEST_SUITE_P(Formats, SolidWriter, testing::ValuesIn(kCases),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(StlWriter, IsBinaryRelativeToTheOriginItNames) {
  const std::string python = python_with("struct");
  if (python.empty()) GTEST_SKIP() << "no python";
  const Vector3d far(-1.0 / 3.0 * 1e-5, -2.5e5 / 3.0, -1e7 / 7.0);
  const WorkshopModel model = named_cube(500.0, far);
  const auto bytes = format_solids(model, prisms(model, 20.0), SolidFormat::Stl);
  ASSERT_TRUE(bytes);
  const Json json = read_with_python(python, kStl, *bytes, "a.stl");
  ASSERT_TRUE(json.is_object());
  double x = 0.0, y = 0.0, z = 0.0;
  ASSERT_EQ(std::sscanf(json["head"].get<std::string>().c_str(), "mm at %lf %lf %lf", &x, &y, &z), 3);
  EXPECT_EQ(Vector3d(x, y, z), far);
  EXPECT_EQ(json["parts"][0][2].size(), 6u * 12u);
  EXPECT_NEAR(volume(json["parts"][0]), 6 * 20.0 * 500.0 * 500.0, 10.0);
}

}  // namespace
}  // namespace planewright
