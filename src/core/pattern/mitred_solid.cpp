#include "core/pattern/mitred_solid.h"

#include <array>
#include <numeric>

namespace planewright {
namespace {

// The quad without corners that are the one before them.
std::vector<int> without_repeats(const std::array<int, 4>& quad) {
  std::vector<int> face;
  for (size_t k = 0; k < quad.size(); ++k)
    if (quad[k] != quad[(k + 3) % 4]) face.push_back(quad[k]);
  return face;
}

}  // namespace

ThickPanel mitred_solid(int panel, const SolidContour& outer, const SolidContour& inner) {
  ThickPanel solid;
  solid.panel = panel;
  solid.outer = static_cast<int>(outer.points.rows());
  solid.points.resize(outer.points.rows() + inner.points.rows(), 3);
  solid.points << outer.points, inner.points;

  const auto add = [&](const std::vector<int>& face, int side) {
    if (face.size() < 3) return;
    solid.faces.push_back(face);
    solid.side_of_face.push_back(side);
  };
  std::vector<int> face(static_cast<size_t>(solid.outer));
  std::iota(face.begin(), face.end(), 0);
  add(face, -1);
  face.resize(static_cast<size_t>(inner.points.rows()));
  std::iota(face.rbegin(), face.rend(), solid.outer);
  add(face, -1);

  const size_t sides = outer.start.size();
  for (size_t k = 0; k < sides; ++k) {
    const size_t before = (k + sides - 1) % sides;
    const int shift = solid.outer;
    add(without_repeats(
            {outer.start[k], outer.end[before], shift + inner.end[before], shift + inner.start[k]}),
        -1);
    add(without_repeats({outer.end[k], outer.start[k], shift + inner.start[k], shift + inner.end[k]}),
        static_cast<int>(k));
  }
  return solid;
}

}  // namespace planewright
