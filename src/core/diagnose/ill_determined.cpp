#include "core/diagnose/ill_determined.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace planewright {

Vector determinacy(const TangentComplex& complex, const State& state) {
  Vector measure(complex.point_count());
  Eigen::SelfAdjointEigenSolver<Matrix3d> solver;
  for (int j = 0; j < complex.point_count(); ++j) {
    Matrix3d gram = Matrix3d::Zero();
    for (int i : complex.planes_of_point[j]) gram += state.n.row(i).transpose() * state.n.row(i);
    solver.computeDirect(gram, Eigen::EigenvaluesOnly);
    measure[j] = std::sqrt(std::max(0.0, solver.eigenvalues()[0]));
  }
  return measure;
}

Vector tilt_moves(const TangentComplex& complex, const State& state) {
  constexpr double kLeastSigma = 1e-8, kDegree = std::numbers::pi / 180.0;
  const Vector sigma = determinacy(complex, state);
  Vector moves = Vector::Zero(complex.point_count());
  for (int j = 0; j < complex.point_count(); ++j) {
    const auto planes = complex.planes_of_point[j];
    if (planes.size() < 3) continue;
    double arm = 0.0;
    for (const int i : planes)
      arm = std::max(arm,
                     (state.x.row(j) - complex.anchors.row(i) - state.h[i] * state.n.row(i)).squaredNorm());
    moves[j] = kDegree * std::sqrt(arm) / complex.mean_edge / std::max(sigma[j], kLeastSigma);
  }
  return moves;
}

namespace {

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<IllDetermined> below(const TangentComplex& complex, const Vector& measure, double threshold) {
  std::vector<IllDetermined> found;
  for (int j = 0; j < complex.point_count(); ++j)
    if (complex.planes_of_point.valence(j) >= 3 && measure[j] < threshold) found.push_back({j, measure[j]});
  std::stable_sort(found.begin(), found.end(), [](const IllDetermined& a, const IllDetermined& b) {
    return a.singular_value < b.singular_value;
  });
  return found;
}

double notable(const TangentComplex& complex, const Vector& measure) {
  constexpr double kAlways = 1e-3, kNever = 0.05, kFarBelow = 0.25;
  std::vector<double> inner;
  for (int j = 0; j < complex.point_count(); ++j)
    if (complex.planes_of_point.valence(j) >= 3) inner.push_back(measure[j]);
  if (inner.empty()) return kAlways;
  return std::clamp(kFarBelow * median(inner), kAlways, kNever);
}

}  // namespace

double notable_threshold(const TangentComplex& complex, const State& state) {
  return notable(complex, determinacy(complex, state));
}

double notable_tilt_move(const Vector& moves) {
  constexpr double kNever = 2.0, kAlways = 100.0, kFarAbove = 32.0;
  std::vector<double> inner;
  for (const double move : moves)
    if (move > 0.0) inner.push_back(move);
  return inner.empty() ? kAlways : std::clamp(kFarAbove * median(inner), kNever, kAlways);
}

std::vector<IllDetermined> find_ill_determined(const TangentComplex& complex, const State& state,
                                               double threshold) {
  return below(complex, determinacy(complex, state), threshold);
}

std::vector<IllDetermined> find_ill_determined(const TangentComplex& complex, const State& state) {
  const Vector measure = determinacy(complex, state);
  return below(complex, measure, notable(complex, measure));
}

}  // namespace planewright
