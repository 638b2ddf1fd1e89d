#include "core/advise/improve.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>

#include "core/advise/adopt.h"
#include "core/advise/edit_plan.h"
#include "core/design/design.h"
#include "core/edit/element_names.h"
#include "core/edit/remap.h"

namespace planewright {
namespace {

// A fall of B that counts; below it rounding decides.
constexpr double kLeastFall = 1e-3;
// What cannot be built is worth an edit that hardly gains.
constexpr double kLeastGainOfLastResort = 0.01;

// An edit by what it is done to, whatever the indices are by now.
using EditKey = std::tuple<EditKind, int, int>;

EditKey key_of(const MeshEdit& edit, const PolygonMesh& mesh, const ElementIds& ids) {
  const auto vertex = [&](int v) { return ids.vertices[static_cast<size_t>(v)]; };
  if (edit.kind == EditKind::MoveVertex) return {edit.kind, vertex(edit.element), -1};
  const MeshEdge edge = mesh.edge(edit.element);  // all other candidates are edits of edges
  return {edit.kind, std::min(vertex(edge.a), vertex(edge.b)), std::max(vertex(edge.a), vertex(edge.b))};
}

// "Flip edge 1042" by the numbers that elements keep.
std::string named(MeshEdit edit, const ElementIds& ids) {
  const std::vector<int>& numbers = edit.kind == EditKind::MoveVertex ? ids.vertices : ids.edges;
  edit.element = numbers[static_cast<size_t>(edit.element)];
  return describe(edit);
}

// Degrees, least of the inner vertices at these edges; 0 where there is none.
double least_angle_defect(const PolygonMesh& mesh, const std::vector<int>& edges) {
  std::set<int> vertices;
  for (const int e : edges)
    for (const int v : {mesh.edge(e).a, mesh.edge(e).b})
      if (!mesh.is_border_vertex(v)) vertices.insert(v);
  double least = vertices.empty() ? 0.0 : std::numeric_limits<double>::infinity();
  for (const int v : vertices) {
    double defect = 360.0;
    for (const int face : mesh.faces_around(v)) {
      const std::vector<int> corners = mesh.corners(face);
      const size_t at = static_cast<size_t>(std::find(corners.begin(), corners.end(), v) - corners.begin());
      const auto side = [&](size_t k) {
        return Vector3d(mesh.positions().row(corners[k % corners.size()]) - mesh.positions().row(v));
      };
      const Vector3d a = side(at + 1), b = side(at + corners.size() - 1);
      defect -= std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / std::numbers::pi;
    }
    least = std::min(least, defect);
  }
  return least;
}

class Improver {
 public:
  Improver(Solver& solver, const ImproveOptions& options, ImproveObserver* observer, std::stop_token stop)
      : solver_(solver), options_(options), observer_(observer), stop_(std::move(stop)) {
    options_.solve.near_solution = true;
  }

  Result<ImproveReport> run(const Advised& solved) {
    numbering_ = ElementNumbering(*solved.mesh);
    now_.design = solved;
    now_.ids = numbering_.opened();
    now_.map = identity_map(*solved.mesh);
    if (auto measured = measure(now_); !measured) return tl::unexpected(measured.error());
    report_.before = now_.measure;
    for (const bool last_resort : {false, true})
      while (edits_left() > 0 && !stop_.stop_requested()) {
        const auto helped = round(last_resort);
        if (!helped) return tl::unexpected(helped.error());
        if (!*helped) break;
      }
    report_.after = now_.measure;
    if (!stop_.stop_requested())
      if (auto listed = list_what_is_left(); !listed) return tl::unexpected(listed.error());
    report_.stopped = stop_.stop_requested();
    report_.design = std::move(now_.design);
    report_.map = std::move(now_.map);
    return std::move(report_);
  }

 private:
  // A design on the way.
  struct Stage {
    Advised design;
    ElementIds ids;
    ElementMap map;  // from the mesh as it came
    Diagnosis diagnosis;
    DesignMeasure measure;
    SolveReport solve;
    std::vector<std::string> dropped;
  };

  int edits_left() const {
    return options_.max_edits < 0 ? std::numeric_limits<int>::max()
                                  : options_.max_edits - static_cast<int>(report_.applied.size());
  }
  ScoreWeights weights(bool last_resort) const {
    ScoreWeights weights = options_.advice.weights;
    if (last_resort) weights.given_up = 0.0;
    return weights;
  }

  Result<void> measure(Stage& stage) const {
    stage.diagnosis = diagnose(*stage.design.complex, stage.design.state, options_.findings);
    auto measured = measure_design(stage.design, stage.diagnosis);
    if (!measured) return tl::unexpected(measured.error());
    stage.measure = std::move(*measured);
    return {};
  }

  std::vector<Candidate> candidates(bool last_resort) const {
    std::vector<Candidate> found;
    if (!last_resort) {
      found = find_candidates(now_.design, now_.diagnosis.findings);
    } else {
      std::set<EditKey> seen;
      for (const Finding& finding : now_.diagnosis.findings)
        if (is_unbuildable(finding.kind))
          for (Candidate& candidate : last_resorts(now_.design, finding).allowed)
            if (seen.insert(key(candidate)).second) found.push_back(std::move(candidate));
    }
    std::erase_if(found, [&](const Candidate& candidate) { return useless_.contains(key(candidate)); });
    return found;
  }
  EditKey key(const Candidate& candidate) const {
    return key_of(candidate.edit, *now_.design.mesh, now_.ids);
  }

  // Whether the design is better afterwards.
  Result<bool> round(bool last_resort) {
    const int number = static_cast<int>(report_.rounds.size()) + 1;
    const auto solver = PatchSolver::create(now_.design);
    if (!solver) return tl::unexpected(solver.error());
    AdviceOptions advice = options_.advice;
    advice.weights = weights(last_resort);
    if (last_resort) advice.least_gain = std::min(advice.least_gain, kLeastGainOfLastResort);
    if (observer_) advice.progress = [&](int rated, int of) { observer_->on_rated(number, rated, of); };
    const std::vector<Candidate> all = candidates(last_resort);
    std::vector<Suggestion> suggestions = rate(*solver, all, advice, {}, stop_);

    ImproveReport::Round result;
    result.rated = static_cast<int>(all.size());
    while (!suggestions.empty() && result.edits == 0 && !stop_.stop_requested()) {
      std::vector<Suggestion> batch;
      for (const int k : choose_apart(*now_.design.mesh, suggestions))
        if (static_cast<int>(batch.size()) < edits_left())
          batch.push_back(suggestions[static_cast<size_t>(k)]);
      auto next = best_part(*solver, batch, advice);
      if (!next) return tl::unexpected(next.error());
      if (next->has_value()) {
        keep(std::move(**next), batch, number, advice, result);
      } else {  // what was tried alone last does not help; what was rated still holds
        useless_.insert(key(batch.front().candidate));
        std::erase_if(suggestions,
                      [&](const Suggestion& each) { return useless_.contains(key(each.candidate)); });
      }
    }
    report_.rounds.push_back(result);
    if (observer_) observer_->on_round(number, result, now_.measure);
    return result.edits > 0;
  }

  // The design after the batch, or after its better half, and so on, if that is better; batch: cut to what
  // was applied. Nothing: not even its best edit alone betters the design.
  Result<std::optional<Stage>> best_part(const PatchSolver& solver, std::vector<Suggestion>& batch,
                                         const AdviceOptions& advice) {
    while (true) {
      auto next = applied(solver, batch, advice);
      if (!next) return next;
      if (next->has_value() && total(now_.measure.score) - total((*next)->measure.score) > kLeastFall &&
          (*next)->measure.unbuildable() <= now_.measure.unbuildable())
        return next;
      if (batch.size() == 1 || stop_.stop_requested()) return std::nullopt;
      batch.resize(batch.size() / 2);
    }
  }

  void keep(Stage next, const std::vector<Suggestion>& batch, int number, const AdviceOptions& advice,
            ImproveReport::Round& result) {
    result.edits = static_cast<int>(batch.size());
    result.gained = total(now_.measure.score) - total(next.measure.score);
    for (const Suggestion& suggestion : batch) {
      const double gain = suggestion.gain(advice.weights);
      result.predicted += gain;
      report_.applied.push_back({named(suggestion.candidate.edit, now_.ids), gain, number});
    }
    report_.dropped.insert(report_.dropped.end(), next.dropped.begin(), next.dropped.end());
    report_.solve = next.solve;
    now_ = std::move(next);
  }

  // The design after a batch; nothing where an edit was refused or the solve came to no planar state.
  Result<std::optional<Stage>> applied(const PatchSolver& patches, const std::vector<Suggestion>& batch,
                                       const AdviceOptions& advice) {
    std::vector<Trial> trials;
    EditedMesh edited{*now_.design.mesh, identity_map(*now_.design.mesh)};
    for (const Suggestion& suggestion : batch) {
      const Candidate& candidate = suggestion.candidate;
      const auto ground = patches.prepare(candidate.centre, advice.radius, stop_);
      if (!ground) return std::nullopt;
      auto trial = patches.attempt(*ground, candidate.edit, stop_);
      if (!trial) return std::nullopt;
      trials.push_back(std::move(*trial));
      auto next = apply(edited.mesh, renumbered(candidate.edit, edited.map));
      if (!next) return std::nullopt;
      edited = {std::move(next->mesh), composed(edited.map, next->map)};
    }
    Stage stage;
    stage.ids = numbering_.edited(now_.ids, edited.map);
    stage.map = composed(now_.map, edited.map);
    Design settings;
    settings.layers.front().settings = now_.design.settings;
    settings.selections = now_.design.selections;
    RemappedDesign remapped =
        planewright::remapped(std::move(settings), edited.map, *now_.design.mesh, edited.mesh);
    stage.dropped = std::move(remapped.dropped);
    stage.design.settings = remapped.design.layers.front().settings;
    stage.design.selections = std::move(remapped.design.selections);
    // With no reference of its own, closeness refers to the mesh as it came.
    stage.design.reference = now_.design.reference;
    stage.design.mesh = std::make_shared<const PolygonMesh>(std::move(edited.mesh));
    const auto built = build_complex(*stage.design.mesh, stage.design.settings);
    if (!built) return std::nullopt;
    auto complex = std::make_shared<TangentComplex>(**built);
    complex->mean_edge = now_.design.complex->mean_edge;  // one unit for all that is compared
    stage.design.complex = std::move(complex);

    const State start = adopt(now_.design, trials, *stage.design.complex, edited.map);
    auto solved = solve_layer(
        solver_,
        {stage.design.complex, stage.design.settings, stage.design.selections, stage.design.reference, {}},
        start, options_.solve, nullptr, stop_);
    if (!solved) return tl::unexpected(solved.error());
    if (solved->status != SolveStatus::Converged && solved->status != SolveStatus::Planar)
      return std::nullopt;
    stage.design.state = solved->state;
    stage.design.converged = solved->status == SolveStatus::Converged;
    stage.solve = std::move(*solved);
    if (auto measured = measure(stage); !measured) return tl::unexpected(measured.error());
    return stage;
  }

  Result<void> list_what_is_left() {
    const auto solver = PatchSolver::create(now_.design);
    if (!solver) return tl::unexpected(solver.error());
    AdviceOptions advice = options_.advice;
    advice.weights = weights(true);
    advice.least_gain = -std::numeric_limits<double>::infinity();
    for (const Finding& finding : now_.diagnosis.findings) {
      if (!is_unbuildable(finding.kind)) continue;
      ImproveReport::Left left{finding, least_angle_defect(*now_.design.mesh, finding.mesh_edges), {}};
      const LastResorts resorts = last_resorts(now_.design, finding);
      const auto rated = rate(*solver, resorts.allowed, advice, {}, stop_);
      std::set<EditKey> solved;
      for (const Suggestion& suggestion : rated) {
        left.tried.push_back(
            {named(suggestion.candidate.edit, now_.ids), suggestion.gain(advice.weights), {}});
        solved.insert(key(suggestion.candidate));
      }
      for (const Candidate& candidate : resorts.allowed)
        if (!solved.contains(key(candidate)))
          left.tried.push_back(
              {named(candidate.edit, now_.ids), {}, "its neighbourhood could not be solved"});
      for (const LastResorts::Refused& refused : resorts.refused)
        left.tried.push_back({named(refused.edit, now_.ids), {}, refused.reason});
      report_.left.push_back(std::move(left));
    }
    return {};
  }

  Solver& solver_;
  ImproveOptions options_;
  ImproveObserver* observer_;
  std::stop_token stop_;
  ElementNumbering numbering_;
  Stage now_;
  std::set<EditKey> useless_;  // tried alone, and B did not fall
  ImproveReport report_;
};

}  // namespace

Result<ImproveReport> improve(Solver& solver, const Advised& solved, const ImproveOptions& options,
                              ImproveObserver* observer, std::stop_token stop) {
  return Improver(solver, options, observer, std::move(stop)).run(solved);
}

}  // namespace planewright
