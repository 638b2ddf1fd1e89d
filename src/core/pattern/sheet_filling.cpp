#include "core/pattern/sheet_filling.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/pattern/part_fit.h"

// Its geometry alone: the rest of it does not compile as C++20 (an ambiguous operator !=).
#include <libnest2d/backends/clipper/geometries.hpp>

namespace planewright {
namespace {

using Eigen::Vector2d;

constexpr double kUnit = 1e-3;     // mm, of the grid
constexpr double kGrow = 3.0;      // units more than half the spacing
constexpr double kInside = 1.0;    // units by which a place has to lie in a no-fit polygon to be taken
constexpr int kMisses = 12;        // parts in a row that find no room until a sheet is full
constexpr size_t kManyParts = 60;  // on a sheet: only the first two ways are tried

std::vector<Vector2d> no_fit(const libnest2d::PolygonImpl& still, const Vector2d& at,
                             const libnest2d::PolygonImpl& moving) {
  using namespace libnest2d;
  namespace sl = shapelike;
  const auto fit = nfp::noFitPolygon<nfp::NfpLevel::CONVEX_ONLY>(still, moving);
  // The library says where the polygon is by its top right corner: there the moving part's lower left corner
  // touches the still one's upper right.
  const auto touch = nfp::rightmostUpVertex(still) - nfp::leftmostDownVertex(moving);
  const auto shift = touch - fit.second + nfp::rightmostUpVertex(moving);
  // Positions of the moving part's origin instead of its top right corner.
  const auto origin = shift - nfp::rightmostUpVertex(moving);
  std::vector<Vector2d> result;
  for (const auto& p : sl::contour(fit.first))
    result.emplace_back(static_cast<double>(p.X + origin.X) + at.x(),
                        static_cast<double>(p.Y + origin.Y) + at.y());
  if (result.size() > 1 && result.front() == result.back()) result.pop_back();
  return result;
}

libnest2d::PolygonImpl polygon_of(const std::vector<SheetPart::Grid>& contour) {
  libnest2d::PolygonImpl polygon;
  for (const auto& p : contour) polygon.Contour.emplace_back(p.x(), p.y());
  polygon.Contour.push_back(polygon.Contour.front());
  return polygon;
}

// A no-fit polygon: clockwise, with its box.
struct Forbidden {
  std::vector<Vector2d> corners;
  Vector2d low, high;

  explicit Forbidden(std::vector<Vector2d> polygon) : corners(std::move(polygon)) {
    low = high = corners.front();
    for (const Vector2d& p : corners) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  Vector2d corner(size_t k) const { return corners[k % corners.size()]; }
  bool holds(const Vector2d& p) const {
    if (((p - low).array() <= kInside).any() || ((high - p).array() <= kInside).any()) return false;
    for (size_t k = 0; k < corners.size(); ++k) {
      const Vector2d edge = corner(k + 1) - corners[k], to = p - corners[k];
      if (edge.y() * to.x() - edge.x() * to.y() <= kInside * edge.norm()) return false;
    }
    return true;
  }
  bool near(const Forbidden& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};

// Which way a sheet is filled: places are ranked by how far the part reaches along the first direction, then
// the other.
struct Way {
  int first;               // 0: along the width, 1: along the height
  std::vector<int> turns;  // of a part's ways, those to take; empty: all
};

class Sheet {
 public:
  Sheet(const std::vector<SheetPart>& parts, const Vector2d& room, Way way)
      : parts_(parts), room_(room), way_(std::move(way)) {}

  bool lay(size_t part) {
    best_ = {};
    const auto& ways = parts_[part].ways();
    bool any = false;
    for (size_t w = 0; w < ways.size(); ++w) {
      if (!way_.turns.empty() &&
          std::find(way_.turns.begin(), way_.turns.end(), static_cast<int>(w)) == way_.turns.end())
        continue;
      any = true;
      look(ways[w]);
    }
    // Parts that cannot be laid in these ways at all are laid in the others.
    if (!any)
      for (const auto& turn : ways) look(turn);
    if (!best_.turn) return false;
    laid_.push_back({polygon_of(best_.turn->grown), best_.at});
    placements_.push_back({part, best_.turn->rotation, kUnit * best_.at - best_.turn->low});
    area_ += parts_[part].area();
    return true;
  }

  const std::vector<Placement>& placements() const { return placements_; }
  double area() const { return area_; }

 private:
  struct Laid {
    libnest2d::PolygonImpl polygon;
    Vector2d at;  // units
  };
  struct Best {
    const SheetPart::Turned* turn = nullptr;
    Vector2d at = Vector2d::Zero();
    Vector2d reach = Vector2d::Constant(std::numeric_limits<double>::infinity());
  };

  // All places worth a look are where the moving part touches two things: corners of the room, corners of
  // no-fit polygons, and where their sides cross each other or the room's.
  void look(const SheetPart::Turned& turn) {
    const Vector2d free = ((room_ - turn.box) / kUnit).array().max(0.0).matrix();
    const Vector2d most(std::floor(free.x() + 1e-3), std::floor(free.y() + 1e-3));
    const libnest2d::PolygonImpl moving = polygon_of(turn.grown);
    const double size = turn.box[way_.first] / kUnit;
    forbidden_.clear();
    for (const Laid& laid : laid_) forbidden_.emplace_back(no_fit(laid.polygon, laid.at, moving));

    size_t holder = 0;
    const auto consider = [&](const Vector2d& where) {
      const Vector2d at(std::round(where.x()), std::round(where.y()));
      if ((at.array() < 0.0).any() || (at.array() > most.array()).any()) return;
      const Vector2d end = at + turn.box / kUnit;
      const Vector2d reach(end[way_.first], end[1 - way_.first]);
      if (!(std::pair(reach.x(), reach.y()) < std::pair(best_.reach.x(), best_.reach.y()))) return;
      // What held the place before holds the next one, mostly.
      if (holder < forbidden_.size() && forbidden_[holder].holds(at)) return;
      for (size_t i = 0; i < forbidden_.size(); ++i)
        if (forbidden_[i].holds(at)) {
          holder = i;
          return;
        }
      best_ = {&turn, at, reach};
    };
    for (const double x : {0.0, most.x()})
      for (const double y : {0.0, most.y()}) consider({x, y});
    for (size_t i = 0; i < forbidden_.size(); ++i) {
      const Forbidden& one = forbidden_[i];
      // Nothing of it reaches less far than the best place.
      if (one.low[way_.first] + size > best_.reach.x()) continue;
      for (size_t k = 0; k < one.corners.size(); ++k) {
        const Vector2d a = one.corner(k), b = one.corner(k + 1);
        consider(a);
        for (const int axis : {0, 1})
          for (const double wall : {0.0, most[axis]})
            if ((a[axis] < wall) != (b[axis] < wall)) {
              Vector2d p = a + (b - a) * ((wall - a[axis]) / (b[axis] - a[axis]));
              p[axis] = wall;
              consider(p);
            }
      }
      for (size_t j = 0; j < i; ++j) {
        const Forbidden& other = forbidden_[j];
        if (!one.near(other)) continue;
        if (std::max(one.low[way_.first], other.low[way_.first]) + size > best_.reach.x()) continue;
        for (size_t k = 0; k < one.corners.size(); ++k) {
          const Vector2d a = one.corner(k), b = one.corner(k + 1), u = b - a;
          const Vector2d low = a.cwiseMin(b);
          if ((low.array() > other.high.array()).any() || (a.cwiseMax(b).array() < other.low.array()).any() ||
              low[way_.first] + size > best_.reach.x())
            continue;
          for (size_t l = 0; l < other.corners.size(); ++l) {
            const Vector2d c = other.corner(l), v = other.corner(l + 1) - c, d = c - a;
            const double sine = u.x() * v.y() - u.y() * v.x();
            const double s = d.x() * v.y() - d.y() * v.x(), t = d.x() * u.y() - d.y() * u.x();
            if (sine > 0.0 ? (s >= 0.0 && s <= sine && t >= 0.0 && t <= sine)
                           : (sine < 0.0 && s <= 0.0 && s >= sine && t <= 0.0 && t >= sine))
              consider(a + s / sine * u);
          }
        }
      }
    }
  }

  const std::vector<SheetPart>& parts_;
  Vector2d room_;
  Way way_;
  std::vector<Laid> laid_;
  std::vector<Forbidden> forbidden_;
  std::vector<Placement> placements_;
  double area_ = 0.0;
  Best best_;
};

}  // namespace

SheetPart::SheetPart(int panel, double area, const Contour& hull, const std::vector<double>& angles,
                     double spacing)
    : panel_(panel), area_(area) {
  for (const double angle : angles) {
    const Contour contour = turned(hull, angle);
    Turned way{angle, contour.colwise().minCoeff().transpose(), box_of(contour), {}};
    ClipperLib::Path path;
    for (Eigen::Index k = 0; k < contour.rows(); ++k)
      path.emplace_back(std::llround((contour(k, 0) - way.low.x()) / kUnit),
                        std::llround((contour(k, 1) - way.low.y()) / kUnit));
    ClipperLib::ClipperOffset offset;
    offset.AddPath(path, ClipperLib::jtMiter, ClipperLib::etClosedPolygon);
    ClipperLib::Paths grown;
    offset.Execute(grown, spacing / 2 / kUnit + kGrow);
    for (auto p = grown.at(0).rbegin(); p != grown.at(0).rend(); ++p) way.grown.emplace_back(p->X, p->Y);
    ways_.push_back(std::move(way));
  }
}

std::optional<std::vector<Placement>> fill_sheet(const std::vector<SheetPart>& parts,
                                                 const std::vector<size_t>& waiting, const Vector2d& room,
                                                 const std::stop_token& stop) {
  std::vector<Placement> fullest;
  double most = -1.0;
  for (const Way& way :
       {Way{1, {}}, Way{0, {}}, Way{1, {0, 2}}, Way{0, {0, 2}}, Way{1, {1, 3}}, Way{0, {1, 3}}}) {
    Sheet sheet(parts, room, way);
    int misses = 0;
    for (const size_t part : waiting) {
      if (stop.stop_requested()) return std::nullopt;
      misses = sheet.lay(part) ? 0 : misses + 1;
      if (misses >= kMisses) break;
    }
    if (sheet.area() > most) {
      most = sheet.area();
      fullest = sheet.placements();
    }
    if (sheet.placements().size() > kManyParts && way.first == 0) break;
  }
  return fullest;
}

}  // namespace planewright
