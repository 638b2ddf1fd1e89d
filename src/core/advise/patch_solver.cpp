#include "core/advise/patch_solver.h"

#include <Eigen/QR>
#include <algorithm>

#include "core/design/design.h"
#include "core/edit/remap.h"
#include "core/solve/augmented_lagrangian.h"
#include "core/solve/demand_projection.h"
#include "core/solve/planar_frames.h"
#include "core/solve/primal_dual_newton.h"

namespace planewright {
namespace {

constexpr int kSoftSteps = 20, kNewtonSteps = 40, kProjectionSteps = 25;
constexpr double kFirstOrder = 1e-3;  // slope at which a local solve ends
constexpr double kMostPenalty = 3e3;
constexpr double kOnPlane = 1e-9, kNear = 1.0;  // mean edges

// Points whose planes changed start where these meet, if that is near where they are wanted.
void intersect_new_points(const TangentComplex& complex, const std::vector<char>& free_points, State& state) {
  for (int j = 0; j < complex.point_count(); ++j) {
    if (!free_points[static_cast<size_t>(j)]) continue;
    const auto planes = complex.planes_of_point[j];
    Eigen::MatrixXd normals(static_cast<Eigen::Index>(planes.size()), 3);
    Vector miss(normals.rows());
    for (size_t k = 0; k < planes.size(); ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      normals.row(row) = state.n.row(planes[k]);
      miss[row] =
          state.h[planes[k]] - state.n.row(planes[k]).dot(state.x.row(j) - complex.anchors.row(planes[k]));
    }
    if (miss.lpNorm<Eigen::Infinity>() <= kOnPlane * complex.mean_edge) continue;
    const Vector3d moved = state.x.row(j).transpose() + normals.completeOrthogonalDecomposition().solve(miss);
    if ((moved - complex.preferred.row(j).transpose()).norm() <= kNear * complex.mean_edge)
      state.x.row(j) = moved;
  }
}

std::vector<char> points_of_planes(const TangentComplex& complex, const std::vector<char>& planes) {
  std::vector<char> points(static_cast<size_t>(complex.point_count()), 0);
  for (int j = 0; j < complex.point_count(); ++j)
    for (const int i : complex.planes_of_point[j])
      if (planes[static_cast<size_t>(i)]) points[static_cast<size_t>(j)] = 1;
  return points;
}

Region region_of(const TangentComplex& complex, const std::vector<char>& planes,
                 const std::vector<char>& points) {
  Region region;
  for (int j = 0; j < complex.point_count(); ++j)
    if (points[static_cast<size_t>(j)]) region.points.push_back(j);
  for (int i = 0; i < complex.plane_count(); ++i)
    if (planes[static_cast<size_t>(i)]) region.panels.push_back(i);
  for (size_t e = 0; e < complex.panel_edges.size(); ++e)
    if (points[static_cast<size_t>(complex.panel_edges[e].a)] &&
        points[static_cast<size_t>(complex.panel_edges[e].b)])
      region.panel_edges.push_back(static_cast<int>(e));
  return region;
}

// The way of a full re-solve from nearby: onto all rows, Newton steps, onto all rows again. Where the rows
// are not met from here, softly held ones find their way first. Whether they are met at the end.
bool minimise(const Problem& problem, Vector& z, TangentCache& cache, const std::stop_token& stop) {
  Vector projected = z;
  if (!project_onto_demands(problem, projected, kProjectionSteps, stop, &cache, kFrameTarget).met) {
    AugmentedLagrangianOptions soft;
    soft.max_steps = kSoftSteps;
    soft.most_penalty = kMostPenalty;
    soft.cache = &cache;
    minimise_augmented_lagrangian(problem, z, soft, stop);
    projected = z;
    if (!project_onto_demands(problem, projected, kProjectionSteps, stop, &cache, kFrameTarget).met) {
      z = std::move(projected);
      return false;
    }
  }
  z = projected;
  NewtonOptions options;
  options.max_steps = kNewtonSteps;
  options.begin_gauss_newton = true;
  options.first_order = kFirstOrder;
  PlanarFrames nobody_looks(problem, nullptr, cache, stop);
  Vector multipliers = Vector::Zero(problem.rows());
  minimise_primal_dual(problem, z, multipliers, options, cache, nobody_looks, stop);
  if (project_onto_demands(problem, z, kProjectionSteps, stop, &cache, kFrameTarget).met) return true;
  z = std::move(projected);
  return true;
}

Result<std::shared_ptr<const TangentComplex>> build(const PolygonMesh& mesh, const LayerSettings& settings,
                                                    double mean_edge) {
  auto built = build_complex(mesh, settings);
  if (!built) return built;
  auto complex = std::make_shared<TangentComplex>(**built);
  complex->mean_edge = mean_edge;  // one unit for the patch and the whole
  return std::shared_ptr<const TangentComplex>(std::move(complex));
}

// Free planes of a complex, from the rings of the unedited patch: what is new lies in the middle of it.
std::vector<char> free_planes(const TangentComplex& complex, const PolygonMesh& mesh, const Patch& patch,
                              const ElementMap* edited, int radius) {
  const auto ring = [&](int vertex) {
    const int before = edited ? edited->vertices.to_old[static_cast<size_t>(vertex)] : vertex;
    return before < 0 ? 0 : patch.rings[static_cast<size_t>(before)];
  };
  std::vector<char> planes(static_cast<size_t>(complex.plane_count()), 0);
  for (int i = 0; i < complex.plane_count(); ++i) {
    const int origin = complex.plane_origin[static_cast<size_t>(i)];
    int nearest = radius;
    if (complex.kind == ComplexKind::Dual)
      nearest = ring(origin);
    else
      for (const int v : mesh.corners(origin)) nearest = std::min(nearest, ring(v));
    planes[static_cast<size_t>(i)] = nearest < radius;
  }
  return planes;
}

}  // namespace

Result<PatchSolver> PatchSolver::create(Advised advised) {
  if (advised.complex->kind == ComplexKind::Cluster)
    return fail(ErrorCode::Refused, "edits of the mesh are not rated for panels of clusters", "mode",
                "Merge, split or paint regions instead");
  PatchSolver solver;
  FrozenGeometry frozen{&advised.state, advised.reference, nullptr, {}};
  const auto whole = build_problem(advised.complex, advised.settings, advised.selections, frozen);
  if (!whole) return tl::unexpected(whole.error());
  solver.factors_ = (*whole)->energy_factors();
  const TangentComplex& complex = *advised.complex;
  const PolygonMesh& mesh = *advised.mesh;
  solver.plane_of_origin_.assign(static_cast<size_t>(std::max(mesh.vertex_count(), mesh.face_count())), -1);
  for (int i = 0; i < complex.plane_count(); ++i)
    solver.plane_of_origin_[static_cast<size_t>(complex.plane_origin[static_cast<size_t>(i)])] = i;
  solver.point_of_face_.assign(static_cast<size_t>(mesh.face_count()), -1);
  solver.point_of_edge_.assign(static_cast<size_t>(mesh.edge_count()), -1);
  solver.point_of_vertex_.assign(static_cast<size_t>(mesh.vertex_count()), -1);
  for (int j = 0; j < complex.point_count(); ++j) {
    const PointOrigin origin = complex.point_origin[static_cast<size_t>(j)];
    auto& list = origin.kind == PointKind::Face         ? solver.point_of_face_
                 : origin.kind == PointKind::BorderEdge ? solver.point_of_edge_
                                                        : solver.point_of_vertex_;
    list[static_cast<size_t>(origin.element)] = j;
  }
  const Demands& demands = advised.settings.demands;
  solver.remaps_ = !advised.selections.empty() || !demands.pins.empty() || !demands.plane_pins.empty() ||
                   !demands.waived.empty();
  solver.advised_ = std::move(advised);
  return solver;
}

State PatchSolver::state_on(const TangentComplex& patch, const ElementMap& from_whole) const {
  State state = initial_state(patch);
  const TangentComplex& whole = *advised_.complex;
  const Vector3d shift = whole.origin - patch.origin;
  const IndexMap& planes = whole.kind == ComplexKind::Dual ? from_whole.vertices : from_whole.faces;
  for (int i = 0; i < patch.plane_count(); ++i) {
    const int origin = planes.to_old[static_cast<size_t>(patch.plane_origin[static_cast<size_t>(i)])];
    const int k = plane_of_origin_[static_cast<size_t>(origin)];
    if (k < 0) continue;  // a border vertex of the whole that has no plane there
    state.n.row(i) = advised_.state.n.row(k);
    state.h[i] = advised_.state.h[k];
  }
  for (int j = 0; j < patch.point_count(); ++j) {
    const PointOrigin origin = patch.point_origin[static_cast<size_t>(j)];
    const auto element = static_cast<size_t>(origin.element);
    int k = -1;
    switch (origin.kind) {
      case PointKind::Face:
        k = point_of_face_[static_cast<size_t>(from_whole.faces.to_old[element])];
        break;
      case PointKind::BorderEdge:
        k = point_of_edge_[static_cast<size_t>(from_whole.edges.to_old[element])];
        break;
      case PointKind::Corner:
      case PointKind::Vertex:
        k = point_of_vertex_[static_cast<size_t>(from_whole.vertices.to_old[element])];
        break;
    }
    // The rim of the patch has points that the whole has not; they are held anywhere.
    if (k >= 0) state.x.row(j) = advised_.state.x.row(k) + shift.transpose();
  }
  return state;
}

Result<PatchSolver::Ground> PatchSolver::prepare(const std::vector<int>& centre, int radius,
                                                 std::stop_token stop) const {
  auto patch = cut_patch(*advised_.mesh, centre, radius);
  if (!patch) return tl::unexpected(patch.error());
  auto complex = build(patch->mesh, advised_.settings, advised_.complex->mean_edge);
  if (!complex) return tl::unexpected(complex.error());
  Ground ground;
  ground.patch = std::move(*patch);
  ground.complex = *complex;
  ground.state = state_on(*ground.complex, ground.patch.from_whole);
  auto as_it_is = solve(ground.complex, ground.state, ground.patch.mesh, ground.patch.from_whole,
                        free_planes(*ground.complex, ground.patch.mesh, ground.patch, nullptr, radius),
                        !advised_.converged, stop);
  if (!as_it_is) return tl::unexpected(as_it_is.error());
  ground.as_it_is = std::move(*as_it_is);
  return ground;
}

Result<Trial> PatchSolver::attempt(const Ground& ground, const MeshEdit& edit, std::stop_token stop) const {
  const ElementMap& map = ground.patch.from_whole;
  auto edited = apply(ground.patch.mesh, renumbered(edit, map));
  if (!edited) return tl::unexpected(edited.error());
  auto complex = build(edited->mesh, advised_.settings, advised_.complex->mean_edge);
  if (!complex) return tl::unexpected(complex.error());
  State state = transfer(*ground.complex, ground.state, **complex, &edited->map);
  const auto planes = free_planes(**complex, edited->mesh, ground.patch, &edited->map, ground.patch.radius);
  intersect_new_points(**complex, points_of_planes(**complex, planes), state);
  return solve(*complex, std::move(state), edited->mesh, composed(map, edited->map), planes, true, stop);
}

Result<Trial> PatchSolver::solve(std::shared_ptr<const TangentComplex> complex, State state,
                                 const PolygonMesh& mesh, const ElementMap& from_whole,
                                 const std::vector<char>& planes, bool steps,
                                 const std::stop_token& stop) const {
  LayerSettings settings = advised_.settings;
  std::vector<Selection> selections;
  if (remaps_) {
    Design design;
    design.layers.front().settings = settings;
    design.selections = advised_.selections;
    design = remapped(std::move(design), from_whole, *advised_.mesh, mesh).design;
    settings = design.layers.front().settings;
    selections = std::move(design.selections);
  }
  const std::vector<char> points = points_of_planes(*complex, planes);
  ProblemSettings local{settings.freedom, settings.weights, settings.demands, selections,
                        settings.side_sign()};
  for (const char free : points) local.outside.push_back(!free);
  for (const char free : planes) local.outside.push_back(!free);
  local.factors = factors_;
  const FrozenGeometry frozen{&state, advised_.reference, nullptr, {}};
  const auto problem = Problem::create(complex, local, frozen);
  if (!problem) return tl::unexpected(problem.error());

  Vector z = (*problem)->from_state(state);
  Trial trial;
  trial.met = true;
  if (steps) {
    TangentCache cache;
    trial.met = minimise(**problem, z, cache, stop);
    state = (*problem)->to_state({z.data(), static_cast<size_t>(z.size())});
  }
  const Region region = region_of(*complex, planes, points);
  trial.score = defects_of(*complex, state, region);
  trial.score.energy = (*problem)->objective(z.data());
  trial.state = std::move(state);
  trial.complex = std::move(complex);
  trial.from_whole = from_whole;
  trial.free_planes = planes;
  trial.free_points = points;
  return trial;
}

}  // namespace planewright
