#include "ui/render/ground_shadow.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace planewright::render {
namespace {

constexpr int kCells = GroundShadow::kCells;
constexpr double kMargin = 0.22;  // round the plan, in its larger side
constexpr int kBlurRadius = 5, kBlurs = 3;

// Marks the cells whose centres the triangle covers in plan; x, y in cells, z the darkness at the corners.
void cover(std::vector<float>& cells, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const auto cell = [](double x) { return static_cast<int>(std::clamp(x, 0.0, kCells - 1.0)); };
  const double area = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  if (std::abs(area) < 1e-9) return;
  for (int y = cell(std::min({a.y(), b.y(), c.y()}) - 0.5); y <= cell(std::max({a.y(), b.y(), c.y()})); ++y) {
    for (int x = cell(std::min({a.x(), b.x(), c.x()}) - 0.5); x <= cell(std::max({a.x(), b.x(), c.x()}));
         ++x) {
      const double px = x + 0.5, py = y + 0.5;
      const double wb = ((px - a.x()) * (c.y() - a.y()) - (py - a.y()) * (c.x() - a.x())) / area;
      const double wc = ((b.x() - a.x()) * (py - a.y()) - (b.y() - a.y()) * (px - a.x())) / area;
      if (wb < 0.0 || wc < 0.0 || wb + wc > 1.0) continue;
      const float darkness = static_cast<float>((1.0 - wb - wc) * a.z() + wb * b.z() + wc * c.z());
      cells[y * kCells + x] = std::max(cells[y * kCells + x], darkness);
    }
  }
}

// A running mean along rows (stride 1) or columns (stride kCells).
void blur(std::vector<float>& cells, int stride, int line_stride) {
  std::vector<float> line(kCells);
  for (int l = 0; l < kCells; ++l) {
    float* from = cells.data() + l * line_stride;
    for (int i = 0; i < kCells; ++i) line[i] = from[i * stride];
    for (int i = 0; i < kCells; ++i) {
      float sum = 0.0f;
      for (int k = std::max(i - kBlurRadius, 0); k <= std::min(i + kBlurRadius, kCells - 1); ++k)
        sum += line[k];
      from[i * stride] = sum / (2 * kBlurRadius + 1);
    }
  }
}

}  // namespace

std::optional<GroundShadow> make_ground_shadow(const Points& points, std::span<const int> corners) {
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (int i : corners) {
    if (!points.row(i).allFinite()) continue;
    low = low.cwiseMin(points.row(i).transpose());
    high = high.cwiseMax(points.row(i).transpose());
  }
  const double side = std::max(high.x() - low.x(), high.y() - low.y());
  if (!low.allFinite() || !high.allFinite() || !(side > 0.0) || !std::isfinite(side)) {
    return std::nullopt;
  }

  GroundShadow shadow;
  const double reach = (0.5 + kMargin) * side, height = std::max(high.z() - low.z(), 1e-3 * side);
  const double cell = 2.0 * reach / kCells;
  const Vector3d centre = 0.5 * (low + high);
  shadow.low = {centre.x() - reach, centre.y() - reach, low.z()};
  shadow.high = {centre.x() + reach, centre.y() + reach, low.z()};

  std::vector<float> cells(kCells * kCells, 0.0f);
  const auto in_cells = [&](int point) {
    const Vector3d p = points.row(point).transpose();
    const double lift = (p.z() - low.z()) / std::max(height, 0.25 * side);
    return Vector3d((p.x() - shadow.low.x()) / cell, (p.y() - shadow.low.y()) / cell, std::exp(-1.5 * lift));
  };
  for (size_t t = 0; t + 2 < corners.size(); t += 3) {
    const auto triangle = corners.subspan(t, 3);
    if (!std::all_of(triangle.begin(), triangle.end(), [&](int i) { return points.row(i).allFinite(); }))
      continue;
    cover(cells, in_cells(triangle[0]), in_cells(triangle[1]), in_cells(triangle[2]));
  }
  for (int i = 0; i < kBlurs; ++i) {
    blur(cells, 1, kCells);
    blur(cells, kCells, 1);
  }
  shadow.darkness.resize(cells.size());
  for (size_t i = 0; i < cells.size(); ++i) {
    shadow.darkness[i] = static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(cells[i], 0.0f, 1.0f)));
  }
  return shadow;
}

}  // namespace planewright::render
