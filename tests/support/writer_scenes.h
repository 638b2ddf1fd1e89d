// A model, drawings and schedules by hand, for the tests of writers.
#pragma once

#include <cmath>
#include <memory>

#include "core/pattern/drawing.h"
#include "core/workshop/workshop_model.h"
#include "core/writers/schedule_writers.h"

namespace planewright::test {

// A cube of `size` mm with its lower corner at the origin's place; panels A-1, B-1 ... B-4, C-1.
inline WorkshopModel named_cube(double size = 1000.0, const Vector3d& origin = Vector3d::Zero()) {
  WorkshopModel model;
  model.title = "cube";
  model.origin = origin;
  model.points.resize(8, 3);
  for (int i = 0; i < 8; ++i) model.points.row(i) << (i & 1) * size, ((i >> 1) & 1) * size, (i >> 2) * size;
  model.panels = {{0, 2, 3, 1}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}, {4, 5, 7, 6}};
  model.normals.resize(6, 3);
  for (int p = 0; p < 6; ++p)
    model.normals.row(p) = newell_vector(model.points, model.panels[p]).normalized().transpose();
  model.names = {"A-1", "B-1", "B-2", "B-3", "B-4", "C-1"};
  model.numbers = {0, 1, 2, 3, 4, 7};
  return model;
}

// Every panel thickened to a prism inwards, by hand.
inline ThickPanels prisms(const WorkshopModel& model, double thickness) {
  ThickPanels solids;
  for (int p = 0; p < model.panel_count(); ++p) {
    ThickPanel solid;
    const auto panel = model.panels[p];
    const int n = static_cast<int>(panel.size());
    solid.panel = p;
    solid.outer = n;
    solid.points.resize(2 * n, 3);
    std::vector<int> outer, inner;
    for (int k = 0; k < n; ++k) {
      solid.points.row(k) = model.points.row(panel[k]);
      solid.points.row(n + k) = model.points.row(panel[k]) - thickness * model.normals.row(p);
      outer.push_back(k);
      inner.push_back(2 * n - 1 - k);
    }
    solid.faces.push_back(outer);
    solid.faces.push_back(inner);
    for (int k = 0; k < n; ++k) {
      const int next = (k + 1) % n;
      solid.faces.push_back(std::vector<int>{next, k, n + k, n + next});
    }
    solids.panels.push_back(std::move(solid));
  }
  return solids;
}

inline Contour regular_polygon(int corners, double radius, const Eigen::Vector2d& middle) {
  Contour contour(corners, 2);
  for (int k = 0; k < corners; ++k) {
    const double angle = 0.1 + 2.0 * M_PI * k / corners;
    contour.row(k) << middle.x() + radius * std::cos(angle), middle.y() + radius * std::sin(angle);
  }
  return contour;
}

// Hexagons in rows, each with name, edge names, an inner contour and an up mark, and the sheet's border.
inline Drawing hexagons(const WorkshopModel& model, int columns, double radius, const std::string& title) {
  Drawing drawing;
  drawing.title = title;
  const double step = 2.2 * radius;
  const int count = model.panel_count();
  drawing.width = columns * step;
  drawing.height = (count + columns - 1) / columns * step;
  Contour border(4, 2);
  border << 0, 0, drawing.width, 0, drawing.width, drawing.height, 0, drawing.height;
  drawing.lines.push_back({DrawingLayer::Sheet, border, true, -1});
  for (int p = 0; p < count; ++p) {
    const Eigen::Vector2d middle((p % columns + 0.5) * step, (p / columns + 0.5) * step);
    drawing.lines.push_back({DrawingLayer::Cut, regular_polygon(6, radius, middle), true, p});
    drawing.lines.push_back({DrawingLayer::Engrave, regular_polygon(6, 0.9 * radius, middle), true, p});
    const double h = 0.03 * radius;
    Contour mark(3, 2);
    mark << middle.x() + 2.6 * h, middle.y() - h / 2, middle.x() + 3 * h, middle.y() + h / 2,
        middle.x() + 3.4 * h, middle.y() - h / 2;
    drawing.lines.push_back({DrawingLayer::Engrave, mark, false, p});
    drawing.texts.push_back({DrawingLayer::Text, model.names[p], middle, h, 0.0, p, true});
    for (int k = 0; k < 6; ++k) {
      const double angle = 0.1 + M_PI / 6 + k * M_PI / 3;
      const Eigen::Vector2d at = middle + 0.7 * radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      drawing.texts.push_back(
          {DrawingLayer::Text, model.names[(p + k + 1) % count], at, 0.7 * h, angle - M_PI / 2, p, false});
    }
  }
  return drawing;
}

}  // namespace planewright::test
