// The plain array types that every folder of the core shares.
//
// Points: #N x 3, row-major, one point or vector per row, double precision.
// Polygons: a list of index lists in one flat buffer (compressed rows); indices are 0-based.
// Threads: plain values.
#pragma once

#include <Eigen/Core>
#include <initializer_list>
#include <span>
#include <vector>

namespace planewright {

using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Vector = Eigen::VectorXd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// A list of index lists: faces of a mesh, panels of a complex, planes round a point.
// Invariant: offsets.size() == size() + 1, offsets is non-decreasing, offsets.back() == indices.size().
class Polygons {
 public:
  Polygons() = default;
  Polygons(std::initializer_list<std::initializer_list<int>> lists) {
    for (const auto& list : lists) push_back(std::span<const int>(list.begin(), list.size()));
  }

  int size() const { return static_cast<int>(offsets_.size()) - 1; }
  bool empty() const { return size() == 0; }
  int valence(int i) const { return offsets_[i + 1] - offsets_[i]; }
  // All index lists joined, and where each begins (#size + 1).
  const std::vector<int>& indices() const { return indices_; }
  const std::vector<int>& offsets() const { return offsets_; }

  std::span<const int> operator[](int i) const { return {indices_.data() + offsets_[i], static_cast<size_t>(valence(i))}; }
  std::span<int> operator[](int i) { return {indices_.data() + offsets_[i], static_cast<size_t>(valence(i))}; }

  void push_back(std::span<const int> list) {
    indices_.insert(indices_.end(), list.begin(), list.end());
    offsets_.push_back(static_cast<int>(indices_.size()));
  }
  void reserve(int lists, int entries) {
    offsets_.reserve(static_cast<size_t>(lists) + 1);
    indices_.reserve(static_cast<size_t>(entries));
  }

  bool operator==(const Polygons&) const = default;

 private:
  std::vector<int> indices_;
  std::vector<int> offsets_{0};
};

// Twice the vector area of a closed polygon (#N x 3 corners picked by `polygon`): the Newell normal, not unit.
// Independent of the corner it starts at and of a common shift (taken relative to the first corner).
Vector3d newell_vector(const Points& points, std::span<const int> polygon);

// Mean of the picked points. Precondition: the list is not empty.
Vector3d centroid(const Points& points, std::span<const int> indices);

// Length of the diagonal of the axis-aligned bounding box; 0 for no points.
double bounding_diagonal(const Points& points);

}  // namespace planewright
