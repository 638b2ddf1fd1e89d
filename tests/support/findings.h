// A state and what detectors want of it, for the tests of diagnose/. In flat grids every point may move
// within the plane, and the state stays one whose panels are planar.
#pragma once

#include <algorithm>
#include <vector>

#include "core/diagnose/finding.h"
#include "core/diagnose/subject.h"
#include "support/complexes.h"

namespace planewright::test {

struct Scene {
  explicit Scene(SharedComplex of) : complex(std::move(of)), state(initial_state(*complex)), mesh(*complex) {}
  // columns x rows unit quads: panel y * columns + x, point y * (columns + 1) + x.
  static Scene flat_grid(int columns, int rows) { return Scene(planarize_of(grid(columns, rows).mesh())); }

  // x, y: in the plane of a flat grid, absolute.
  void put(int point, double x, double y) {
    state.x.row(point) = (Vector3d(x, y, 0) - complex->origin).transpose();
  }
  Subject subject() const { return {*complex, state, mesh}; }
  int panel_edge(int a, int b) const {
    for (size_t e = 0; e < complex->panel_edges.size(); ++e)
      if (std::minmax(complex->panel_edges[e].a, complex->panel_edges[e].b) == std::minmax(a, b))
        return static_cast<int>(e);
    return -1;
  }

  SharedComplex complex;
  State state;
  MeshPlaces mesh;
};

inline std::vector<int> indices_of(const std::vector<Finding>& findings) {
  std::vector<int> indices;
  for (const Finding& finding : findings) indices.push_back(finding.element.index);
  return indices;
}

// Severity lies on the scale of its kind, the cause is told, and the unit is the kind's.
inline void expect_well_formed(const Finding& finding) {
  const FindingKindInfo& of = info(finding.kind);
  EXPECT_GE(finding.severity, of.least_severity) << of.name;
  EXPECT_LE(finding.severity, of.most_severity) << of.name;
  EXPECT_EQ(finding.unit, of.unit);
  EXPECT_FALSE(finding.cause.empty()) << of.name;
  EXPECT_TRUE(finding.place.allFinite()) << of.name;
  EXPECT_TRUE(std::is_sorted(finding.mesh_edges.begin(), finding.mesh_edges.end())) << of.name;
}

}  // namespace planewright::test
