// Small designs for the tests of the workshop, whose measures are known by hand.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <vector>

#include "core/workshop/workshop_model.h"

namespace planewright {

struct PanelDesign {
  Points points;
  Polygons panels;
};

inline std::shared_ptr<const WorkshopModel> model_of(const PanelDesign& design,
                                                     const WorkshopOptions& options = {}) {
  auto model = make_workshop_model(design.points, design.panels, options);
  EXPECT_TRUE(model) << (model ? std::string() : model.error().text());
  return model ? *model : nullptr;
}

inline WorkshopOptions in_unit(LengthUnit unit) {
  WorkshopOptions options;
  options.unit = unit;
  return options;
}

// The same design, given in mm, in another unit, as a file of that unit would have it.
inline PanelDesign converted(const PanelDesign& millimetres, LengthUnit unit) {
  return {millimetres.points / millimetres_per(unit), millimetres.panels};
}

// A cube of side 1 with a corner at 0. Panels: below, above, front (-y), back, left (-x), right; their
// normals point outwards, or inwards.
inline PanelDesign cube(bool outwards = true) {
  PanelDesign cube;
  cube.points.resize(8, 3);
  for (int i = 0; i < 8; ++i) cube.points.row(i) << (i & 1), (i >> 1 & 1), (i >> 2 & 1);
  const int sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& side : sides)
    cube.panels.push_back(outwards ? std::array{side[0], side[1], side[2], side[3]}
                                   : std::array{side[3], side[2], side[1], side[0]});
  return cube;
}

// A wall of rows x columns unit squares in the plane y = 0, outside towards -y; row by row from below, in
// each from -x to +x.
inline PanelDesign wall(int rows, int columns) {
  PanelDesign wall;
  wall.points.resize((rows + 1) * (columns + 1), 3);
  const auto at = [columns](int r, int c) { return r * (columns + 1) + c; };
  for (int r = 0; r <= rows; ++r)
    for (int c = 0; c <= columns; ++c) wall.points.row(at(r, c)) << c, 0, r;
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      wall.panels.push_back(std::array{at(r, c), at(r, c + 1), at(r + 1, c + 1), at(r + 1, c)});
  return wall;
}

// Each panel with corners of its own, in the plane z = 0.
inline PanelDesign flat_panels(const std::vector<std::vector<std::array<double, 2>>>& outlines) {
  PanelDesign design;
  std::vector<std::array<double, 2>> all;
  for (const auto& outline : outlines) {
    std::vector<int> corners;
    for (const auto& corner : outline) {
      corners.push_back(static_cast<int>(all.size()));
      all.push_back(corner);
    }
    design.panels.push_back(corners);
  }
  design.points.resize(static_cast<Eigen::Index>(all.size()), 3);
  for (size_t i = 0; i < all.size(); ++i)
    design.points.row(static_cast<Eigen::Index>(i)) << all[i][0], all[i][1], 0.0;
  return design;
}

}  // namespace planewright
