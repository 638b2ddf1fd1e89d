#include "core/cluster/surface_distance.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/mesh/closest_point.h"
#include "core/mesh/triangulate.h"

namespace planewright {
namespace {

double area_of(const Points& points, const std::array<int, 3>& t) {
  const Vector3d a = points.row(t[0]), b = points.row(t[1]), c = points.row(t[2]);
  return 0.5 * (b - a).cross(c - a).norm();
}

SurfaceDistance distance_to(const ReferenceSurface& surface, const Points& points, const Polygons& polygons,
                            int samples) {
  std::vector<std::array<int, 3>> triangles;
  double area = 0.0;
  for (int p = 0; p < polygons.size(); ++p)
    for (const auto& t : triangulate(points, polygons[p])) {
      triangles.push_back(t);
      area += area_of(points, t);
    }
  // Relative to a corner, so that a model far from 0 loses no digits.
  const Vector3d origin = points.row(polygons.indices().front());
  const auto distance = [&](const Vector3d& at) { return std::abs(surface.closest(at, origin).distance); };
  SurfaceDistance result;
  double sum = 0.0;
  for (const auto& t : triangles) {
    const double own = area_of(points, t);
    if (!(own > 0.0)) continue;
    // n x n triangles alike, a sample in the middle of each.
    const int n = std::max(1, static_cast<int>(std::ceil(std::sqrt(own * samples / area))));
    const Vector3d a = points.row(t[0]).transpose() - origin, b = points.row(t[1]).transpose() - origin,
                   c = points.row(t[2]).transpose() - origin;
    const auto sample = [&](double i, double j) {
      const double d = distance(a + (b - a) * (i / n) + (c - a) * (j / n));
      result.max = std::max(result.max, d);
      sum += own / (n * n) * d * d;
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        sample(i + 1.0 / 3.0, j + 1.0 / 3.0);
        if (i + j + 1 < n) sample(i + 2.0 / 3.0, j + 2.0 / 3.0);
      }
  }
  std::vector<char> done(static_cast<size_t>(points.rows()), 0);
  for (const int v : polygons.indices()) {
    if (done[v]) continue;
    done[v] = 1;
    result.max = std::max(result.max, distance(points.row(v).transpose() - origin));
  }
  result.rms = std::sqrt(sum / area);
  return result;
}

}  // namespace

Result<TwoSidedDistance> surface_distance(const Points& first_points, const Polygons& first,
                                          const Points& second_points, const Polygons& second, int samples) {
  if (samples < 1)
    return fail(ErrorCode::Usage, "there has to be a sample or more", "samples", "Ask for 20000");
  const auto one = ReferenceSurface::create(first_points, first, "the first surface");
  if (!one) return tl::unexpected(one.error());
  const auto other = ReferenceSurface::create(second_points, second, "the second surface");
  if (!other) return tl::unexpected(other.error());
  return TwoSidedDistance{distance_to(**other, first_points, first, samples),
                          distance_to(**one, second_points, second, samples)};
}

}  // namespace planewright
