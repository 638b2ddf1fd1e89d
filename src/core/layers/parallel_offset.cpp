#include "core/layers/parallel_offset.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <Eigen/SparseCholesky>
#include <cmath>

namespace planewright {
namespace {

// Everything below is for thickness 1.

struct Corner {
  Vector3d move;         // the smallest that the planes leave it
  Eigen::Matrix3d free;  // first `slides` columns: orthonormal directions within all of its planes
  int slides;
  Vector3d slide = Vector3d::Zero();  // chosen among them
  double residual;                    // farthest of the moved planes
};

Corner corner_of(const TangentComplex& complex, const State& state, int j) {
  const auto planes = complex.planes_of_point[j];
  Eigen::Matrix<double, Eigen::Dynamic, 3> normals(static_cast<Eigen::Index>(planes.size()), 3);
  for (size_t r = 0; r < planes.size(); ++r)
    normals.row(static_cast<Eigen::Index>(r)) = state.n.row(planes[r]);
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(normals, Eigen::ComputeThinU | Eigen::ComputeFullV);
  svd.setThreshold(kSingular);
  const Vector ones = Vector::Ones(normals.rows());
  Corner corner{
      .move = svd.solve(ones), .free = {}, .slides = 3 - static_cast<int>(svd.rank()), .residual = 0};
  corner.free.leftCols(corner.slides) = svd.matrixV().rightCols(corner.slides);
  corner.residual = (normals * corner.move - ones).cwiseAbs().maxCoeff();
  return corner;
}

// The smallest slides that keep panel edges parallel where both planes of an edge leave that open: least norm
// of y subject to C y = r, one row per edge.
void keep_edges_parallel(const TangentComplex& complex, const State& state, std::vector<Corner>& corners) {
  std::vector<int> first(corners.size());
  int unknowns = 0;
  for (size_t j = 0; j < corners.size(); ++j) {
    first[j] = unknowns;
    unknowns += corners[j].slides;
  }
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<double> right;
  for (const PanelEdge& edge : complex.panel_edges) {
    if (corners[edge.a].slides == 0 && corners[edge.b].slides == 0) continue;
    // Both planes contain the edge's direction and both moves raise both by 1, so either plane will do.
    const Vector3d normal = state.n.row(edge.left >= 0 ? edge.left : edge.right);
    const Vector3d along = (state.x.row(edge.b) - state.x.row(edge.a)).transpose();
    if (!(along.norm() > 1e-12 * complex.mean_edge)) continue;  // no direction to keep
    const Vector3d across = normal.cross(along).normalized();
    const int row = static_cast<int>(right.size());
    for (const auto& [j, sign] : {std::pair(edge.a, 1.0), std::pair(edge.b, -1.0)})
      for (int k = 0; k < corners[j].slides; ++k)
        entries.emplace_back(row, first[j] + k, sign * across.dot(corners[j].free.col(k)));
    right.push_back(across.dot(corners[edge.b].move - corners[edge.a].move));
  }
  if (right.empty()) return;
  const auto rows = static_cast<Eigen::Index>(right.size());
  Eigen::SparseMatrix<double> c(rows, unknowns);
  c.setFromTriplets(entries.begin(), entries.end());

  // Rows may be dependent or contradict each other by little (an outline closed on itself), so the normal
  // equations are damped and iterated: what is determined by more than about the root of the damping comes
  // out to rounding, the rest is left alone instead of blown up.
  constexpr double kDamping = 1e-10;
  constexpr int kIterations = 20;
  Eigen::SparseMatrix<double> damped = c * c.transpose(), identity(rows, rows);
  identity.setIdentity();
  damped += kDamping * identity;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(damped);
  const Vector r = Eigen::Map<const Vector>(right.data(), rows);
  Vector y = Vector::Zero(unknowns);
  for (int k = 0; k < kIterations; ++k) y += c.transpose() * factor.solve(r - c * y);
  for (size_t j = 0; j < corners.size(); ++j)
    corners[j].slide = corners[j].free.leftCols(corners[j].slides) * y.segment(first[j], corners[j].slides);
}

// The part of the slide, which is perpendicular to the smallest move, that ends at kMostMove.
Vector3d shortened(const Corner& corner) {
  const double smallest = corner.move.norm();
  if (smallest >= kMostMove) return corner.move * (kMostMove / smallest);
  return corner.move + std::sqrt(kMostMove * kMostMove - smallest * smallest) * corner.slide.normalized();
}

}  // namespace

ParallelOffset parallel_offset(const TangentComplex& complex, const State& state, double thickness) {
  ParallelOffset result{state, {}, {}};
  if (thickness == 0.0) return result;
  result.state.h.array() += thickness;

  std::vector<Corner> corners;
  corners.reserve(static_cast<size_t>(complex.point_count()));
  for (int j = 0; j < complex.point_count(); ++j) corners.push_back(corner_of(complex, state, j));
  keep_edges_parallel(complex, state, corners);

  for (int j = 0; j < complex.point_count(); ++j) {
    const Corner& corner = corners[j];
    Vector3d move = corner.move + corner.slide;
    if (move.norm() > kMostMove) {
      result.blunted.push_back({j, move.norm() * std::abs(thickness)});
      move = shortened(corner);
    } else if (corner.residual > 1e-9) {
      result.residuals.push_back({j, corner.residual * std::abs(thickness)});
    }
    result.state.x.row(j) += thickness * move.transpose();
  }
  return result;
}

}  // namespace planewright
