// Numbers, transforms and paths as SVG attributes write them. Internal to certify/. Threads: pure.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace planewright {

// Separated by blanks and commas. Nothing if anything else is in it, or a number is not finite.
std::optional<std::vector<double>> svg_numbers(std::string_view text);

// "3210mm" in mm; px (and no unit) are CSS pixels, 96 to the inch. Nothing: no length, or a relative one.
std::optional<double> svg_length(std::string_view text);

// "translate(3 4) rotate(90)"; nothing: a function that we do not know.
std::optional<Eigen::Affine2d> svg_transform(std::string_view text);

struct SvgPiece {
  std::vector<Eigen::Vector2d> points;
  bool closed = false;
};
// The pieces of a path of M, L, H, V, Z (and their relative forms). Nothing: a curve, or no path at all.
std::optional<std::vector<SvgPiece>> svg_path(std::string_view text);

}  // namespace planewright
