// The way from a mesh and a designer's settings to what a solver takes: the steps that layer_solve.h, the
// window's session, the command line, tests and benchmarks share.
#pragma once

#include <memory>

#include "core/base/result.h"
#include "core/design/layer_settings.h"
#include "core/mesh/polygon_mesh.h"
#include "core/problem/problem.h"
#include "core/solve/solver.h"

namespace planewright {

struct Regions;

// What a mesh is most likely meant for: its dual if most faces are triangles (they are planar as they are),
// else its own faces made planar.
ComplexKind suggested_mode(const PolygonMesh& mesh);

// Builds the complex that settings.mode names. regions: those of the mesh, for ComplexKind::Cluster. Fails as
// the builders do; ErrorCode::Usage for clusters without regions.
Result<std::shared_ptr<const TangentComplex>> build_complex(const PolygonMesh& mesh,
                                                            const LayerSettings& settings,
                                                            const Regions* regions = nullptr);

// Whether both settings lead to the same complex for one mesh (and the same regions of it), so that it need
// not be built again.
bool same_complex(const LayerSettings& a, const LayerSettings& b);

// Fails as Problem::create does. selections: those that the demands name.
Result<std::shared_ptr<const Problem>> build_problem(std::shared_ptr<const TangentComplex> complex,
                                                     const LayerSettings& settings,
                                                     const std::vector<Selection>& selections = {},
                                                     const FrozenGeometry& frozen = {});

// The builder's own start, or (warm not null) what another state of the same mesh, or (edited not null, see
// transfer()) of the mesh that was edited to it, gives for this complex. Planes and offsets that the settings
// hold fixed are always the builder's.
State start_state(const TangentComplex& complex, const LayerSettings& settings,
                  const TangentComplex* warm_complex = nullptr, const State* warm = nullptr,
                  const ElementMap* edited = nullptr);

SolveOptions solve_options(const LayerSettings& settings);

}  // namespace planewright
