#include "core/certify/contour_match.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace planewright {
namespace {

using Eigen::Index;
using Box = Eigen::Vector4d;  // low x, low y, high x, high y

constexpr double kNone = std::numeric_limits<double>::infinity();

Box box_of(const Contour& c) {
  Box box = Box::Zero();
  if (c.rows() > 0) box << c.col(0).minCoeff(), c.col(1).minCoeff(), c.col(0).maxCoeff(), c.col(1).maxCoeff();
  return box;
}

// The farthest point of the best of all ways to lay b on a; gives up beyond `enough`.
double difference(const Contour& a, const Contour& b, bool closed, double enough) {
  const Index n = a.rows();
  if (n != b.rows() || n == 0) return kNone;
  double best = enough;
  for (const bool reversed : {false, true})
    for (Index shift = 0; shift < (closed ? n : 1); ++shift) {
      double worst = 0.0;
      for (Index i = 0; i < n && worst <= best; ++i) {
        const Index k = reversed ? (2 * n - 1 - i + shift) % n : (i + shift) % n;
        worst = std::max(worst, (a.row(i) - b.row(k)).norm());
      }
      best = std::min(best, worst);
    }
  return best;
}

double distance_to_border(const Eigen::Vector2d& p, const Contour& c) {
  double best = kNone;
  for (Index i = 0; i < c.rows(); ++i) {
    const Eigen::Vector2d a = c.row(i), along = Eigen::Vector2d(c.row((i + 1) % c.rows())) - a;
    const double length = along.squaredNorm();
    const double t = length > 0.0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0.0;
    best = std::min(best, (p - a - t * along).norm());
  }
  return best;
}

}  // namespace

std::vector<ContourMatch> match_contours(const std::vector<const Contour*>& wanted,
                                         const std::vector<const Contour*>& read, bool closed, double limit) {
  std::vector<ContourMatch> matches(wanted.size());
  std::vector<Box> boxes(read.size());
  std::vector<bool> used(read.size(), false);
  std::multimap<double, size_t> by_left;
  for (size_t j = 0; j < read.size(); ++j) {
    boxes[j] = box_of(*read[j]);
    by_left.emplace(boxes[j][0], j);
  }
  const auto use = [&](size_t i, size_t j, double far) {
    matches[i] = {static_cast<int>(j), far};
    used[j] = true;
  };
  // First those that are where they should be.
  for (size_t i = 0; i < wanted.size(); ++i) {
    const Box box = box_of(*wanted[i]);
    const auto end = by_left.upper_bound(box[0] + 2.0 * limit);
    for (auto at = by_left.lower_bound(box[0] - 2.0 * limit); at != end; ++at) {
      if (used[at->second] || (boxes[at->second] - box).cwiseAbs().maxCoeff() > 2.0 * limit) continue;
      const double far = difference(*wanted[i], *read[at->second], closed, kNone);
      if (far > limit) continue;
      use(i, at->second, far);
      break;
    }
  }
  // Then the nearest of what is left, in the order of the drawing.
  for (size_t i = 0; i < wanted.size(); ++i) {
    if (matches[i].read >= 0) continue;
    const Box box = box_of(*wanted[i]);
    ContourMatch best;
    for (size_t j = 0; j < read.size(); ++j) {
      if (used[j] || read[j]->rows() != wanted[i]->rows()) continue;
      // No lying of b on a brings corners of boxes nearer than this.
      if ((boxes[j] - box).cwiseAbs().maxCoeff() >= best.difference) continue;
      const double far = difference(*wanted[i], *read[j], closed, best.difference);
      if (far < best.difference) best = {static_cast<int>(j), far};
    }
    if (best.read >= 0) use(i, static_cast<size_t>(best.read), best.difference);
  }
  return matches;
}

double border_distance(const Contour& a, const Contour& b) {
  double far = a.rows() == 0 || b.rows() == 0 ? kNone : 0.0;
  for (Index i = 0; i < a.rows() && far < kNone; ++i) far = std::max(far, distance_to_border(a.row(i), b));
  for (Index i = 0; i < b.rows() && far < kNone; ++i) far = std::max(far, distance_to_border(b.row(i), a));
  return far;
}

}  // namespace planewright
