#include "core/certify/placed_parts.h"

#include <cmath>
#include <limits>

namespace planewright {
namespace {

using Eigen::Vector2d;

// By a corner and the one that is farthest from it.
void lay(PlacedPattern& placed) {
  const Contour &from = placed.pattern->cut, &to = placed.line->points;
  placed.difference = std::numeric_limits<double>::infinity();
  if (from.rows() != to.rows() || from.rows() == 0) return;
  Eigen::Index far = 0;
  (from.rowwise() - from.row(0)).rowwise().squaredNorm().maxCoeff(&far);
  const Vector2d a = from.row(far) - from.row(0), b = to.row(far) - to.row(0);
  const Eigen::Rotation2Dd turn(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
  placed.motion.linear() = turn.toRotationMatrix();
  placed.motion.translation() = to.row(0).transpose() - turn * Vector2d(from.row(0));
  placed.difference = 0.0;
  for (Eigen::Index i = 0; i < from.rows(); ++i)
    placed.difference =
        std::max(placed.difference, (placed.motion * Vector2d(from.row(i)) - Vector2d(to.row(i))).norm());
}

}  // namespace

std::vector<PlacedPattern> placed_patterns(const Drawing& drawing, const std::vector<FlatPattern>* patterns) {
  std::vector<PlacedPattern> all;
  for (const DrawingLine& line : drawing.lines) {
    if (line.layer != DrawingLayer::Cut || !line.closed || line.panel < 0) continue;
    PlacedPattern placed{&line, nullptr, Eigen::Isometry2d::Identity(), 0.0};
    if (patterns && !(*patterns)[static_cast<size_t>(line.panel)].empty()) {
      placed.pattern = &(*patterns)[static_cast<size_t>(line.panel)];
      lay(placed);
    }
    all.push_back(placed);
  }
  return all;
}

}  // namespace planewright
