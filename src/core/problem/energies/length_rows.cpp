#include "core/problem/energies/length_rows.h"

#include <algorithm>

namespace planewright {
namespace {

// Per axis: (a, a), (b, a), (b, b); the coordinates do not mix.
constexpr StencilPair kCurvature[] = {{0, 0}, {3, 0}, {3, 3}, {1, 1}, {4, 1}, {4, 4}, {2, 2}, {5, 2}, {5, 5}};

}  // namespace

LengthRows::LengthRows(std::string name, const EnergyContext& context,
                       const std::vector<std::array<int, 2>>& pairs)
    : name_(std::move(name)) {
  const Layout& layout = context.layout;
  const Points& wanted = context.complex.preferred;
  for (const auto& [a, b] : pairs) {
    variables_.push_back(
        {layout.x(a, 0), layout.x(a, 1), layout.x(a, 2), layout.x(b, 0), layout.x(b, 1), layout.x(b, 2)});
    lengths_.push_back(std::max((wanted.row(a) - wanted.row(b)).norm(), kLeastReferenceLength));
  }
}

std::span<const StencilPair> LengthRows::curvature(int) const {
  return kCurvature;
}

double LengthRows::evaluate(int row, const double* x, double* gradient, double* curvature) const {
  const double length = lengths_[static_cast<size_t>(row)];
  double squared = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double difference = x[axis] - x[3 + axis];
    squared += difference * difference;
    if (gradient) {
      gradient[axis] = difference / length;
      gradient[3 + axis] = -difference / length;
    }
    if (curvature) {
      curvature[3 * axis] = 1.0 / length;
      curvature[3 * axis + 1] = -1.0 / length;
      curvature[3 * axis + 2] = 1.0 / length;
    }
  }
  return (squared - length * length) / (2.0 * length);
}

}  // namespace planewright
