// PointIndex: finds points with exactly equal coordinates in linear time. Internal to this folder.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace planewright {

class PointIndex {
 public:
  // The number of the first point with these coordinates, counted in the order of arrival. 0.0 equals -0.0.
  // Precondition: the coordinates are not NaN.
  int insert(double x, double y, double z) {
    if (2 * (points_.size() + 1) > slots_.size()) grow();
    const std::array<double, 3> point{x + 0.0, y + 0.0, z + 0.0};  // -0.0 + 0.0 is 0.0
    int& slot = find_slot(point);
    if (slot < 0) {
      slot = static_cast<int>(points_.size());
      points_.push_back(point);
    }
    return slot;
  }

  const std::vector<std::array<double, 3>>& points() const { return points_; }

 private:
  static size_t hash(const std::array<double, 3>& point) {
    std::uint64_t h = 0;
    for (double x : point) {
      h = (h ^ std::bit_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15u;
      h ^= h >> 29;
    }
    return static_cast<size_t>(h * 0xbf58476d1ce4e5b9u >> 16);
  }

  int& find_slot(const std::array<double, 3>& point) {
    const size_t mask = slots_.size() - 1;
    size_t i = hash(point) & mask;
    while (slots_[i] >= 0 && points_[slots_[i]] != point) i = (i + 1) & mask;
    return slots_[i];
  }

  void grow() {
    slots_.assign(slots_.empty() ? 64 : 4 * slots_.size(), -1);
    for (size_t p = 0; p < points_.size(); ++p) find_slot(points_[p]) = static_cast<int>(p);
  }

  std::vector<std::array<double, 3>> points_;
  std::vector<int> slots_;  // a power of two, at most half of it in use; -1: free
};

}  // namespace planewright
