#include "core/certify/solid_shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace planewright {
namespace {

using Edge = std::pair<int, int>;

// The directed edges of the faces, sorted.
std::vector<Edge> directed_edges(const Polygons& faces, std::span<const int> chosen,
                                 const std::vector<int>& weld) {
  std::vector<Edge> edges;
  std::vector<int> corners;
  for (const int f : chosen) {
    corners.clear();
    for (const int c : faces[f])
      if (const int w = weld[static_cast<size_t>(c)]; corners.empty() || corners.back() != w)
        corners.push_back(w);
    if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    if (corners.size() < 3) continue;
    for (size_t k = 0; k < corners.size(); ++k)
      edges.emplace_back(corners[k], corners[(k + 1) % corners.size()]);
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

bool equals_its_reverse(const std::vector<Edge>& edges) {
  std::vector<Edge> reverse = edges;
  for (Edge& e : reverse) std::swap(e.first, e.second);
  std::sort(reverse.begin(), reverse.end());
  return edges == reverse;
}

}  // namespace

std::vector<std::array<int, 3>> fans(const Polygons& faces, std::span<const int> chosen) {
  std::vector<std::array<int, 3>> triangles;
  for (const int f : chosen)
    for (int k = 1; k + 1 < faces.valence(f); ++k)
      triangles.push_back(
          {faces[f][0], faces[f][static_cast<size_t>(k)], faces[f][static_cast<size_t>(k) + 1]});
  return triangles;
}

std::vector<int> welded(const Points& points) {
  std::vector<int> order(static_cast<size_t>(points.rows())), weld(order.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int i) {
    return std::tuple(points(i, 0) + 0.0, points(i, 1) + 0.0, points(i, 2) + 0.0);
  };
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return std::tuple(key(a), a) < std::tuple(key(b), b); });
  for (size_t i = 0; i < order.size(); ++i)
    weld[static_cast<size_t>(order[i])] =
        i > 0 && key(order[i - 1]) == key(order[i]) ? weld[static_cast<size_t>(order[i - 1])] : order[i];
  return weld;
}

bool is_closed(const Polygons& faces, std::span<const int> chosen, const std::vector<int>& weld) {
  const std::vector<Edge> edges = directed_edges(faces, chosen, weld);
  return !edges.empty() && std::adjacent_find(edges.begin(), edges.end()) == edges.end() &&
         equals_its_reverse(edges);
}

bool is_balanced(const Polygons& faces, std::span<const int> chosen, const std::vector<int>& weld) {
  const std::vector<Edge> edges = directed_edges(faces, chosen, weld);
  return !edges.empty() && equals_its_reverse(edges);
}

SolidMeasure measure(const Points& points, const std::vector<std::array<int, 3>>& triangles) {
  SolidMeasure sum;
  if (triangles.empty()) return sum;
  const Vector3d origin = points.row(triangles[0][0]);
  for (const auto& t : triangles) {
    const Vector3d a = points.row(t[0]).transpose() - origin, b = points.row(t[1]).transpose() - origin,
                   c = points.row(t[2]).transpose() - origin;
    sum.volume += a.dot(b.cross(c)) / 6.0;
    sum.surface += (b - a).cross(c - a).norm() / 2.0;
  }
  return sum;
}

Points points_of(const Points& points, const Polygons& faces, std::span<const int> chosen) {
  std::set<int> used;
  for (const int f : chosen) used.insert(faces[f].begin(), faces[f].end());
  Points picked(static_cast<Eigen::Index>(used.size()), 3);
  Eigen::Index row = 0;
  for (const int i : used) picked.row(row++) = points.row(i);
  return picked;
}

std::vector<int> all_of(const Polygons& faces) {
  std::vector<int> all(static_cast<size_t>(faces.size()));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

}  // namespace planewright
