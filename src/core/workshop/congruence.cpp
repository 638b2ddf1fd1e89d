#include "core/workshop/congruence.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <optional>
#include <unordered_map>

#include "core/workshop/measure_slack.h"
#include "core/workshop/panel_plane.h"

namespace planewright {
namespace {

using Complex = std::complex<double>;

// An outline in its plane, relative to the mean of its corners.
struct Shape {
  std::vector<Complex> corners;
  std::vector<double> radii;   // of the corners from their mean, ascending
  std::vector<double> bevels;  // of the sides
  bool square_cut = true;      // no side has a bevel
  double mean_radius = 0.0;    // root of the mean square
};

Shape make_shape(const WorkshopModel& model, const PanelPassport& passport, double bevel_tolerance) {
  Shape shape;
  Complex mean = 0.0;
  for (const auto& p :
       flat_outline(model.points, model.panels[passport.panel], model.normals.row(passport.panel))) {
    shape.corners.emplace_back(p.x(), p.y());
    mean += shape.corners.back();
  }
  mean /= static_cast<double>(shape.corners.size());
  double sum = 0.0;
  for (Complex& corner : shape.corners) {
    corner -= mean;
    shape.radii.push_back(std::abs(corner));
    sum += std::norm(corner);
  }
  std::sort(shape.radii.begin(), shape.radii.end());
  shape.mean_radius = std::sqrt(sum / static_cast<double>(shape.corners.size()));
  for (const SidePassport& side : passport.sides) {
    shape.bevels.push_back(side.bevel);
    shape.square_cut = shape.square_cut && std::abs(side.bevel) <= bevel_tolerance;
  }
  return shape;
}

// Which corner of a member lies on the mother's corner k.
size_t corner_on(size_t k, size_t shift, size_t n, bool mirrored) {
  return mirrored ? (shift + n - k) % n : (shift + k) % n;
}

// The farthest corner, after the turn that makes the sum of squares least. A turned-over member is its
// complex conjugate.
double deviation(const Shape& mother, const Shape& member, size_t shift, bool mirrored) {
  const size_t n = mother.corners.size();
  const auto at = [&](size_t k) {
    const Complex corner = member.corners[corner_on(k, shift, n, mirrored)];
    return mirrored ? std::conj(corner) : corner;
  };
  Complex sum = 0.0;
  for (size_t k = 0; k < n; ++k) sum += mother.corners[k] * std::conj(at(k));
  const double size = std::abs(sum);
  const Complex turn = size > 0.0 ? sum / size : Complex(1.0);
  double farthest = 0.0;
  for (size_t k = 0; k < n; ++k) farthest = std::max(farthest, std::abs(mother.corners[k] - turn * at(k)));
  return farthest;
}

bool bevels_agree(const Shape& mother, const Shape& member, size_t shift, double tolerance) {
  const size_t n = mother.bevels.size();
  for (size_t k = 0; k < n; ++k)
    if (!(std::abs(mother.bevels[k] - member.bevels[(shift + k) % n]) <= tolerance)) return false;
  return true;
}

struct Limits {
  double corner;  // mm
  bool bevels;
  double bevel;  // degrees
};

// How a member lies on a mother; none: it does not.
std::optional<CongruenceMember> lay_on(const Shape& mother, const Shape& member, int panel, bool mirrored,
                                       const Limits& limits) {
  if (limits.bevels && mirrored && !(mother.square_cut && member.square_cut)) return std::nullopt;
  // Shifts that rounding alone tells apart: the smallest.
  const double clearly = 1e-6 * limits.corner + kRelativeSlack * mother.mean_radius;
  std::optional<CongruenceMember> best;
  for (size_t shift = 0; shift < mother.corners.size(); ++shift) {
    if (limits.bevels && !mirrored && !bevels_agree(mother, member, shift, limits.bevel)) continue;
    const double off = deviation(mother, member, shift, mirrored);
    if (off <= limits.corner && (!best || off < best->deviation - clearly))
      best = CongruenceMember{panel, mirrored, static_cast<int>(shift), off};
  }
  return best;
}

// Mothers by what no motion changes. Corners that lie on each other within t, their means on one another,
// have a root-mean-square radius, a largest and every other radius in order that differ by no more than t: so
// cells of t and their neighbours have all that can match.
class Mothers {
 public:
  explicit Mothers(double tolerance) : tolerance_(tolerance), cell_(std::max(1.001 * tolerance, 1e-9)) {}

  void add(const Shape& shape, int mother) { cells_[key(shape, 0, 0)].push_back(mother); }

  // Those that may match, ascending.
  std::vector<int> near(const Shape& shape, const std::vector<Shape>& shapes,
                        const std::vector<CongruenceClass>& classes) const {
    std::vector<int> found;
    for (int i = -1; i <= 1; ++i)
      for (int k = -1; k <= 1; ++k) {
        const auto cell = cells_.find(key(shape, i, k));
        if (cell == cells_.end()) continue;
        for (const int mother : cell->second) {
          const int panel = classes[static_cast<size_t>(mother)].members.front().panel;
          if (radii_agree(shape, shapes[static_cast<size_t>(panel)])) found.push_back(mother);
        }
      }
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  struct Key {
    std::int64_t mean, largest;
    size_t corners;
    bool operator==(const Key&) const = default;
  };
  struct Hash {
    size_t operator()(const Key& key) const {
      std::uint64_t h = 0;
      for (const std::uint64_t part : {static_cast<std::uint64_t>(key.mean),
                                       static_cast<std::uint64_t>(key.largest), std::uint64_t{key.corners}}) {
        h = (h ^ part) * 0x9e3779b97f4a7c15u;
        h ^= h >> 29;
      }
      return static_cast<size_t>(h);
    }
  };

  Key key(const Shape& shape, int mean_step, int largest_step) const {
    // Beyond 2^53 cells doubles no longer tell one from the next; such a panel has them all in one.
    const auto cell = [&](double value) {
      return static_cast<std::int64_t>(std::min(std::floor(value / cell_), 9e15));
    };
    return {cell(shape.mean_radius) + mean_step, cell(shape.radii.back()) + largest_step,
            shape.corners.size()};
  }

  bool radii_agree(const Shape& a, const Shape& b) const {
    const double slack = tolerance_ + kRelativeSlack * a.mean_radius;
    for (size_t k = 0; k < a.radii.size(); ++k)
      if (std::abs(a.radii[k] - b.radii[k]) > slack) return false;
    return true;
  }

  double tolerance_, cell_;
  std::unordered_map<Key, std::vector<int>, Hash> cells_;
};

}  // namespace

std::vector<CongruenceClass> congruence_classes(const WorkshopModel& model,
                                                const std::vector<PanelPassport>& passports,
                                                const CongruenceOptions& options) {
  const double tolerance = options.tolerance * (1.0 + kRelativeSlack) + coordinate_resolution(model);
  const double bevel_tolerance = options.bevel_tolerance + 360.0 * kRelativeSlack;
  const Limits limits{tolerance, options.bevels, bevel_tolerance};
  std::vector<Shape> shapes;
  for (const PanelPassport& passport : passports)
    shapes.push_back(make_shape(model, passport, bevel_tolerance));

  std::vector<CongruenceClass> classes;
  Mothers mothers(tolerance);
  for (size_t p = 0; p < shapes.size(); ++p) {
    const int panel = static_cast<int>(p);
    bool placed = false;
    for (const int candidate : mothers.near(shapes[p], shapes, classes)) {
      auto& members = classes[static_cast<size_t>(candidate)].members;
      const Shape& mother = shapes[static_cast<size_t>(members.front().panel)];
      auto laid = lay_on(mother, shapes[p], panel, false, limits);
      if (!laid) laid = lay_on(mother, shapes[p], panel, true, limits);
      if (!laid) continue;
      members.push_back(*laid);
      placed = true;
      break;
    }
    if (placed) continue;
    mothers.add(shapes[p], static_cast<int>(classes.size()));
    classes.push_back({{CongruenceMember{panel}}});
  }
  return classes;
}

}  // namespace planewright
