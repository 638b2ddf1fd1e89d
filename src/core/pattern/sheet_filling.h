// Filling one sheet. The only file besides its .cpp that knows how nesting is done. Threads: pure.
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/pattern/flat_pattern.h"

namespace planewright {

// A convex part, ready to be laid: for each way to turn it, its hull grown by half the spacing on a grid of
// 1e-3 mm. It is grown by a little more than that, so that rounding costs no spacing.
class SheetPart {
 public:
  using Grid = Eigen::Matrix<std::int64_t, 2, 1>;
  struct Turned {
    double rotation;
    Eigen::Vector2d low;      // lower left corner of the turned part's box, mm
    Eigen::Vector2d box;      // mm
    std::vector<Grid> grown;  // clockwise, relative to `low`
  };

  SheetPart(int panel, double area, const Contour& hull, const std::vector<double>& angles, double spacing);
  int panel() const { return panel_; }
  double area() const { return area_; }  // mm^2, of the part itself
  const std::vector<Turned>& ways() const { return ways_; }

 private:
  int panel_;
  double area_;
  std::vector<Turned> ways_;
};

struct Placement {
  size_t part;
  double rotation;        // first
  Eigen::Vector2d shift;  // mm, then; in the room, whose corner is (0, 0)
};

// Lays as many of the waiting parts (in their order) as find room; at least one of them, as each fits the
// empty room. None: stopped.
std::optional<std::vector<Placement>> fill_sheet(const std::vector<SheetPart>& parts,
                                                 const std::vector<size_t>& waiting,
                                                 const Eigen::Vector2d& room, const std::stop_token& stop);

}  // namespace planewright
