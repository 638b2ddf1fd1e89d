#include "core/layers/beams.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace planewright {
namespace {

// Largest distance of a quad's corners from their least-squares plane.
double deviation(const Points& points, std::span<const int> quad) {
  const Vector3d centre = centroid(points, quad);
  Matrix3d scatter = Matrix3d::Zero();
  for (int v : quad) {
    const Vector3d arm = points.row(v).transpose() - centre;
    scatter += arm * arm.transpose();
  }
  // All four in one place. Else scaled to 1, since covariances of small beams would underflow.
  const double size = scatter.trace();
  if (!(size > 0.0)) return 0.0;
  const Vector3d normal = Eigen::SelfAdjointEigenSolver<Matrix3d>(scatter / size).eigenvectors().col(0);
  double largest = 0.0;
  for (int v : quad) largest = std::max(largest, std::abs(normal.dot(points.row(v).transpose() - centre)));
  return largest;
}

double angle(const Vector3d& a, const Vector3d& b, double no_length) {
  if (!(a.norm() > no_length && b.norm() > no_length)) return 0.0;
  const Vector3d u = a.normalized(), v = b.normalized();
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

tl::unexpected<Error> different(std::string what) {
  return fail(ErrorCode::Refused, "beams need two layers of the same panels, but " + std::move(what), "beams",
              "Make both layers from the same mesh, in the same mode and with the same border policy");
}

}  // namespace

Result<Beams> make_beams(const TangentComplex& first, const State& first_state, const TangentComplex& second,
                         const State& second_state) {
  if (first.kind != second.kind) return different("one is a dual and the other is not");
  if (first.point_count() != second.point_count())
    return different("one has " + std::to_string(first.point_count()) + " corners and the other " +
                     std::to_string(second.point_count()));
  if (first.point_origin != second.point_origin)
    return different("their corners stand for different elements");
  if (first.panels != second.panels) return different("their panels join other corners");
  if (first_state.x.rows() != first.point_count() || second_state.x.rows() != second.point_count())
    return different("a layer's state has not the corners of its panels");

  const int count = first.point_count();
  Beams beams;
  beams.points.resize(2 * count, 3);
  beams.points.topRows(count) = first_state.x;
  beams.points.bottomRows(count) = second_state.x.rowwise() + (second.origin - first.origin).transpose();
  // The same panels have the same edges, in the same order: finish() makes them from the panels alone.
  const double no_length = 1e-12 * first.mean_edge;
  for (size_t e = 0; e < first.panel_edges.size(); ++e) {
    const auto& [a, b, left, right] = first.panel_edges[e];
    beams.quads.push_back(std::array{a, b, count + b, count + a});
    beams.edge.push_back(static_cast<int>(e));
    beams.planarity.push_back(deviation(beams.points, beams.quads[beams.quads.size() - 1]));
    beams.twist.push_back(angle((beams.points.row(b) - beams.points.row(a)).transpose(),
                                (beams.points.row(count + b) - beams.points.row(count + a)).transpose(),
                                no_length));
  }
  return beams;
}

BeamSummary summarise(const Beams& beams) {
  BeamSummary summary;
  summary.beams = beams.quads.size();
  for (size_t k = 0; k < beams.edge.size(); ++k) {
    if (k == 0 || beams.planarity[k] > summary.max_planarity) {
      summary.max_planarity = beams.planarity[k];
      summary.least_planar_edge = beams.edge[k];
    }
    if (k == 0 || beams.twist[k] > summary.max_twist) {
      summary.max_twist = beams.twist[k];
      summary.most_twisted_edge = beams.edge[k];
    }
  }
  const double diagonal = bounding_diagonal(beams.points);
  if (diagonal > 0.0) summary.planarity_relative = summary.max_planarity / diagonal;
  return summary;
}

}  // namespace planewright
