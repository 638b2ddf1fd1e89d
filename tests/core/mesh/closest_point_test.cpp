// Which point of a surface is closest, and on which side of it the query lies.
#include "core/mesh/closest_point.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>
#include <random>

#include "core/mesh/sample_shapes.h"
#include "core/mesh/triangulate.h"
#include "support/shapes.h"

namespace planewright {
namespace {

using namespace test;
using SharedSurface = std::shared_ptr<const ReferenceSurface>;

SharedSurface surface_of(const Shape& shape) {
  return ReferenceSurface::create(shape.positions, shape.faces, "shape").value();
}
ClosestPoint closest(const Shape& shape, const Vector3d& query) {
  return surface_of(shape)->closest(query, Vector3d::Zero());
}

class Random {
 public:
  explicit Random(unsigned seed) : random_(seed) {}
  double next() { return 2.0 * (static_cast<double>(random_()) / 4294967295.0) - 1.0; }
  Vector3d in_box(double size) {
    const double x = next(), y = next(), z = next();
    return size * Vector3d(x, y, z);
  }

 private:
  std::mt19937 random_;
};

double distance_to_segment(const Vector3d& a, const Vector3d& b, const Vector3d& p) {
  const double all = (b - a).squaredNorm();
  const double t = all > 0.0 ? std::clamp((p - a).dot(b - a) / all, 0.0, 1.0) : 0.0;
  return (p - a - t * (b - a)).norm();
}

// By another way than the code under test: the plane's distance if the perpendicular's foot has positive
// barycentric coordinates, else the nearest edge.
double distance_to_triangle(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& p) {
  Matrix3d frame;
  const Vector3d normal = (b - a).cross(c - a).normalized();
  frame << b - a, c - a, normal;
  const Vector3d k = frame.fullPivLu().solve(p - a);
  if (k[0] >= 0.0 && k[1] >= 0.0 && k[0] + k[1] <= 1.0) return std::abs(k[2]);
  return std::min({distance_to_segment(a, b, p), distance_to_segment(b, c, p), distance_to_segment(c, a, p)});
}

double distance_to_all(const Shape& shape, const Vector3d& p) {
  double least = std::numeric_limits<double>::infinity();
  for (int f = 0; f < shape.faces.size(); ++f)
    for (const auto& [i, j, k] : triangulate(shape.positions, shape.faces[f]))
      least = std::min(least, distance_to_triangle(shape.positions.row(i), shape.positions.row(j),
                                                   shape.positions.row(k), p));
  return least;
}

// The prism over an L: a reflex edge along x = y = 1, where two faces see each other.
Shape l_shape() {
  return {make_points({{0, 0, 0},
                       {2, 0, 0},
                       {2, 1, 0},
                       {1, 1, 0},
                       {1, 2, 0},
                       {0, 2, 0},
                       {0, 0, 1},
                       {2, 0, 1},
                       {2, 1, 1},
                       {1, 1, 1},
                       {1, 2, 1},
                       {0, 2, 1}}),
          {{5, 4, 3, 2, 1, 0},
           {6, 7, 8, 9, 10, 11},
           {0, 1, 7, 6},
           {1, 2, 8, 7},
           {2, 3, 9, 8},
           {3, 4, 10, 9},
           {4, 5, 11, 10},
           {5, 0, 6, 11}}};
}
bool inside_l(const Vector3d& p) {
  const bool in_square = p.x() > 0 && p.x() < 2 && p.y() > 0 && p.y() < 2;
  return in_square && p.z() > 0 && p.z() < 1 && (p.x() < 1 || p.y() < 1);
}

TEST(ClosestPoint, OverAFaceAnEdgeAndACorner) {
  const ClosestPoint face = closest(cube(), {0.25, 0.75, 1.5});
  EXPECT_NEAR((face.point - Vector3d(0.25, 0.75, 1)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((face.normal - Vector3d(0, 0, 1)).norm(), 0.0, 1e-15);
  EXPECT_DOUBLE_EQ(face.distance, 0.5);
  EXPECT_EQ(face.face, 1);
  EXPECT_FALSE(face.border);

  const ClosestPoint edge = closest(cube(), {1.3, 0.5, 1.4});
  EXPECT_NEAR((edge.point - Vector3d(1, 0.5, 1)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((edge.normal - Vector3d(0.6, 0, 0.8)).norm(), 0.0, 1e-15);
  EXPECT_DOUBLE_EQ(edge.distance, 0.5);

  const ClosestPoint corner = closest(cube(), {-1, -2, -2});
  EXPECT_EQ(corner.point, Vector3d(0, 0, 0));
  EXPECT_NEAR((corner.normal - Vector3d(-1, -2, -2) / 3).norm(), 0.0, 1e-15);
  EXPECT_DOUBLE_EQ(corner.distance, 3.0);

  const ClosestPoint inner = closest(cube(), {0.5, 0.4, 0.875});
  EXPECT_DOUBLE_EQ(inner.distance, -0.125);
  EXPECT_NEAR((inner.normal - Vector3d(0, 0, 1)).norm(), 0.0, 1e-15);
}

TEST(ClosestPoint, AgreesWithTryingEveryTriangle) {
  Random random(3);
  const auto dome = make_sample("dome", 40).value();
  const auto roof = make_sample("twisted-roof", 30).value();
  for (Shape shape : {cube(), l_shape(), octahedron(), fan(7, true), Shape{dome.positions(), dome.faces()},
                      Shape{roof.positions(), roof.faces()}}) {
    shape.positions /= bounding_diagonal(shape.positions);
    const SharedSurface surface = surface_of(shape);
    const Vector3d middle = shape.positions.colwise().mean();
    for (const double size : {0.5, 5.0, 1000.0})
      for (int k = 0; k < 100; ++k) {
        const Vector3d query = middle + random.in_box(size);
        const ClosestPoint found = surface->closest(query, Vector3d::Zero());
        EXPECT_NEAR(std::abs(found.distance), distance_to_all(shape, query), 1e-12 * size);
        EXPECT_NEAR((query - found.point).norm(), std::abs(found.distance), 1e-12 * size);
        EXPECT_NEAR(distance_to_all(shape, found.point), 0.0, 1e-12);
        EXPECT_NEAR(found.normal.norm(), 1.0, 1e-12);
        if (!found.border) {
          // What the closeness energy relies on.
          EXPECT_NEAR(found.normal.dot(query - found.point), found.distance, 1e-9 * size);
        }
      }
  }
}

TEST(ClosestPoint, TellsInsideFromOutsideRoundConvexAndReflexEdges) {
  const SharedSurface surface = surface_of(l_shape());
  Random random(5);
  int inside = 0;
  for (int k = 0; k < 3000; ++k) {
    const Vector3d query = Vector3d(1, 1, 0.5) + random.in_box(1.3);
    inside += inside_l(query);
    EXPECT_EQ(surface->closest(query, Vector3d::Zero()).distance < 0.0, inside_l(query)) << query;
  }
  EXPECT_GT(inside, 200);
  // In front of the reflex edge, on it, and behind it.
  EXPECT_GT(surface->closest({1.1, 1.1, 0.5}, Vector3d::Zero()).distance, 0.0);
  const ClosestPoint behind = surface->closest({0.9, 0.9, 0.5}, Vector3d::Zero());
  EXPECT_NEAR(behind.distance, -std::sqrt(0.02), 1e-15);
  EXPECT_NEAR((behind.normal - Vector3d(1, 1, 0).normalized()).norm(), 0.0, 1e-12);
}

// A spike's tip: the nearest point is the tip for most of the space about it, and the normals of half of its
// triangles look away from there.
TEST(ClosestPoint, TellsTheSideAtTheTipOfASpike) {
  const Shape spike{make_points({{0, 0, 10}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}),
                    {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {4, 3, 2, 1}}};
  const SharedSurface surface = surface_of(spike);
  Random random(7);
  int at_tip = 0, single_normals_wrong = 0;
  for (int k = 0; k < 500; ++k) {
    const Vector3d arm = random.in_box(1.0);
    if (arm.z() < 0.2) continue;
    const ClosestPoint found = surface->closest(Vector3d(0, 0, 10) + arm, Vector3d::Zero());
    if (found.point != Vector3d(0, 0, 10)) continue;
    ++at_tip;
    EXPECT_NEAR(found.distance, arm.norm(), 1e-12);
    EXPECT_NEAR((found.normal - arm.normalized()).norm(), 0.0, 1e-12);
    for (int f = 0; f < 4; ++f)
      single_normals_wrong += newell_vector(spike.positions, spike.faces[f]).dot(arm) < 0.0;
  }
  EXPECT_GT(at_tip, 100);
  EXPECT_GT(single_normals_wrong, 50);  // else the test shows nothing
}

// The same corner cut into many thin triangles on one of its faces: unweighted sums of normals lean there.
TEST(ClosestPoint, WeighsNormalsByTheirAngle) {
  Shape shape;
  shape.positions.resize(23, 3);
  shape.positions.row(0) << 0, 0, 0;  // the tip of an octant's outside
  shape.positions.row(1) << 1, 0, 0;
  shape.positions.row(2) << 0, 0, 1;
  // A fan of 20 triangles in the plane z = 0, from x to y, and two faces down to -z ... as one corner of a
  // box.
  for (int k = 0; k <= 19; ++k) {
    const double angle = 0.5 * std::numbers::pi * (k + 1) / 20.0;
    shape.positions.row(3 + k) << std::cos(angle), std::sin(angle), 0;
  }
  const int y = 22;
  shape.faces.push_back(std::array{0, 3, 1});  // seen from below: the box lies above z = 0
  for (int k = 3; k < y; ++k) shape.faces.push_back(std::array{0, k + 1, k});
  shape.faces.push_back(std::array{0, 1, 2});  // y = 0
  shape.faces.push_back(std::array{0, 2, y});  // x = 0
  const SharedSurface surface = surface_of(shape);
  Random random(11);
  int checked = 0;
  for (int k = 0; k < 400; ++k) {
    const Vector3d query = -0.3 * random.in_box(1.0).cwiseAbs();
    const ClosestPoint found = surface->closest(query, Vector3d::Zero());
    ASSERT_EQ(found.point, Vector3d(0, 0, 0));
    ++checked;
    EXPECT_GT(found.distance, 0.0);
  }
  EXPECT_EQ(checked, 400);
  const Vector3d along = surface->closest({0, 0, 0}, Vector3d::Zero()).normal;
  EXPECT_NEAR((along - Vector3d(-1, -1, -1).normalized()).norm(), 0.0, 1e-12);
}

TEST(ClosestPoint, OnTheSurfaceTheNormalIsTheSurfacesOwn) {
  for (const Vector3d& on : {Vector3d(0.3, 0.4, 1), Vector3d(1, 0.5, 1), Vector3d(1, 1, 1)}) {
    const ClosestPoint found = closest(cube(), on);
    EXPECT_NEAR(found.distance, 0.0, 1e-15);
    EXPECT_GT(found.normal.z(), 0.5);
    EXPECT_NEAR(found.normal.norm(), 1.0, 1e-12);
  }
  EXPECT_NEAR((closest(cube(), {1, 0.5, 1}).normal - Vector3d(1, 0, 1).normalized()).norm(), 0.0, 1e-12);
  EXPECT_NEAR((closest(cube(), {1, 1, 1}).normal - Vector3d(1, 1, 1).normalized()).norm(), 0.0, 1e-12);
}

// Beyond the border there is no side: the normal stays the surface's, wherever the query goes.
TEST(ClosestPoint, OpenSurfacesGoOnAsTheirTangentPlane) {
  const SharedSurface surface = surface_of(grid(2, 2));
  for (const double z : {-0.4, 0.0, 1e-9, 0.4}) {
    const ClosestPoint edge = surface->closest({2.5, 0.7, z}, Vector3d::Zero());
    EXPECT_TRUE(edge.border);
    EXPECT_NEAR((edge.point - Vector3d(2, 0.7, 0)).norm(), 0.0, 1e-15);
    EXPECT_NEAR((edge.normal - Vector3d(0, 0, 1)).norm(), 0.0, 1e-15);
    EXPECT_NEAR(std::abs(edge.distance), std::hypot(0.5, z), 1e-15);
    EXPECT_EQ(edge.distance < 0.0, z < 0.0);
    const ClosestPoint corner = surface->closest({-0.5, -0.5, z}, Vector3d::Zero());
    EXPECT_TRUE(corner.border);
    EXPECT_EQ(corner.point, Vector3d(0, 0, 0));
    EXPECT_NEAR((corner.normal - Vector3d(0, 0, 1)).norm(), 0.0, 1e-15);
  }
  const ClosestPoint inner = surface->closest({1, 1, 0.4}, Vector3d::Zero());
  EXPECT_FALSE(inner.border);
  EXPECT_DOUBLE_EQ(inner.distance, 0.4);
}

// Caps with next to no area, along an edge of a sheared cube: neither the place nor the side may suffer. The
// shear makes the edge sharp, so that the normal of one of its faces alone does not tell the side.
TEST(ClosestPoint, SliversOnAnEdgeChangeNothing) {
  for (const double shear : {0.0, 1.0})
    for (const double width : {1e-3, 1e-7, 1e-11, 1e-15, 1e-18, 0.0}) {
      Shape plain = cube();
      plain.positions.col(0) += shear * plain.positions.col(2);
      // The edge from 5 to 6 (x = 1, z = 1), split in its middle for the face x = 1 alone, a little below the
      // edge: a cap fills the gap.
      Shape shape = plain;
      shape.positions.conservativeResize(9, 3);
      shape.positions.row(8) << 1 + shear * (1 - width), 0.5, 1 - width;
      shape.faces = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 8, 5},
                     {5, 8, 6},    {2, 3, 7, 6}, {3, 0, 4, 7}};
      const SharedSurface surface = surface_of(shape);
      Random random(13);
      for (int k = 0; k < 300; ++k) {
        const Vector3d query = Vector3d(1 + shear, 0.5, 1) + random.in_box(0.4);
        const bool inside = query.x() - shear * query.z() < 1 && query.z() < 1;
        const ClosestPoint found = surface->closest(query, Vector3d::Zero());
        EXPECT_EQ(found.distance < 0.0, inside) << shear << " " << width;
        EXPECT_NEAR(std::abs(found.distance), distance_to_all(plain, query), 1e-14) << shear << " " << width;
        EXPECT_FALSE(found.border);
      }
    }
}

// A needle so thin that its normal is rounding, seen from far away, still has its closest point.
TEST(ClosestPoint, OfANeedleAlone) {
  for (const double width : {1e-2, 1e-6, 1e-9}) {
    const Shape needle{make_points({{0, 0, 0}, {1, 0.3, 0.1}, {1, 0.3 + width, 0.1}}), {{0, 1, 2}}};
    const SharedSurface surface = surface_of(needle);
    Random random(17);
    for (const double size : {1.0, 1e4})
      for (int k = 0; k < 200; ++k) {
        const Vector3d query = random.in_box(size);
        const ClosestPoint found = surface->closest(query, Vector3d::Zero());
        const double along = distance_to_segment(needle.positions.row(0), needle.positions.row(1), query);
        EXPECT_LE(std::abs(found.distance), along + 1e-13 * size);
        EXPECT_GE(std::abs(found.distance), along - 1.5 * width - 1e-13 * size);
        // On the needle, up to its width.
        EXPECT_LE(distance_to_segment(needle.positions.row(0), needle.positions.row(1), found.point),
                  1.5 * width + 1e-15);
      }
  }
}

TEST(ClosestPoint, OfSeveralTheFirstAlways) {
  // The middle of the cube is as far from all six faces; triangles of one face share its diagonal.
  const ClosestPoint middle = closest(cube(), {0.5, 0.5, 0.5});
  EXPECT_EQ(middle.face, 0);
  EXPECT_DOUBLE_EQ(middle.distance, -0.5);
  const SharedSurface many = surface_of(triangle_grid(20, 20));
  for (int y = 1; y < 20; ++y)
    for (int x = 1; x < 20; ++x) {
      const ClosestPoint found = many->closest(Vector3d(x, y, 0.25), Vector3d::Zero());
      EXPECT_EQ(found.face, 2 * ((y - 1) * 20 + x - 1));  // the first of the six triangles round the vertex
      EXPECT_DOUBLE_EQ(found.distance, 0.25);
    }
}

TEST(ClosestPoint, VerticesWithEqualCoordinatesAreOne) {
  const Shape shared = l_shape();
  Shape soup;
  soup.positions.resize(static_cast<Eigen::Index>(shared.faces.indices().size()), 3);
  int next = 0;
  for (int f = 0; f < shared.faces.size(); ++f) {
    std::vector<int> face;
    for (int v : shared.faces[f]) {
      soup.positions.row(next) = shared.positions.row(v);
      face.push_back(next++);
    }
    soup.faces.push_back(face);
  }
  const SharedSurface a = surface_of(shared), b = surface_of(soup);
  Random random(19);
  for (int k = 0; k < 300; ++k) {
    const Vector3d query = Vector3d(1, 1, 0.5) + random.in_box(1.5);
    const ClosestPoint p = a->closest(query, Vector3d::Zero()), q = b->closest(query, Vector3d::Zero());
    EXPECT_EQ(p.distance, q.distance);
    EXPECT_EQ(p.normal, q.normal);
    EXPECT_FALSE(q.border);
  }
}

TEST(ClosestPoint, FarFromTheOriginAndOfAnySize) {
  const SharedSurface near = surface_of(l_shape());
  const Vector3d away(4e6, -7e6, 1e6);
  for (const double scale : {1.0, 1e-3, 1e5}) {
    Shape far = l_shape();
    far.positions *= scale;
    far.positions.rowwise() += away.transpose();
    const SharedSurface surface = surface_of(far);
    EXPECT_NEAR((surface->low() - away).norm(), 0.0, 1e-8);
    EXPECT_NEAR((surface->high() - away - scale * Vector3d(2, 2, 1)).norm(), 0.0, 1e-8);
    Random random(23);
    for (int k = 0; k < 200; ++k) {
      const Vector3d query = Vector3d(1, 1, 0.5) + random.in_box(1.5);
      const ClosestPoint here = near->closest(query, Vector3d::Zero()),
                         there = surface->closest(scale * query, away);
      // The far corners themselves are rounded to 1e-9.
      EXPECT_NEAR(there.distance, scale * here.distance, 1e-8);
      EXPECT_NEAR((there.point - scale * here.point).norm(), 0.0, 1e-8);
    }
  }
}

TEST(ReferenceSurface, RefusesWhatHasNoSurface) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const auto none = ReferenceSurface::create(Points(0, 3), {}, "empty.obj");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::Refused);
  EXPECT_NE(none.error().text().find("empty.obj"), std::string::npos);
  EXPECT_NE(none.error().what.find("no faces"), std::string::npos);
  const auto flat = ReferenceSurface::create(make_points({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}),
                                             {{0, 1, 2}, {1, 2, 3, 0}, {1, 1, 2}}, "line.obj");
  ASSERT_FALSE(flat);
  EXPECT_NE(flat.error().text().find("line.obj"), std::string::npos);
  EXPECT_NE(flat.error().what.find("area"), std::string::npos);
  for (const double bad : {nan, inf, -inf, 1e200}) {
    Shape shape = cube();
    shape.positions(3, 1) = bad;
    const auto refused = ReferenceSurface::create(shape.positions, shape.faces, "bad.obj");
    ASSERT_FALSE(refused) << bad;
    EXPECT_NE(refused.error().text().find("bad.obj"), std::string::npos);
  }
  // One triangle is a surface; a vertex that no face has does no harm.
  EXPECT_TRUE(ReferenceSurface::create(make_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {nan, nan, nan}}),
                                       {{0, 1, 2}}, "one.obj"));
}

TEST(CheckReference, TakesWhatIsNearAndOfTheSameSize) {
  const SharedSurface surface = surface_of(cube());
  EXPECT_TRUE(check_reference(*surface, {0, 0, 0}, {1, 1, 1}));
  EXPECT_TRUE(check_reference(*surface, {0, 0, 0}, {50, 50, 50}));
  EXPECT_TRUE(check_reference(*surface, {0, 0, 0}, {0.02, 0.02, 0.02}));
  EXPECT_TRUE(check_reference(*surface, {9, 9, 9}, {10, 10, 10}));
}

TEST(CheckReference, NamesWhatIsFarAwayOrOfAnotherSize) {
  const SharedSurface surface = surface_of(cube());
  // Millimetres against metres.
  const auto large = check_reference(*surface, {0, 0, 0}, {3000, 4000, 0});
  ASSERT_FALSE(large);
  EXPECT_EQ(large.error().code, ErrorCode::Refused);
  EXPECT_EQ(large.error().where, "shape");
  EXPECT_NE(large.error().what.find("5000"), std::string::npos);
  EXPECT_NE(large.error().what.find("1.732"), std::string::npos);
  EXPECT_NE(large.error().remedy.find("units"), std::string::npos);
  EXPECT_NE(large.error().remedy.find("file"), std::string::npos);
  const auto small = check_reference(*surface, {0, 0, 0}, {0.003, 0.004, 0});
  ASSERT_FALSE(small);
  EXPECT_NE(small.error().what.find("0.005"), std::string::npos);
  for (const double sign : {-1.0, 1.0}) {
    const Vector3d low(0, sign * 1000.0, 0);
    const auto far = check_reference(*surface, low, low + Vector3d::Ones());
    ASSERT_FALSE(far);
    EXPECT_NE(far.error().what.find("999 away"), std::string::npos) << far.error().text();
    EXPECT_NE(far.error().what.find("1.732"), std::string::npos);
    EXPECT_NE(far.error().remedy.find("file"), std::string::npos);
  }
}

}  // namespace
}  // namespace planewright
