#include "core/problem/demands/star_rows.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace planewright {
namespace {

constexpr double kLeastSize = 0.05;  // edges

// Whether the row of step k -> l is there: about an own point, the two steps at it are not.
bool has_row(const TriangleCentre& centre, int k, int l) {
  return centre.points.size() != 1 || (centre.points.front() != k && centre.points.front() != l);
}

// Smallest n . ((f_k - s) x (f_l - s)) / L over the rows, at the wanted points and normal.
double smallest_wanted(const TangentComplex& complex, int panel, const TriangleCentre& centre, double size) {
  const Points& f = complex.preferred;
  const auto corners = complex.panels[panel];
  const Vector3d s = centre.points.empty() ? centre.fixed : centroid(f, centre.points);
  const Vector3d n = complex.normals.row(panel);
  double smallest = std::numeric_limits<double>::infinity();
  for (size_t c = 0; c < corners.size(); ++c) {
    const int k = corners[c], l = corners[(c + 1) % corners.size()];
    if (!has_row(centre, k, l)) continue;
    const Vector3d a = f.row(k).transpose() - s, b = f.row(l).transpose() - s;
    smallest = std::min(smallest, n.dot(a.cross(b)) / size);
  }
  return smallest;
}

}  // namespace

double panel_size(const TangentComplex& complex, int panel) {
  const auto corners = complex.panels[panel];
  double outline = 0.0;
  for (size_t c = 0; c < corners.size(); ++c)
    outline +=
        (complex.preferred.row(corners[c]) - complex.preferred.row(corners[(c + 1) % corners.size()])).norm();
  const double mean_edge = outline / static_cast<double>(std::max<size_t>(corners.size(), 1));
  const double area = 0.5 * newell_vector(complex.preferred, corners).norm();
  return std::max({std::sqrt(area), 0.25 * mean_edge, kLeastSize});
}

TriangleCentre star_centre(const TangentComplex& complex, int panel, double eps) {
  const auto corners = complex.panels[panel];
  if (corners.size() == 3) return {{corners[0]}};
  const double size = panel_size(complex, panel);
  const TriangleCentre anchor{{}, complex.anchors.row(panel)};
  const bool many = corners.size() > static_cast<size_t>(kMostForMean);

  TriangleCentre best = many ? anchor : TriangleCentre{{corners.begin(), corners.end()}};
  double largest = smallest_wanted(complex, panel, best, size);
  if (largest >= eps * size) return best;
  const auto consider = [&](const TriangleCentre& candidate) {
    const double value = smallest_wanted(complex, panel, candidate, size);
    if (!(value > largest)) return;
    largest = value;
    best = candidate;
  };
  if (complex.kind != ComplexKind::Planarize && !many) consider(anchor);
  for (int point : corners) consider({{point}});
  return best;
}

void add_star_rows(const DemandContext& context, int panel, double eps, PanelTriangleRows& rows) {
  const auto corners = context.complex.panels[panel];
  const double size = panel_size(context.complex, panel);
  const TriangleCentre centre = star_centre(context.complex, panel, eps);
  for (size_t c = 0; c < corners.size(); ++c) {
    const int k = corners[c], l = corners[(c + 1) % corners.size()];
    if (has_row(centre, k, l))
      rows.add(context.layout, panel, k, l, centre, 1.0 / size, {eps * size, kUnbounded},
               {ElementKind::Panel, panel});
  }
}

}  // namespace planewright
