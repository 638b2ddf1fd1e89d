#include "core/diagnose/crossings.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "core/complex/explicit_intersection.h"
#include "support/complexes.h"

namespace planewright {
namespace {

using namespace test;
using PairSet = std::set<std::pair<int, int>>;

PairSet pairs_of(const std::vector<Crossing>& crossings) {
  PairSet pairs;
  for (const Crossing& c : crossings) pairs.emplace(c.first, c.second);
  return pairs;
}

std::vector<Crossing> crossings(const Shape& first, const Shape& second, double touch = 0.0) {
  return find_crossings({first.positions, first.faces}, {second.positions, second.faces}, touch);
}
std::vector<Crossing> within(const Shape& shape, double touch = 0.0) {
  return find_crossings_within({shape.positions, shape.faces}, touch);
}

// A wide triangle in z = 0, and one across it whose lowest corner lies at z = -depth over its middle.
Shape floor_triangle() {
  return {make_points({{-10, -10, 0}, {10, -10, 0}, {0, 20, 0}}), {{0, 1, 2}}};
}
Shape spike(double depth) {
  return {make_points({{0, 0, -depth}, {0.5, 0.1, 1}, {-0.5, -0.1, 1}}), {{0, 1, 2}}};
}

// Triangles of three points of their own each, in the unit cube.
Shape soup(int count, unsigned seed, double size = 1.0) {
  std::mt19937 random(seed);
  const auto next = [&] { return static_cast<double>(random()) / 4294967295.0; };
  Shape shape;
  shape.positions.resize(3 * count, 3);
  for (int t = 0; t < count; ++t) {
    const Eigen::RowVector3d centre(next(), next(), next());
    for (int k = 0; k < 3; ++k)
      shape.positions.row(3 * t + k) =
          centre + size * (Eigen::RowVector3d(next(), next(), next()).array() - 0.5).matrix();
    shape.faces.push_back(std::array{3 * t, 3 * t + 1, 3 * t + 2});
  }
  return shape;
}

using Corners = std::array<Vector3d, 3>;
Corners corners(const Shape& shape, std::span<const int> face) {
  return {shape.positions.row(face[0]), shape.positions.row(face[1]), shape.positions.row(face[2])};
}

// Independent of the library: for triangles in general position, which random ones are, an edge of one goes
// through the other.
long double volume(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
  using Long = Eigen::Matrix<long double, 3, 1>;
  const Long u = (b - a).cast<long double>(), v = (c - a).cast<long double>(),
             w = (d - a).cast<long double>();
  return u.dot(v.cross(w));
}
bool goes_through(const Vector3d& p, const Vector3d& q, const Corners& t) {
  if ((volume(t[0], t[1], t[2], p) > 0) == (volume(t[0], t[1], t[2], q) > 0)) return false;
  const bool left = volume(p, q, t[0], t[1]) > 0;
  return left == (volume(p, q, t[1], t[2]) > 0) && left == (volume(p, q, t[2], t[0]) > 0);
}
bool brute_force(const Corners& s, const Corners& t) {
  for (int k = 0; k < 3; ++k)
    if (goes_through(s[k], s[(k + 1) % 3], t) || goes_through(t[k], t[(k + 1) % 3], s)) return true;
  return false;
}
Corners moved(Corners t, const Vector3d& by) {
  for (Vector3d& corner : t) corner += by;
  return t;
}

TEST(Crossings, ACornerThatPokesThroughIsAsDeepAsItPokes) {
  const auto found = crossings(spike(0.1), floor_triangle());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].first, 0);
  EXPECT_EQ(found[0].second, 0);
  EXPECT_NEAR(found[0].depth, 0.1, 1e-15);
  EXPECT_NEAR((found[0].apart - Vector3d::UnitZ()).norm(), 0.0, 1e-15);
  // The other way round the floor has to go down.
  const auto swapped = crossings(floor_triangle(), spike(0.1));
  ASSERT_EQ(swapped.size(), 1u);
  EXPECT_NEAR(swapped[0].depth, 0.1, 1e-15);
  EXPECT_NEAR((swapped[0].apart + Vector3d::UnitZ()).norm(), 0.0, 1e-15);
}

// Two edges that cross: the way out is along the product of their directions.
TEST(Crossings, EdgesThatCrossPartAcrossBoth) {
  const Shape lower{make_points({{-1, 0, 0.1}, {1, 0, 0.1}, {0, 0, -5}}), {{0, 1, 2}}};
  const Shape upper{make_points({{0, -1, -0.1}, {0, 1, -0.1}, {0, 0, 5}}), {{0, 1, 2}}};
  const auto found = crossings(upper, lower);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].depth, 0.2, 1e-15);
  EXPECT_NEAR((found[0].apart - Vector3d::UnitZ()).norm(), 0.0, 1e-15);
}

TEST(Crossings, TouchingIsNone) {
  EXPECT_TRUE(crossings(spike(0.0), floor_triangle()).empty());        // a corner on the face
  EXPECT_TRUE(crossings(floor_triangle(), floor_triangle()).empty());  // one on the other
  EXPECT_TRUE(crossings(spike(-0.1), floor_triangle()).empty());       // above
  const Shape beside{make_points({{-10, -10, 0}, {10, -10, 0}, {0, -12, 3}}), {{0, 1, 2}}};
  EXPECT_TRUE(crossings(beside, floor_triangle()).empty());  // an edge in common
  // Turned, what touches does so only up to rounding.
  const Matrix3d turn = Eigen::AngleAxisd(1.1, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  for (Shape shape : {spike(0.0), beside, floor_triangle()}) {
    Shape floor = floor_triangle();
    shape.positions *= turn.transpose();
    floor.positions *= turn.transpose();
    EXPECT_TRUE(crossings(shape, floor).empty());
  }
}

TEST(Crossings, ThatAreNotDeeperThanTheMarginAreNone) {
  EXPECT_TRUE(crossings(spike(0.1), floor_triangle(), 0.1000001).empty());
  EXPECT_EQ(crossings(spike(0.1), floor_triangle(), 0.0999999).size(), 1u);
  EXPECT_EQ(crossings(spike(1e-9), floor_triangle(), 0.0).size(), 1u);
}

// The plane across `apart` behind the second triangle is where the first has to be: what rows are made of.
TEST(Crossings, NameTheTrianglesThatAPlaneCanPart) {
  const Shape first = soup(40, 1), second = soup(40, 2);
  const auto found = crossings(first, second);
  ASSERT_GT(found.size(), 20u);
  for (const Crossing& c : found) {
    EXPECT_NEAR(c.apart.norm(), 1.0, 1e-14);
    double low = 1e9, high = -1e9;
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(c.first_corners[k], first.faces[c.first][k]);
      EXPECT_EQ(c.second_corners[k], second.faces[c.second][k]);
      low = std::min(low, first.positions.row(c.first_corners[k]).dot(c.apart));
      high = std::max(high, second.positions.row(c.second_corners[k]).dot(c.apart));
    }
    EXPECT_NEAR(high - low, c.depth, 1e-14);
  }
}

TEST(Crossings, OfRandomTrianglesAreThoseOfBruteForce) {
  for (const double size : {0.2, 1.0}) {
    const Shape first = soup(150, 3, size), second = soup(120, 4, size);
    PairSet expected;
    for (int s = 0; s < first.faces.size(); ++s)
      for (int t = 0; t < second.faces.size(); ++t)
        if (brute_force(corners(first, first.faces[s]), corners(second, second.faces[t])))
          expected.emplace(s, t);
    EXPECT_GT(expected.size(), 20u);
    EXPECT_EQ(pairs_of(crossings(first, second)), expected);
  }
}

TEST(Crossings, DepthIsTheSmallestMoveThatParts) {
  const Shape first = soup(12, 5), second = soup(12, 6);
  const auto found = crossings(first, second);
  ASSERT_GT(found.size(), 5u);
  for (const Crossing& c : found) {
    const Corners s = corners(first, first.faces[c.first]), t = corners(second, second.faces[c.second]);
    EXPECT_FALSE(brute_force(moved(s, 1.0001 * c.depth * c.apart), t));
    EXPECT_TRUE(brute_force(moved(s, 0.9999 * c.depth * c.apart), t));
    // No shorter move in any direction does.
    constexpr int kDirections = 2000;
    for (int k = 0; k < kDirections; ++k) {
      const double z = 1.0 - (2.0 * k + 1.0) / kDirections, angle = 2.399963229728653 * k;
      const Vector3d direction(std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle),
                               z);
      EXPECT_TRUE(brute_force(moved(s, 0.999 * c.depth * direction), t));
    }
  }
}

TEST(Crossings, DoNotDependOnTheOrderOfPolygons) {
  const Shape first = soup(60, 7), second = soup(50, 8);
  const auto found = crossings(first, second);
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end(), [](const Crossing& a, const Crossing& b) {
    return std::pair(a.first, a.second) < std::pair(b.first, b.second);
  }));
  EXPECT_EQ(pairs_of(found).size(), found.size());
  std::vector<int> order(60);
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(9));
  Shape shuffled{first.positions, {}};
  for (int f : order) shuffled.faces.push_back(first.faces[f]);
  auto again = crossings(shuffled, second);
  for (Crossing& c : again) c.first = order[c.first];
  std::sort(again.begin(), again.end(), [](const Crossing& a, const Crossing& b) {
    return std::pair(a.first, a.second) < std::pair(b.first, b.second);
  });
  ASSERT_EQ(again.size(), found.size());
  for (size_t k = 0; k < found.size(); ++k) {
    EXPECT_EQ(again[k].first, found[k].first);
    EXPECT_EQ(again[k].second, found[k].second);
    EXPECT_EQ(again[k].depth, found[k].depth);
    EXPECT_EQ(again[k].apart, found[k].apart);
  }
}

// Shifts that lose no digit of the coordinates change nothing; far away depths keep theirs.
TEST(Crossings, DoNotDependOnThePlaceOfTheModel) {
  const Eigen::RowVector3d far(4194304.0, -2097152.0, 1048576.0);
  Shape poke = spike(0.125), floor = floor_triangle(), touching = spike(0.0);
  poke.positions.rowwise() += far;
  floor.positions.rowwise() += far;
  touching.positions.rowwise() += far;
  const auto found = crossings(poke, floor);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].depth, 0.125);
  EXPECT_TRUE(crossings(touching, floor).empty());
}

TEST(Crossings, OfModelsOfAnySize) {
  for (const double scale : {1e-60, 1e-6, 1e6, 1e60}) {
    Shape poke = spike(0.1), floor = floor_triangle();
    poke.positions *= scale;
    floor.positions *= scale;
    const auto found = crossings(poke, floor);
    ASSERT_EQ(found.size(), 1u) << scale;
    EXPECT_NEAR(found[0].depth / scale, 0.1, 1e-14);
  }
}

// A panel like the letter U: what stands in its notch does not cross it, what stands in an arm does.
TEST(Crossings, RespectTheNotchOfAPanelThatIsNotConvex) {
  const Shape letter{
      make_points({{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}}),
      {{0, 1, 2, 3, 4, 5, 6, 7}}};
  const auto at = [&](double x, double y) {
    Shape shape = spike(0.25);
    shape.positions.col(0) *= 0.1;
    shape.positions.rowwise() += Eigen::RowVector3d(x, y, 0);
    return crossings(letter, shape);
  };
  EXPECT_TRUE(at(1.5, 2).empty());
  for (const auto& [x, y] : {std::pair(0.6, 2.2), std::pair(2.6, 2.2), std::pair(1.6, 0.6)}) {
    const auto found = at(x, y);
    ASSERT_EQ(found.size(), 1u) << x;
    EXPECT_GT(found[0].depth, 0.1);
  }
}

// The deepest of several pairs of triangles counts.
TEST(Crossings, GiveOneEntryAPairOfPolygonsWithItsDeepestTriangles) {
  // A comb of two teeth, one 0.1 deep, the other 0.3.
  const Shape comb{
      make_points({{-1, 0, 1}, {-1, 0, -0.1}, {-0.5, 0, 0.5}, {0.5, 0, 0.5}, {1, 0, -0.3}, {1, 0, 1}}),
      {{0, 1, 2, 3, 4, 5}}};
  const auto found = crossings(comb, floor_triangle());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].depth, 0.3, 1e-15);
  EXPECT_TRUE(std::find(found[0].first_corners.begin(), found[0].first_corners.end(), 4) !=
              found[0].first_corners.end());
}

// A panel that has shrunk to a line still pierces.
TEST(Crossings, SeePanelsWithoutArea) {
  const Shape needle{make_points({{0, 0, 1}, {0, 0, -0.2}, {0, 0, 0.3}}), {{0, 1, 2}}};
  const auto found = crossings(needle, floor_triangle());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].depth, 0.2, 1e-15);
  const Shape above{make_points({{0, 0, 1}, {0, 0, 0}, {0, 0, 0.3}}), {{0, 1, 2}}};
  EXPECT_TRUE(crossings(above, floor_triangle()).empty());
  const Shape point{make_points({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}), {{0, 1, 2}}};
  EXPECT_TRUE(crossings(point, floor_triangle()).empty());
  EXPECT_TRUE(crossings(point, point).empty());
  EXPECT_TRUE(crossings(needle, needle).empty());
}

TEST(Crossings, LeaveOutWhatIsNotFinite) {
  Shape shape = soup(40, 13);
  const auto before = pairs_of(within(shape));
  ASSERT_FALSE(before.empty());
  const int spoilt = before.begin()->second;
  PairSet expected;
  for (const auto& pair : before)
    if (pair.first != spoilt && pair.second != spoilt) expected.insert(pair);
  shape.positions(3 * spoilt + 1, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(pairs_of(within(shape)), expected);
  shape.positions(3 * spoilt + 1, 2) = std::numeric_limits<double>::infinity();
  EXPECT_EQ(pairs_of(within(shape)), expected);
}

TEST(Crossings, OfNothingAreNone) {
  const Shape nothing{Points(0, 3), {}};
  EXPECT_TRUE(crossings(nothing, floor_triangle()).empty());
  EXPECT_TRUE(crossings(floor_triangle(), nothing).empty());
  EXPECT_TRUE(within(nothing).empty());
  EXPECT_TRUE(within(floor_triangle()).empty());
}

// --- Panels against the mesh they are made of -------------------------------------------------------------

struct DomePanels {
  SharedComplex complex = [] {
    const PolygonMesh dome = make_sample("dome", 200).value();
    const double edge = dual_of(dome)->mean_edge;
    return dual_of(dome, {0.3 * edge, BorderPolicy::Closed});
  }();
  Shape panels{explicit_intersection(*complex).state.x, complex->panels};
  Shape mesh{complex->input.vertices, complex->input.faces};
};

TEST(Crossings, PanelsOverADomeCrossNothing) {
  const DomePanels dome;
  EXPECT_TRUE(crossings(dome.panels, dome.mesh, 1e-4 * dome.complex->mean_edge).empty());
  EXPECT_TRUE(within(dome.panels, 1e-4 * dome.complex->mean_edge).empty());
  // The same panels put below do.
  Shape lower = dome.panels;
  lower.positions.col(2).array() -= 0.35 * dome.complex->mean_edge;
  EXPECT_GT(crossings(lower, dome.mesh).size(), 20u);
}

TEST(Crossings, ACornerPushedThroughTheMeshIsFound) {
  DomePanels dome;
  const TangentComplex& complex = *dome.complex;
  const Polygons neighbours = complex.fairing_neighbours();
  int pushed = -1;
  for (int j = 0; pushed < 0; ++j)
    if (complex.point_origin[j].kind == PointKind::Face && complex.planes_of_point.valence(j) == 3) {
      bool inner = true;
      for (int k : neighbours[j]) inner = inner && complex.point_origin[k].kind == PointKind::Face;
      if (inner) pushed = j;
    }
  const int face = complex.face_of_point[pushed], panel = complex.planes_of_point[pushed][1];
  const Vector3d normal = complex.input.face_normals.row(face);
  // A corner of this panel's own, below the middle of the face.
  const Eigen::Index corner = dome.panels.positions.rows();
  dome.panels.positions.conservativeResize(corner + 1, 3);
  dome.panels.positions.row(corner) =
      (centroid(dome.mesh.positions, dome.mesh.faces[face]) - 0.05 * complex.mean_edge * normal).transpose();
  for (int& j : dome.panels.faces[panel])
    if (j == pushed) j = static_cast<int>(corner);
  const auto found = crossings(dome.panels, dome.mesh, 1e-4 * complex.mean_edge);
  ASSERT_EQ(pairs_of(found), (PairSet{{panel, face}}));
  EXPECT_NEAR(found[0].depth, 0.05 * complex.mean_edge, 1e-12);
  EXPECT_GT(found[0].apart.dot(normal), 1.0 - 1e-12);
  EXPECT_EQ(
      std::count(found[0].first_corners.begin(), found[0].first_corners.end(), static_cast<int>(corner)), 1);
}

// --- Within one surface -----------------------------------------------------------------------------------

TEST(CrossingsWithin, OfRandomTrianglesAreThoseOfBruteForce) {
  const Shape shape = soup(150, 11, 0.5);
  PairSet expected;
  for (int s = 0; s < 150; ++s)
    for (int t = s + 1; t < 150; ++t)
      if (brute_force(corners(shape, shape.faces[s]), corners(shape, shape.faces[t]))) expected.emplace(s, t);
  EXPECT_GT(expected.size(), 20u);
  EXPECT_EQ(pairs_of(within(shape)), expected);
}

// Random triangles of which every two share points: three that are close in the list have one in common.
TEST(CrossingsWithin, OfTrianglesThatShareACornerAreThoseOfBruteForce) {
  Shape shape = soup(60, 12);
  Shape shared{shape.positions, {}};
  for (int t = 0; t < 60; ++t) shared.faces.push_back(std::array{0, 3 * t + 1, 3 * t + 2});
  PairSet expected;
  for (int s = 0; s < 60; ++s)
    for (int t = s + 1; t < 60; ++t) {
      const Corners a = corners(shared, shared.faces[s]), b = corners(shared, shared.faces[t]);
      if (goes_through(a[1], a[2], b) || goes_through(b[1], b[2], a)) expected.emplace(s, t);
    }
  EXPECT_GT(expected.size(), 20u);
  EXPECT_LT(expected.size(), 1000u);
  EXPECT_EQ(pairs_of(within(shared)), expected);
}

TEST(CrossingsWithin, AMeshThatIsFineCrossesNowhere) {
  for (const Shape& shape : {cube(), octahedron(), icosahedron(), tetrahedron(), triangle_grid(4, 3),
                             grid(4, 3), domed_triangle_grid(6, 6), fan(7)}) {
    EXPECT_TRUE(within(shape).empty());
    EXPECT_TRUE(within(shape, 1e-4).empty());
    Shape turned = shape;
    turned.positions *= Eigen::AngleAxisd(0.7, Vector3d(3, -2, 1).normalized()).toRotationMatrix();
    turned.positions.rowwise() += Eigen::RowVector3d(1e3, -3e2, 1e2);
    EXPECT_TRUE(within(turned, 1e-9).empty());
  }
}

// Two triangles over one edge, the second turned about it by an angle: 180 degrees is flat, 0 on one another.
Shape hinge(double angle) {
  return {
      make_points({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 0.5 * std::cos(angle), 0.5 * std::sin(angle)}}),
      {{0, 1, 2}, {1, 0, 3}}};
}

TEST(CrossingsWithin, AnEdgeInCommonIsNoneUnlessFoldedOntoItself) {
  for (const double angle : {0.01, 1.0, 2.0, std::numbers::pi, 4.0, 6.0})
    EXPECT_TRUE(within(hinge(angle), 1e-6).empty()) << angle;
  const auto found = within(hinge(0.0));
  ASSERT_EQ(found.size(), 1u);
  // In the plane, the smaller triangle has to leave by an edge of the other: 0.5 along y, or less across a
  // side.
  EXPECT_GT(found[0].depth, 0.3);
  EXPECT_LE(found[0].depth, 0.5);
  EXPECT_NEAR(found[0].apart.z(), 0.0, 1e-15);
  // Within the margin they lie on one another as well.
  EXPECT_EQ(within(hinge(1e-7), 1e-6).size(), 1u);
  EXPECT_EQ(within(hinge(-1e-7), 1e-6).size(), 1u);
}

TEST(CrossingsWithin, ACornerInCommonIsNoneUnlessMoreIs) {
  // The second triangle hangs at point 0 of the first; its other corners lie on both sides, over the first or
  // beside it.
  const auto at = [](double x) {
    return Shape{make_points({{0, 0, 0}, {2, -2, 0}, {2, 2, 0}, {x, 0, 0.5}, {x, 0.2, -0.5}}),
                 {{0, 1, 2}, {0, 3, 4}}};
  };
  const auto found = within(at(1));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_GT(found[0].depth, 0.1);
  EXPECT_TRUE(within(at(-1)).empty());
  // Through the far edge of the first instead of inside it.
  EXPECT_EQ(within(at(4)).size(), 1u);
  // On it: a corner in the face, or an edge.
  const Shape touching{make_points({{0, 0, 0}, {2, -2, 0}, {2, 2, 0}, {1, 0, 0.5}, {1, 0.2, 0}}),
                       {{0, 1, 2}, {0, 3, 4}}};
  EXPECT_TRUE(within(touching).empty());
}

TEST(CrossingsWithin, PanelsInOnePlaneMayNotOverlap) {
  // Two unit squares in a plane, the second shifted so that a strip of 0.25 is covered twice.
  const auto shifted = [](double by) {
    Shape shape{make_points({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), {{0, 1, 2, 3}, {4, 5, 6, 7}}};
    const Points square = shape.positions;
    shape.positions.conservativeResize(8, 3);
    shape.positions.bottomRows(4) = square.rowwise() + Eigen::RowVector3d(by, 0, 0);
    return shape;
  };
  const auto found = within(shifted(0.75));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].depth, 0.25, 1e-12);
  EXPECT_NEAR((found[0].apart + Vector3d::UnitX()).norm(), 0.0, 1e-12);
  EXPECT_TRUE(within(shifted(1.0)).empty());
  EXPECT_TRUE(within(shifted(0.75), 0.26).empty());
  EXPECT_EQ(within(shifted(0.0)).size(), 1u);  // one on the other
  // The same panel twice.
  EXPECT_EQ(within({grid(1, 1).positions, {{0, 1, 3, 2}, {0, 1, 3, 2}}}).size(), 1u);
}

TEST(CrossingsWithin, APolygonDoesNotCrossItself) {
  // A quad like a bow tie, not even planar.
  const Shape bow{make_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0.2}, {1, 1, 0}}), {{0, 1, 2, 3}}};
  EXPECT_TRUE(within(bow).empty());
}

}  // namespace
}  // namespace planewright
