#include "core/design/design.h"

#include "core/complex/cluster.h"
#include "core/complex/planarize.h"

namespace planewright {

ComplexKind suggested_mode(const PolygonMesh& mesh) {
  const Polygons faces = mesh.faces();
  int triangles = 0;
  for (int f = 0; f < faces.size(); ++f) triangles += faces.valence(f) == 3;
  return 2 * triangles > faces.size() ? ComplexKind::Dual : ComplexKind::Planarize;
}

Result<std::shared_ptr<const TangentComplex>> build_complex(const PolygonMesh& mesh,
                                                            const LayerSettings& settings,
                                                            const Regions* regions) {
  const auto share = [](TangentComplex&& complex) {
    return std::make_shared<const TangentComplex>(std::move(complex));
  };
  switch (settings.mode) {
    case ComplexKind::Planarize:
      return build_planarize(mesh, {settings.offset}).map(share);
    case ComplexKind::Cluster:
      if (!regions)
        return fail(ErrorCode::Usage, "panels of clusters need a clustering of the mesh", "mode",
                    "Cluster the mesh first");
      return build_cluster(mesh, *regions, {settings.offset}).map(share);
    case ComplexKind::Dual:
      break;
  }
  return build_dual(mesh, {settings.offset, settings.border}).map(share);
}

bool same_complex(const LayerSettings& a, const LayerSettings& b) {
  return a.mode == b.mode && a.offset == b.offset && a.border == b.border;
}

Result<std::shared_ptr<const Problem>> build_problem(std::shared_ptr<const TangentComplex> complex,
                                                     const LayerSettings& settings,
                                                     const std::vector<Selection>& selections,
                                                     const FrozenGeometry& frozen) {
  return Problem::create(
      std::move(complex),
      {settings.freedom, settings.weights, settings.demands, selections, settings.side_sign()}, frozen);
}

State start_state(const TangentComplex& complex, const LayerSettings& settings,
                  const TangentComplex* warm_complex, const State* warm, const ElementMap* edited) {
  State state =
      warm && warm_complex ? transfer(*warm_complex, *warm, complex, edited) : initial_state(complex);
  if (settings.freedom == Freedom::Fixed) state.n = complex.normals;
  if (settings.freedom != Freedom::NormalsAndOffsets) state.h = complex.offsets;
  return state;
}

SolveOptions solve_options(const LayerSettings& settings) {
  SolveOptions options;
  options.max_iterations = settings.max_iterations;
  options.tolerance = settings.tolerance;
  return options;
}

}  // namespace planewright
