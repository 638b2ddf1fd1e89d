// Solved designs that advice is asked about, for the tests of advise/ and export/.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "core/advise/patch_solver.h"
#include "core/design/design.h"
#include "core/design/layer_solve.h"
#include "core/mesh/sample_shapes.h"
#include "core/solve/solver_choice.h"

namespace planewright::test {

inline LayerSettings planarizing() {
  LayerSettings settings;
  settings.mode = ComplexKind::Planarize;
  return settings;
}

inline Advised solved(const PolygonMesh& mesh, const LayerSettings& settings = {},
                      std::vector<Selection> selections = {}) {
  const auto complex = build_complex(mesh, settings).value();
  const auto solver = make_solver(SolverKind::Tangent);
  const SolveReport report =
      solve_layer(*solver, {complex, settings, selections, {}, {}}, start_state(*complex, settings),
                  solve_options(settings), nullptr, {})
          .value();
  return {std::make_shared<PolygonMesh>(mesh), complex, report.state, settings, std::move(selections)};
}

// As the builder leaves it: enough for what looks at the mesh alone.
inline Advised unsolved(const PolygonMesh& mesh, const LayerSettings& settings = {}) {
  const auto complex = build_complex(mesh, settings).value();
  return {std::make_shared<PolygonMesh>(mesh), complex, initial_state(*complex), settings};
}

// A dome whose edge `edge` runs the wrong way.
struct BadDome {
  PolygonMesh mesh = make_sample("dome", 200).value();
  int edge = -1;

  BadDome() {
    for (int e = 0; e < mesh.edge_count() && edge < 0; ++e) {
      const MeshEdge ends = mesh.edge(e);
      if (ends.border() || mesh.is_border_vertex(ends.a) || mesh.is_border_vertex(ends.b)) continue;
      if (mesh.positions().row(ends.a).head<2>().norm() > 3.0 || !mesh.can_flip(e)) continue;
      if (mesh.edges_around(ends.a).size() == 6 && mesh.edges_around(ends.b).size() == 6) edge = e;
    }
    mesh.flip(edge);
  }
};

}  // namespace planewright::test
