// A project in which nothing is as it begins, and the comparison of two, bit for bit.
#pragma once

#include <gtest/gtest.h>

#include <numbers>

#include "core/design/design.h"
#include "core/edit/project.h"
#include "core/mesh/sample_shapes.h"
#include "core/problem/demands/demand_catalogue.h"
#include "core/problem/energies/energy_catalogue.h"

namespace planewright::test {

inline constexpr double kThird = 1.0 / 3.0;

inline Layer busy_layer() {
  Layer layer;
  layer.name = "outer \"skin\" é";
  layer.visible = false;
  layer.thickness = -0.1;
  LayerSettings& settings = layer.settings;
  settings.offset = kThird;
  settings.freedom = Freedom::Normals;
  settings.side = Side::Inside;
  settings.no_penetration = true;
  settings.max_iterations = 77;
  settings.tolerance = 1e-5 * std::numbers::pi;
  settings.weights.clear();
  for (const auto& energy : energy_catalogue()) settings.weights[energy.name] = kThird * 1e-300;
  for (const DemandInfo& info : demand_catalogue()) {
    Demand demand{info.name, settings.demands.list.size() % 2 == 0, "roof", {}};
    for (const DemandParameter& parameter : info.parameters)
      demand.values.push_back(parameter.default_value + kThird);
    settings.demands.list.push_back(std::move(demand));
  }
  settings.demands.pins = {{{PointKind::Face, 3}, {0.1, std::nullopt, -0.0}},
                           {{PointKind::BorderEdge, 2}, {std::nullopt, 1e-310, std::nullopt}},
                           {{PointKind::Corner, 1}, {1.0, 2.0, 3.0}},
                           {{PointKind::Vertex, 0}, {1e300, kThird, 0.1 + 0.2}}};
  settings.demands.plane_pins = {{4, std::nullopt},
                                 {5, PlanePin::Equation{{0.0, kThird, -1.0}, 1.7976931348623157e308}}};
  settings.demands.waived = {{"edge", {ElementKind::PanelEdge, 3}},
                             {"face", {ElementKind::Panel, 2}},
                             {"vertex", {ElementKind::Point, 1}}};
  settings.demands.margin = 0.1 + 0.2;
  return layer;
}

// A state of a layer's complex that no solve would make twice.
inline State some_state(const PolygonMesh& mesh, const LayerSettings& settings) {
  const auto complex = build_complex(mesh, settings).value();
  State state = initial_state(*complex);
  state.x *= 1.0 + kThird * 1e-3;
  state.h.array() += kThird;
  return state;
}

inline Project busy_project() {
  Design design;
  design.layers = {busy_layer(), Layer{}, Layer{}};
  design.layers[1].settings.mode = ComplexKind::Planarize;
  design.layers[2].settings.border = BorderPolicy::Interior;
  design.layers[2].coplanar_with = 1;
  design.selections = {{"roof", {0, 2, 5}, {1}, {3, 4}}, {"rim", {}, {7, 9}, {}}};
  design.reference = "/tmp/reference surface.obj";
  Project project = new_project("roof \\ station", make_sample("dome", 40).value(), std::move(design));
  project.contract.unit = LengthUnit::Inch;
  project.contract.thickness = 6.35;
  project.contract.gap = kThird;
  project.contract.density = 2500.0;
  project.contract.names = NameStyle::Plain;
  project.contract.tolerances = {
      0.25, kThird, 50.0, 2400.0, 0.1, 3.5, 30.0, 150.0, 120.0, 240.0, SheetSize{3210.0, 6000.0}};
  project.given_names[{ComplexKind::Dual, BorderPolicy::Closed}] = {{0, "A-1"}, {7, "B-2"}};
  project.given_names[{ComplexKind::Dual, BorderPolicy::Interior}] = {{3, "A-1"}};
  project.given_names[{ComplexKind::Planarize, BorderPolicy::Closed}] = {{12, "x_1.y"}};
  project.solved = {some_state(project.mesh, project.design.layers[0].settings), std::nullopt,
                    some_state(project.mesh, project.design.layers[2].settings)};
  return project;
}

inline void expect_same_mesh(const PolygonMesh& a, const PolygonMesh& b) {
  EXPECT_EQ(a.positions(), b.positions());
  EXPECT_EQ(a.faces(), b.faces());
  ASSERT_EQ(a.edge_count(), b.edge_count());
  for (int e = 0; e < a.edge_count(); ++e) {
    const MeshEdge x = a.edge(e), y = b.edge(e);
    EXPECT_TRUE(x.a == y.a && x.b == y.b && x.left == y.left && x.right == y.right) << "edge " << e;
  }
}

inline void expect_same_project(const Project& a, const Project& b) {
  EXPECT_EQ(a.name, b.name);
  expect_same_mesh(a.mesh, b.mesh);
  EXPECT_EQ(a.design, b.design);
  EXPECT_EQ(a.contract, b.contract);
  EXPECT_EQ(a.names, b.names);
  EXPECT_EQ(a.given_names, b.given_names);
  ASSERT_EQ(a.solved.size(), b.solved.size());
  for (std::size_t k = 0; k < a.solved.size(); ++k) {
    ASSERT_EQ(a.solved[k].has_value(), b.solved[k].has_value()) << "layer " << k;
    if (!a.solved[k]) continue;
    EXPECT_EQ(a.solved[k]->x, b.solved[k]->x);
    EXPECT_EQ(a.solved[k]->n, b.solved[k]->n);
    EXPECT_EQ(a.solved[k]->h, b.solved[k]->h);
  }
}

}  // namespace planewright::test
