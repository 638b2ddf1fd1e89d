#include "advice.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "core/advise/adopt.h"
#include "core/advise/advisor.h"
#include "core/design/design.h"
#include "core/design/layer_solve.h"
#include "core/diagnose/diagnosis.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/sample_shapes.h"
#include "core/solve/solver_choice.h"
#include "measurement.h"
#include "models.h"
#include "value_of.h"

namespace planewright::bench {
namespace {

constexpr double kGoalCorrelation = 0.8, kGoalSeconds = 20.0;
constexpr int kRings = 7;  // within which a full re-solve is compared: farther off it only rounds

struct AdviceOptions {
  std::string meshes;
  std::vector<std::string> models{"train-station", "aqua-center", "bunny1k"};
  int suggestions = 150, radius = planewright::AdviceOptions().radius;
  unsigned seed = 1;
  double offset = 0.0;  // mean panel edges
  bool demands = false;
};

Advised solved(const PolygonMesh& mesh, const AdviceOptions& options) {
  LayerSettings settings;
  settings.mode = suggested_mode(mesh);
  settings.offset = options.offset * value_of(build_complex(mesh, settings))->mean_edge;
  if (options.demands) settings.demands.list = {{"vertex"}, {"face"}, {"edge"}};
  const auto complex = value_of(build_complex(mesh, settings));
  const SolveReport report =
      value_of(solve_layer(*make_solver(SolverKind::Tangent), {complex, settings, {}, {}, {}},
                           start_state(*complex, settings), solve_options(settings), nullptr, {}));
  return {std::make_shared<PolygonMesh>(mesh),    complex, report.state, settings, {}, {},
          report.status == SolveStatus::Converged};
}

// Ranks, ties shared.
std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<int> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return values[a] < values[b]; });
  std::vector<double> out(values.size());
  for (size_t begin = 0; begin < order.size();) {
    size_t end = begin;
    while (end < order.size() && values[order[end]] == values[order[begin]]) ++end;
    for (size_t k = begin; k < end; ++k) out[order[k]] = 0.5 * static_cast<double>(begin + end - 1);
    begin = end;
  }
  return out;
}

double spearman(const std::vector<double>& a, const std::vector<double>& b) {
  const std::vector<double> ra = ranks(a), rb = ranks(b);
  const auto n = static_cast<double>(ra.size());
  const double mean = 0.5 * (n - 1.0);
  double ab = 0.0, aa = 0.0, bb = 0.0;
  for (size_t k = 0; k < ra.size(); ++k) {
    ab += (ra[k] - mean) * (rb[k] - mean);
    aa += (ra[k] - mean) * (ra[k] - mean);
    bb += (rb[k] - mean) * (rb[k] - mean);
  }
  return aa > 0.0 && bb > 0.0 ? ab / std::sqrt(aa * bb) : 0.0;
}

// Drop of the squared distance to the regular valences (6, at the border 4) by a flip or a join.
double valence_rule(const PolygonMesh& mesh, const Candidate& candidate) {
  const MeshEdge edge = mesh.edge(candidate.mesh_edge);
  const auto excess = [&](int v, int change) {
    const int wanted = mesh.is_border_vertex(v) ? 4 : 6;
    return std::pow(static_cast<double>(mesh.edges_around(v).size()) + change - wanted, 2);
  };
  double drop = 0.0;
  for (const int v : {edge.a, edge.b}) drop += excess(v, 0) - excess(v, -1);
  if (candidate.edit.kind != EditKind::Flip) return drop;
  for (const int face : {edge.left, edge.right})
    for (const int v : mesh.corners(face))
      if (v != edge.a && v != edge.b) drop += excess(v, 0) - excess(v, 1);
  return drop;
}

// Sum of the two angles opposite the edge: above 180 degrees a flip makes it Delaunay.
double delaunay_rule(const PolygonMesh& mesh, int e) {
  const MeshEdge edge = mesh.edge(e);
  double sum = 0.0;
  for (const int face : {edge.left, edge.right})
    for (const int v : mesh.corners(face))
      if (v != edge.a && v != edge.b) {
        const Vector3d a = (mesh.positions().row(edge.a) - mesh.positions().row(v)).normalized(),
                       b = (mesh.positions().row(edge.b) - mesh.positions().row(v)).normalized();
        sum += std::acos(std::clamp(a.dot(b), -1.0, 1.0));
      }
  return sum;
}

// B of the part of a design within kRings of the centre; E is position's alone.
double badness(const TangentComplex& complex, const State& state, const std::set<int>& vertices) {
  Region region;
  std::vector<char> near(static_cast<size_t>(complex.point_count()), 0);
  for (int i = 0; i < complex.plane_count(); ++i)
    if (vertices.contains(complex.plane_origin[static_cast<size_t>(i)])) {
      region.panels.push_back(i);
      for (const int j : complex.panels[i]) near[static_cast<size_t>(j)] = 1;
    }
  double energy = 0.0;
  for (int j = 0; j < complex.point_count(); ++j)
    if (near[static_cast<size_t>(j)]) {
      region.points.push_back(j);
      energy += (state.x.row(j) - complex.preferred.row(j)).squaredNorm();
    }
  for (size_t e = 0; e < complex.panel_edges.size(); ++e)
    if (near[static_cast<size_t>(complex.panel_edges[e].a)] &&
        near[static_cast<size_t>(complex.panel_edges[e].b)])
      region.panel_edges.push_back(static_cast<int>(e));
  Score score = defects_of(complex, state, region);
  score.energy = energy / (complex.mean_edge * complex.mean_edge);
  return total(score);
}

std::set<int> within_rings(const PolygonMesh& mesh, const std::vector<int>& centre, int rings) {
  std::set<int> all(centre.begin(), centre.end());
  std::vector<int> front = centre;
  for (int k = 0; k < rings; ++k) {
    std::vector<int> next;
    for (const int v : front)
      for (const int e : mesh.edges_around(v)) {
        const MeshEdge edge = mesh.edge(e);
        const int other = edge.a == v ? edge.b : edge.a;
        if (all.insert(other).second) next.push_back(other);
      }
    front = std::move(next);
  }
  return all;
}

// B round an edit's centre after the whole design has been solved again, from what a local solve found there.
double solved_again(const PatchSolver& patches, const Trial& trial, const PolygonMesh& mesh,
                    const ElementMap& map, const std::set<int>& round, Solver& solver) {
  const Advised& advised = patches.advised();
  auto complex = std::make_shared<TangentComplex>(*value_of(build_complex(mesh, advised.settings)));
  complex->mean_edge = advised.complex->mean_edge;
  const auto problem = value_of(build_problem(complex, advised.settings));
  SolveOptions options = solve_options(advised.settings);
  options.near_solution = true;
  const SolveReport report =
      solver.solve(*problem, adopt(advised, {trial}, *complex, map), options, nullptr, {});
  return badness(*complex, report.state, round);
}

// The gain of an edit after a full re-solve from what the local solve found.
double real_gain(const PatchSolver& patches, const Candidate& candidate, const Trial& with, Solver& solver) {
  const PolygonMesh& mesh = *patches.advised().mesh;
  const std::set<int> round = within_rings(mesh, candidate.centre, kRings);  // a flip keeps vertices
  const EditedMesh edited = value_of(apply(mesh, candidate.edit));
  const double before = badness(*patches.advised().complex, patches.advised().state, round);
  return before - solved_again(patches, with, edited.mesh, edited.map, round, solver);
}

void measure(const std::string& name, const PolygonMesh& mesh, const AdviceOptions& options) {
  const Advised advised = solved(mesh, options);
  const PatchSolver patches = value_of(PatchSolver::create(advised));
  std::vector<Candidate> drawn = find_candidates(advised, diagnose(*advised.complex, advised.state).findings);
  std::mt19937 lot(options.seed);
  std::shuffle(drawn.begin(), drawn.end(), lot);
  drawn.resize(std::min(drawn.size(), static_cast<size_t>(options.suggestions)));
  std::vector<double> predicted, real, valence, delaunay, shortness;
  double local = 0.0;
  int right = 0, clear = 0, unmet = 0;
  const auto solver = make_solver(SolverKind::Tangent);
  for (const Candidate& candidate : drawn) {
    const double begun = cpu_seconds();
    const auto ground = patches.prepare(candidate.centre, options.radius);
    if (!ground) continue;
    const auto trial = patches.attempt(*ground, candidate.edit);
    local += cpu_seconds() - begun;
    if (!trial) continue;
    unmet += !trial->met;
    const double gain = total(ground->as_it_is.score) - total(trial->score);
    const double truth = real_gain(patches, candidate, *trial, *solver);
    predicted.push_back(gain);
    real.push_back(truth);
    valence.push_back(valence_rule(mesh, candidate));
    delaunay.push_back(delaunay_rule(mesh, candidate.mesh_edge));
    shortness.push_back(-candidate.urgency);
    if (std::abs(truth) > 0.1) {
      ++clear;
      right += (truth > 0.0) == (gain > 0.0);
    }
  }
  const double r = spearman(predicted, real);
  std::printf("%-16s %5zu %9.2f %8.2f %9.2f %7.2f %6d/%-4d %5d %8.2f  %s\n", name.c_str(), real.size(), r,
              spearman(valence, real), spearman(delaunay, real), spearman(shortness, real), right, clear,
              unmet, 1e3 * local / static_cast<double>(std::max<size_t>(real.size(), 1)),
              r >= kGoalCorrelation ? "met" : "MISSED");
  std::fflush(stdout);
}

void measure_cost() {
  AdviceOptions options;
  const PolygonMesh mesh = value_of(make_sample("train-station-unsymmetric", 10000));
  const Advised advised = solved(mesh, options);
  const Diagnosis diagnosis = diagnose(*advised.complex, advised.state);
  const PatchSolver patches = value_of(PatchSolver::create(advised));
  const auto candidates = find_candidates(advised, diagnosis.findings);
  const double begun = cpu_seconds();
  const auto suggestions = rate(patches, candidates);
  const double seconds = cpu_seconds() - begun;
  std::printf(
      "\n%d panels, %zu findings: %zu candidates rated in %.1f s CPU (<= %.0f s): %s; %zu gain 0.1 or more\n",
      advised.complex->plane_count(), diagnosis.findings.size(), candidates.size(), seconds, kGoalSeconds,
      seconds <= kGoalSeconds ? "met" : "MISSED", suggestions.size());
}

void run(const AdviceOptions& options) {
  std::printf(
      "Candidates drawn by lot (seed %u): rank correlation (Spearman) of what is predicted with the gain "
      "after a\n"
      "full re-solve within %d rings; the same of plain rules; right: predictions\n"
      "with the right sign where the gain is clear (> 0.1); unmet: local solves that missed a row; ms: CPU "
      "of a\n"
      "local solve with and without the edit, radius %d. Goal: >= %.1f.\n\n"
      "                 flips predicted  valence  Delaunay   short       right unmet       ms\n",
      options.seed, kRings, options.radius, kGoalCorrelation);
  for (const std::string& model : options.models) {
    const std::filesystem::path file = meshes_folder(options.meshes) / "tri";
    std::filesystem::path found;
    for (const char* ending : {".off", ".obj"})
      if (std::filesystem::exists(file / (model + ending))) found = file / (model + ending);
    if (found.empty()) {
      std::printf("%-16s SKIPPED: not in %s\n", model.c_str(), file.string().c_str());
      continue;
    }
    measure(model, value_of(load_mesh(found.string())).mesh, options);
  }
  measure_cost();
}

}  // namespace

void declare_advice(CLI::App& app) {
  auto options = std::make_shared<AdviceOptions>();
  CLI::App* command =
      app.add_subcommand("advice", "Predicted against real gains of edits, and what they cost");
  command->add_option("--models", options->models, "Names of triangle meshes in the folder's tri/");
  command->add_option(
      "--meshes", options->meshes,
      "Folder of the real meshes (default: $PLANEWRIGHT_MESHES, else shared/meshes near the source)");
  command->add_option("--flips", options->suggestions, "Flips per mesh")->check(CLI::Range(10, 100000));
  command->add_option("--radius", options->radius, "Rings that are solved")->check(CLI::Range(1, 6));
  command->add_option("--seed", options->seed, "Of the draw");
  command->add_option("--offset", options->offset, "Mean panel edges");
  command->add_flag("--demands", options->demands, "With the vertex, face and edge constraints");
  command->callback([options] { run(*options); });
}

}  // namespace planewright::bench
