#include "core/design/pin_file.h"

#include <gtest/gtest.h>

#include "support/complexes.h"

namespace planewright {
namespace {

using namespace test;

// 2 x 2 quads cut into triangles: 9 vertices, 8 faces; z = 0.
PolygonMesh triangles() {
  return triangle_grid(2, 2).mesh();
}

TEST(PinFile, ReadsEveryKind) {
  const PolygonMesh mesh = triangles();
  const auto file = parse_pin_file(
      "# the foundation\r\n"
      "face 3 1.5 - *   # comment\n"
      "\n"
      "  corner 8 * * -2e-1\n"
      "edge 0 1 2 3\n"
      "edge 0 1 7 8 9\n"
      "vertex 4 - - 0\n"
      "plane vertex 5\n"
      "plane face 2 0 0 2 1.5",
      "p.txt", mesh);
  ASSERT_TRUE(file) << file.error().text();
  using Kind = PinCoordinate::Kind;
  ASSERT_EQ(file->points.size(), 5u);
  const auto& first = file->points[0];
  EXPECT_EQ(first.point, (PointOrigin{PointKind::Face, 3}));
  EXPECT_EQ(first.where, "p.txt:2");
  EXPECT_EQ(first.at[0].kind, Kind::Given);
  EXPECT_EQ(first.at[0].value, 1.5);
  EXPECT_EQ(first.at[1].kind, Kind::Free);
  EXPECT_EQ(first.at[2].kind, Kind::Wanted);
  EXPECT_EQ(file->points[1].point, (PointOrigin{PointKind::Corner, 8}));
  EXPECT_EQ(file->points[1].at[2].value, -0.2);
  EXPECT_EQ(file->points[2].point, (PointOrigin{PointKind::BorderEdge, 0}));
  EXPECT_EQ(file->points[2].at[2].value, 3.0);
  EXPECT_EQ(file->points[3].point, (PointOrigin{PointKind::BorderEdge, mesh.find_edge(0, 1)}));
  EXPECT_EQ(file->points[3].at[0].value, 7.0);
  EXPECT_EQ(file->points[4].point, (PointOrigin{PointKind::Vertex, 4}));
  ASSERT_EQ(file->planes.size(), 2u);
  EXPECT_TRUE(file->planes[0].of_vertex);
  EXPECT_EQ(file->planes[0].element, 5);
  EXPECT_FALSE(file->planes[0].plane);
  EXPECT_FALSE(file->planes[1].of_vertex);
  ASSERT_TRUE(file->planes[1].plane);
  EXPECT_EQ(file->planes[1].plane->normal, (std::array{0.0, 0.0, 2.0}));
  EXPECT_EQ(file->planes[1].plane->distance, 1.5);
}

TEST(PinFile, AnEmptyFileHoldsNothing) {
  const auto file = parse_pin_file("# nothing\n\n", "p.txt", triangles());
  ASSERT_TRUE(file);
  EXPECT_TRUE(file->points.empty() && file->planes.empty());
}

TEST(PinFile, RefusesWithTheLine) {
  const struct {
    const char* line;
    const char* says;
  } wrong[] = {
      {"point 3 0 0 0", "\"point\""},       {"face 3 0 0", "three coordinates"},
      {"face 3 0 0 0 0", "three coord"},    {"edge 1 2 0 0 0 0", "three coordinates"},
      {"face", "three coordinates"},        {"face x 0 0 0", "\"x\""},
      {"face 8 0 0 0", "no face 8"},        {"face -1 0 0 0", "no face -1"},
      {"vertex 9 0 0 0", "no vertex 9"},    {"edge 99 0 0 0", "no edge 99"},
      {"edge 0 8 0 0 0", "no edge joins"},  {"edge 0 9 0 0 0", "no vertex 9"},
      {"corner 9 0 0 0", "no vertex 9"},    {"face 3 0 zero 0", "\"zero\""},
      {"face 3 0 nan 0", "\"nan\""},        {"face 3 - - -", "no coordinate"},
      {"plane 3", "'vertex' or 'face'"},    {"plane vertex", "four numbers"},
      {"plane vertex 3 0 0 1", "four num"}, {"plane vertex 9", "no vertex 9"},
      {"plane face 8", "no face 8"},        {"plane vertex 3 0 0 0 1", "0 0 0"},
      {"plane vertex 3 0 0 - 1", "\"-\""},
  };
  for (const auto& [line, says] : wrong) {
    const auto file = parse_pin_file(std::string("face 0 0 0 0\n\n") + line + "\n", "p.txt", triangles());
    ASSERT_FALSE(file) << line;
    EXPECT_EQ(file.error().code, ErrorCode::Unreadable) << line;
    EXPECT_EQ(file.error().where, "p.txt:3") << line;
    EXPECT_NE(file.error().what.find(says), std::string::npos) << line << ": " << file.error().text();
  }
}

TEST(PinFile, WantedCoordinatesAreThoseOfTheComplexInModelCoordinates) {
  Shape shape = triangle_grid(2, 2);
  shape.positions.rowwise() += Eigen::RowVector3d(1000, 2000, 3000);
  const PolygonMesh mesh = shape.mesh();
  const TangentComplex complex = build_dual(mesh, {0.5, BorderPolicy::Closed}).value();
  const auto file = parse_pin_file("face 0 * - *\nplane vertex 4\n", "p.txt", mesh).value();
  Demands demands;
  demands.pins.push_back({{PointKind::Face, 5}, {1.0, {}, {}}});
  ASSERT_TRUE(add_pins(file, complex, demands));
  ASSERT_EQ(demands.pins.size(), 2u);  // those that were there stay
  const Pin& pin = demands.pins[1];
  EXPECT_EQ(pin.point, (PointOrigin{PointKind::Face, 0}));
  EXPECT_NEAR(*pin.at[0], 1000.0 + 2.0 / 3.0, 1e-9);
  EXPECT_FALSE(pin.at[1]);
  EXPECT_NEAR(*pin.at[2], 3000.5, 1e-9);  // lifted by the offset
  EXPECT_EQ(demands.plane_pins, (std::vector<PlanePin>{{4, std::nullopt}}));
}

TEST(PinFile, RefusesPointsAndPanelsThatTheComplexDoesNotHave) {
  const PolygonMesh mesh = triangles();
  const TangentComplex dual = build_dual(mesh, {0.0, BorderPolicy::Closed}).value();
  const TangentComplex planarize = build_planarize(mesh, {0.0}).value();
  const std::string inner = "edge " + std::to_string(mesh.find_edge(0, 4)) + " 0 0 0";
  const auto refuse = [&](const std::string& line, const TangentComplex& complex, const std::string& says) {
    Demands demands;
    const auto added = add_pins(parse_pin_file("\n" + line, "p.txt", mesh).value(), complex, demands);
    ASSERT_FALSE(added) << line;
    EXPECT_EQ(added.error().code, ErrorCode::Unreadable);
    EXPECT_EQ(added.error().where, "p.txt:2");
    EXPECT_NE(added.error().text().find(says), std::string::npos) << added.error().text();
    EXPECT_EQ(demands, Demands{});
  };
  refuse("vertex 4 0 0 0", dual, "no point of vertex 4");
  refuse("corner 4 0 0 0", dual, "no point of corner 4");  // an inner vertex has none
  refuse(inner, dual, "no point of edge");
  refuse("face 0 0 0 0", planarize, "no point of face 0");
  refuse("plane face 0", dual, "belong to vertices");
  refuse("plane vertex 0", planarize, "panels are the faces");
}

TEST(PinFile, ContradictionsNameBothLines) {
  const PolygonMesh mesh = triangles();
  const TangentComplex complex = build_dual(mesh, {0.0, BorderPolicy::Closed}).value();
  const auto added = [&](const std::string& text) {
    Demands demands;
    return add_pins(parse_pin_file(text, "p.txt", mesh).value(), complex, demands);
  };
  for (const char* text :
       {"face 0 0 - -\nface 0 - 1 -\nface 0 1 - -\n", "plane vertex 4\n\nplane vertex 4 0 0 1 2\n"}) {
    const auto contradicting = added(text);
    ASSERT_FALSE(contradicting) << text;
    EXPECT_EQ(contradicting.error().code, ErrorCode::Infeasible);
    EXPECT_NE(contradicting.error().what.find("p.txt:1"), std::string::npos) << contradicting.error().text();
    EXPECT_NE(contradicting.error().what.find("p.txt:3"), std::string::npos) << contradicting.error().text();
  }
  // Different coordinates of one point, or the same place twice, are none.
  EXPECT_TRUE(added("face 0 0 - -\nface 0 - 1 -\nface 0 0 1 -\n"));
  EXPECT_TRUE(added("face 0 * * *\nface 0 * * *\n"));
}

}  // namespace
}  // namespace planewright
