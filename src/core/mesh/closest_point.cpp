#include "core/mesh/closest_point.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <unsupported/Eigen/BVH>
#include <vector>

#include "core/mesh/point_index.h"
#include "core/mesh/triangulate.h"

namespace planewright {
namespace {

using Box = Eigen::AlignedBox3d;
using Corners = std::array<Vector3d, 3>;

// Below this share of its longest edge's square, a triangle's area vector has no direction of its own.
constexpr double kNoDirection = 1e-10;

// What is closer to the end of an edge, or to an edge, than this share counts as on it: a point right above a
// corner must not be told by rounding whether it is one.
constexpr double kOnBoundary = 1e-12;

// Where on a triangle a point lies: kCorner + k, kEdge + k (from corner k to the next), or kInside.
constexpr int kCorner = 0, kEdge = 3, kInside = 6;

struct OnTriangle {
  Vector3d point;
  double squared_distance;
  int where;
};

// The point of a triangle closest to p: the best of its three edges, and of the foot of the perpendicular if
// that lies inside. The edges are exact for any sliver, whose normal may be mostly rounding; the foot is
// taken as a mean of the corners, so that it lies on the triangle, and only if it is not worse.
OnTriangle closest_on(const Corners& corner, const Vector3d& p) {
  OnTriangle best{corner[0], std::numeric_limits<double>::infinity(), kCorner};
  const Vector3d normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  std::array<double, 3> inside;  // for each edge, how far p lies on the triangle's side of it
  for (int k = 0; k < 3; ++k) {
    const Vector3d& a = corner[static_cast<size_t>(k)];
    const Vector3d& b = corner[static_cast<size_t>((k + 1) % 3)];
    const Vector3d edge = b - a, arm = p - a;
    inside[static_cast<size_t>(k)] = normal.cross(edge).dot(arm);
    const double t = edge.dot(arm), all = edge.squaredNorm();
    OnTriangle found{a, 0.0, kCorner + k};
    if (t >= (1.0 - kOnBoundary) * all) {
      found.point = b;
      found.where = kCorner + (k + 1) % 3;
    } else if (t > kOnBoundary * all) {
      found.point = a + t / all * edge;
      found.where = kEdge + k;
    }
    found.squared_distance = (p - found.point).squaredNorm();
    if (found.squared_distance < best.squared_distance) best = found;
  }
  const double all = inside[0] + inside[1] + inside[2];
  if (std::min({inside[0], inside[1], inside[2]}) > kOnBoundary * std::abs(all)) {
    // Each corner weighs by the side of the edge opposite to it.
    const Vector3d foot =
        corner[0] + inside[2] / all * (corner[1] - corner[0]) + inside[0] / all * (corner[2] - corner[0]);
    const double squared_distance = (p - foot).squaredNorm();
    if (squared_distance <= best.squared_distance) best = {foot, squared_distance, kInside};
  }
  return best;
}

using Tree = Eigen::KdBVH<double, 3, int>;

struct NearestTriangle {
  int triangle = -1;
  OnTriangle on{Vector3d::Zero(), std::numeric_limits<double>::infinity(), kInside};
};

// Depth first, the nearer child first: several times as fast as Eigen's BVMinimize, which goes on to open
// what it has queued when something nearer was found.
NearestTriangle nearest_triangle(const Tree& tree, const std::vector<Corners>& triangles,
                                 const Vector3d& query) {
  NearestTriangle best;
  // A little less than the distance, so that boxes as far away as the best triangle are opened too and a tie
  // does not depend on the order of the tree.
  const auto away = [&](int node) {
    return tree.getVolume(node).squaredExteriorDistance(query) * (1.0 - 1e-14);
  };
  std::array<std::pair<double, int>, 64> open;  // the tree is balanced: its depth is at most 31
  size_t count = 0;
  open[count++] = {0.0, tree.getRootIndex()};
  while (count > 0) {
    const auto [distance, node] = open[--count];
    if (distance > best.on.squared_distance) continue;
    Tree::VolumeIterator child = nullptr, last_child = nullptr;
    Tree::ObjectIterator object = nullptr, last_object = nullptr;
    tree.getChildren(node, child, last_child, object, last_object);
    for (; object != last_object; ++object) {
      const OnTriangle on = closest_on(triangles[static_cast<size_t>(*object)], query);
      const bool tie = on.squared_distance == best.on.squared_distance && *object < best.triangle;
      if (best.triangle < 0 || on.squared_distance < best.on.squared_distance || tie) best = {*object, on};
    }
    const size_t first = count;
    for (; child != last_child; ++child) open[count++] = {away(*child), *child};
    if (count - first == 2 && open[first].first < open[first + 1].first)
      std::swap(open[first], open[first + 1]);
  }
  return best;
}

double angle_between(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

}  // namespace

struct ReferenceSurface::Impl {
  Vector3d origin = Vector3d::Zero();  // model coordinates of the local 0
  Box bounds;                          // local
  double size = 0.0;                   // diagonal of the bounds

  std::vector<Corners> triangles;  // local coordinates
  std::vector<int> face;           // of the polygons given, per triangle
  Tree tree;

  // Which way is out at triangles (unit), edges and corners (any length), and what lies on the border.
  std::vector<Vector3d> normals, edge_normals, corner_normals;
  std::vector<std::array<int, 3>> edges_of, corners_of;  // per triangle
  std::vector<char> edge_on_border, corner_on_border;
  std::vector<char> sliver;  // per triangle: without a normal of its own

  void add_triangles(const Points& points, const Polygons& faces);
  bool find_normals();  // false: no triangle has area
  void find_edges();
  void stand_in_for_slivers();
  void find_pseudonormals();

  Vector3d outward(int triangle, int where) const;  // unit
  bool on_border(int triangle, int where) const;
};

void ReferenceSurface::Impl::add_triangles(const Points& points, const Polygons& faces) {
  const Points local = points.rowwise() - origin.transpose();
  PointIndex vertices;
  std::vector<Box> boxes;
  std::vector<int> indices;
  for (int f = 0; f < faces.size(); ++f)
    for (const auto& picked : triangulate(local, faces[f])) {
      Corners c;
      std::array<int, 3> ids;
      for (size_t k = 0; k < 3; ++k) {
        c[k] = local.row(picked[k]);
        ids[k] = vertices.insert(c[k].x(), c[k].y(), c[k].z());
      }
      // A triangle shrunk to a segment or a point: its neighbours have all of it, and meet there.
      if (ids[0] == ids[1] || ids[1] == ids[2] || ids[2] == ids[0]) continue;
      Box box(c[0]);
      box.extend(c[1]).extend(c[2]);
      boxes.push_back(box);
      bounds.extend(box);
      indices.push_back(static_cast<int>(triangles.size()));
      triangles.push_back(c);
      face.push_back(f);
      corners_of.push_back(ids);
    }
  corner_normals.assign(vertices.points().size(), Vector3d::Zero());
  if (!triangles.empty()) tree.init(indices.begin(), indices.end(), boxes.begin(), boxes.end());
}

bool ReferenceSurface::Impl::find_normals() {
  bool any = false;
  for (const Corners& c : triangles) {
    const Vector3d area = (c[1] - c[0]).cross(c[2] - c[0]);
    const double longest =
        std::max({(c[1] - c[0]).squaredNorm(), (c[2] - c[1]).squaredNorm(), (c[0] - c[2]).squaredNorm()});
    const bool thin = !(area.stableNorm() > kNoDirection * longest);
    normals.push_back(thin ? Vector3d(Vector3d::Zero()) : Vector3d(area.stableNormalized()));
    any = any || !thin;
  }
  return any;
}

void ReferenceSurface::Impl::find_edges() {
  struct Side {
    int low, high, triangle, edge;
  };
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (size_t t = 0; t < triangles.size(); ++t)
    for (size_t k = 0; k < 3; ++k) {
      const int a = corners_of[t][k], b = corners_of[t][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), static_cast<int>(t), static_cast<int>(k)});
    }
  std::stable_sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) {
    return std::pair(s.low, s.high) < std::pair(t.low, t.high);
  });
  edges_of.resize(triangles.size());
  corner_on_border.assign(corner_normals.size(), 0);
  for (size_t first = 0, end = 0; first < sides.size(); first = end) {
    const int edge = static_cast<int>(edge_on_border.size());
    for (end = first;
         end < sides.size() && sides[end].low == sides[first].low && sides[end].high == sides[first].high;
         ++end)
      edges_of[static_cast<size_t>(sides[end].triangle)][static_cast<size_t>(sides[end].edge)] = edge;
    const bool border = end - first == 1;
    edge_on_border.push_back(border);
    if (!border) continue;
    corner_on_border[static_cast<size_t>(sides[first].low)] = 1;
    corner_on_border[static_cast<size_t>(sides[first].high)] = 1;
  }
}

// A sliver's own normal is mostly rounding. It takes the bisector of the normals on both of its long sides,
// as if it had no width.
void ReferenceSurface::Impl::stand_in_for_slivers() {
  std::vector<Vector3d> across(edge_on_border.size(), Vector3d::Zero());
  for (size_t t = 0; t < triangles.size(); ++t) {
    sliver.push_back(normals[t].isZero(0.0));
    for (int edge : edges_of[t]) across[static_cast<size_t>(edge)] += normals[t];
  }
  for (size_t t = 0; t < triangles.size(); ++t) {
    if (!sliver[t]) continue;
    std::array<std::pair<double, Vector3d>, 3> sides;  // length and the normal across
    for (size_t k = 0; k < 3; ++k)
      sides[k] = {(triangles[t][(k + 1) % 3] - triangles[t][k]).stableNorm(),
                  across[static_cast<size_t>(edges_of[t][k])]};
    const auto longest = std::max_element(sides.begin(), sides.end(),
                                          [](const auto& a, const auto& b) { return a.first < b.first; });
    std::swap(*longest, sides[0]);
    const Vector3d others =
        (sides[1].first * sides[1].second + sides[2].first * sides[2].second) / sides[0].first;
    // Stays 0 where all neighbours are slivers.
    normals[t] = (sides[0].second.normalized() + others.normalized()).normalized();
  }
}

void ReferenceSurface::Impl::find_pseudonormals() {
  edge_normals.assign(edge_on_border.size(), Vector3d::Zero());
  std::vector<char> at_sliver(edge_on_border.size(), 0);
  for (size_t t = 0; t < triangles.size(); ++t) {
    if (!sliver[t]) continue;
    for (int edge : edges_of[t]) at_sliver[static_cast<size_t>(edge)] = 1;
  }
  for (size_t t = 0; t < triangles.size(); ++t)
    for (size_t k = 0; k < 3; ++k) {
      const Vector3d &here = triangles[t][k], &next = triangles[t][(k + 1) % 3],
                     &before = triangles[t][(k + 2) % 3];
      const auto edge = static_cast<size_t>(edges_of[t][k]);
      // A sliver's bisector counts for both sides already.
      if (sliver[t] || !at_sliver[edge]) edge_normals[edge] += normals[t];
      corner_normals[static_cast<size_t>(corners_of[t][k])] +=
          angle_between(next - here, before - here) * normals[t];
    }
}

Vector3d ReferenceSurface::Impl::outward(int triangle, int where) const {
  const auto t = static_cast<size_t>(triangle);
  Vector3d sum = Vector3d::Zero();
  if (where < kEdge)
    sum = corner_normals[static_cast<size_t>(corners_of[t][static_cast<size_t>(where - kCorner)])];
  else if (where < kInside)
    sum = edge_normals[static_cast<size_t>(edges_of[t][static_cast<size_t>(where - kEdge)])];
  if (sum.norm() > kNoDirection) return sum.normalized();
  // Inside, or where two sheets lie back to back; among slivers alone any direction is as good.
  return normals[t].isZero(0.0) ? Vector3d(Vector3d::UnitZ()) : normals[t];
}

bool ReferenceSurface::Impl::on_border(int triangle, int where) const {
  const auto t = static_cast<size_t>(triangle);
  if (where < kEdge)
    return corner_on_border[static_cast<size_t>(corners_of[t][static_cast<size_t>(where - kCorner)])] != 0;
  if (where < kInside)
    return edge_on_border[static_cast<size_t>(edges_of[t][static_cast<size_t>(where - kEdge)])] != 0;
  return false;
}

ReferenceSurface::ReferenceSurface(std::unique_ptr<Impl> impl, std::string name)
    : impl_(std::move(impl)), name_(std::move(name)) {}
ReferenceSurface::~ReferenceSurface() = default;

Result<std::shared_ptr<const ReferenceSurface>> ReferenceSurface::create(const Points& points,
                                                                         const Polygons& faces,
                                                                         std::string name) {
  if (faces.empty())
    return fail(ErrorCode::Refused, "the reference has no faces", name, "Give a mesh with at least one face");
  Box bounds;
  for (int v : faces.indices()) {
    const Vector3d corner = points.row(v);
    if (!(corner.cwiseAbs().maxCoeff() <= kLargestCoordinate) || !corner.allFinite())
      return fail(ErrorCode::Refused,
                  "a coordinate of the reference is not a finite number, or far too large", name,
                  "Export it again");
    bounds.extend(corner);
  }
  auto impl = std::make_unique<Impl>();
  if (!bounds.isEmpty()) impl->origin = bounds.min() + 0.5 * (bounds.max() - bounds.min());
  impl->add_triangles(points, faces);
  if (!impl->find_normals())
    return fail(ErrorCode::Refused, "the reference has no face with area", name,
                "Give a mesh with faces that are no points or lines");
  impl->size = impl->bounds.sizes().stableNorm();
  impl->find_edges();
  impl->stand_in_for_slivers();
  impl->find_pseudonormals();
  return std::shared_ptr<const ReferenceSurface>(new ReferenceSurface(std::move(impl), std::move(name)));
}

ClosestPoint ReferenceSurface::closest(const Vector3d& query, const Vector3d& origin) const {
  const Vector3d shift = origin - impl_->origin;
  const Vector3d local = query + shift;
  const auto [t, found] = nearest_triangle(impl_->tree, impl_->triangles, local);
  ClosestPoint answer{found.point - shift, impl_->outward(t, found.where), 0.0,
                      impl_->face[static_cast<size_t>(t)], impl_->on_border(t, found.where)};
  const Vector3d arm = local - found.point;
  const double distance = arm.stableNorm();
  answer.distance = answer.normal.dot(arm) < 0.0 ? -distance : distance;
  // Over an edge or a corner the distance grows along the arm. A very short arm has lost its direction.
  const bool over_ridge = found.where != kInside && !answer.border;
  if (over_ridge && distance > 1e-9 * impl_->size) answer.normal = arm / answer.distance;
  return answer;
}

Vector3d ReferenceSurface::low() const {
  return impl_->bounds.min() + impl_->origin;
}
Vector3d ReferenceSurface::high() const {
  return impl_->bounds.max() + impl_->origin;
}

Result<void> check_reference(const ReferenceSurface& reference, const Vector3d& low, const Vector3d& high) {
  constexpr double kMostSizeRatio = 100.0, kMostSizesBetween = 10.0;
  const double size = (reference.high() - reference.low()).stableNorm(),
               mesh_size = (high - low).stableNorm();
  std::string sizes = "the reference's bounding box measures ";
  sizes += number(size) + ", the mesh's " + number(mesh_size);
  if (std::max(size, mesh_size) > kMostSizeRatio * std::min(size, mesh_size))
    return fail(ErrorCode::Refused, sizes + ": one is more than 100 times as large", reference.name(),
                "Are both in the same units, and is this the right file?");
  const Vector3d gap = (reference.low() - high).cwiseMax(low - reference.high()).cwiseMax(Vector3d::Zero());
  if (gap.stableNorm() > kMostSizesBetween * std::max(size, mesh_size))
    return fail(ErrorCode::Refused,
                "the reference is " + number(gap.stableNorm()) + " away from the mesh; " + sizes,
                reference.name(), "Are both in the same place and units, and is this the right file?");
  return {};
}

}  // namespace planewright
