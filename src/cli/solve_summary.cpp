#include "cli/solve_summary.h"

#include <algorithm>
#include <cstdio>
#include <numbers>

#include "cli/cluster_summary.h"

namespace planewright::cli {
namespace {

constexpr double kPlanarRelativeToBox = 1e-9;
constexpr size_t kConflictsShown = 10;

std::string given_up(int count, const char* what) {
  return count == 0 ? std::string() : ", " + std::to_string(count) + what;
}

void print_demands(const SolveRecord& record) {
  const SolveReport& solve = record.solve;
  for (const std::string& name : demands_without_rows(record))
    std::printf("constraint %s: asks nothing\n", name.c_str());
  for (const auto& constraint : solve.constraints) {
    // Planarity stands for the equations that every problem has.
    if (!is_demand(constraint) || constraint.rows == 0) continue;
    if (constraint.violated == 0)
      std::printf("constraint %s: met (%d rows%s)\n", constraint.name.c_str(), constraint.rows,
                  given_up(constraint.waived, " given up").c_str());
    else
      std::printf("constraint %s: %d of %d rows not met, the worst by %.2e%s at %s%s\n",
                  constraint.name.c_str(), constraint.violated, constraint.rows, constraint.max_violation,
                  constraint.unit.empty() ? "" : (" " + constraint.unit).c_str(),
                  text(constraint.worst).c_str(), given_up(constraint.waived, " given up").c_str());
  }
  if (solve.rounds > 1) std::printf("rounds: %d\n", solve.rounds);
  if (solve.crossings >= 0)
    std::printf("panels that cross the mesh: %d pairs%s\n", solve.crossings,
                given_up(solve.crossings_waived, " at places given up").c_str());
}

void print_diagnosis(const SolveRecord& record, const std::string& unit) {
  if (!record.ill_determined.empty())
    std::printf("ill-determined points: %zu, the worst is point %d (singular value %.2g)\n",
                record.ill_determined.size(), record.ill_determined.front().point,
                record.ill_determined.front().singular_value);
  if (!record.self_crossing.empty())
    std::printf("panels that cross themselves: %zu, the first is panel %d\n", record.self_crossing.size(),
                record.self_crossing.front());
  if (!record.short_edges.empty())
    std::printf("panel edges below a twentieth of the mean: %zu, the shortest is %.3g %s long\n",
                record.short_edges.size(), record.short_edges.front().length, unit.c_str());
}

void print_construction(const SolveRecord& record, const std::string& unit) {
  if (const auto& offset = record.offset_layer) {
    std::printf("offset by %g %s: %s, planar to %.2e %s\n", offset->thickness, unit.c_str(),
                offset->file.c_str(), offset->planarity.max, unit.c_str());
    if (!offset->blunted.empty())
      std::printf("  blunted corners: %zu, the first is point %d (would move %.3g %s)\n",
                  offset->blunted.size(), offset->blunted.front().point, offset->blunted.front().wanted_move,
                  unit.c_str());
    if (!offset->residuals.empty()) {
      const auto worst =
          std::max_element(offset->residuals.begin(), offset->residuals.end(),
                           [](const auto& a, const auto& b) { return a.residual < b.residual; });
      std::printf("  corners off their planes: %zu, the worst is point %d (%.2e %s)\n",
                  offset->residuals.size(), worst->point, worst->residual, unit.c_str());
    }
  }
  if (const auto& beams = record.beams)
    std::printf("beams to %s: %s, %d, planar to %.2e %s, twisted by up to %.3g degrees\n",
                beams->with == "offset" ? "the offset" : ("layer " + beams->with).c_str(),
                beams->file.c_str(), beams->count, beams->max_planarity, unit.c_str(),
                beams->max_twist * 180.0 / std::numbers::pi);
}

// "planewright-cli: warning: layer outer: "
std::string beginning(const SolveRecord& record) {
  return "planewright-cli: warning: " + (record.layer.empty() ? "" : "layer " + record.layer + ": ");
}

// What spoils no status but is hardly meant.
void warn_of_oddities(const SolveRecord& record) {
  for (const std::string& name : demands_without_rows(record))
    std::fprintf(
        stderr,
        "%sasks nothing: the constraint '%s' finds no element that it speaks of, or has no value that "
        "limits one\n",
        beginning(record).c_str(), name.c_str());
  if (record.beams && record.beams->turned_round > 0)
    std::fprintf(
        stderr,
        "%sbeams whose two edges run against each other (they are turned round, twisted by more than "
        "90 degrees): %d, the most twisted is that of panel edge %d, by %.3g degrees\n",
        beginning(record).c_str(), record.beams->turned_round, record.beams->most_twisted_edge,
        record.beams->max_twist * 180.0 / std::numbers::pi);
}

void warn_of_conflicts(const SolveRecord& record) {
  const auto& conflicts = record.solve.conflicts;
  if (conflicts.empty()) return;
  std::string list;
  for (size_t k = 0; k < std::min(conflicts.size(), kConflictsShown); ++k)
    list += (k == 0 ? " " : ", ") + conflicts[k].demand + " at " + text(conflicts[k].element);
  std::fprintf(stderr, "%s%zu constraints cannot be met together with the others and were given up:%s%s\n",
               beginning(record).c_str(), conflicts.size(), list.c_str(),
               conflicts.size() > kConflictsShown ? ", ..." : "");
}

}  // namespace

void print_summary(const SolveRecord& record, const std::string& output, const std::string& unit) {
  const SolveReport& solve = record.solve;
  if (!record.layer.empty()) std::printf("layer %s\n", record.layer.c_str());
  std::printf("%s: %d panels, %d points\n", output.c_str(), record.panels, record.points);
  std::printf("status: %s after %d iterations, %.2f s (%s)\n", name(solve.status), solve.iterations,
              solve.seconds, solve.stop_reason.c_str());
  std::printf("planarity: max %.2e %s (%.1e of the diagonal)\n", record.planarity.max, unit.c_str(),
              record.planarity.max_relative_to_bbox);
  std::printf("displacement: rms %.4g %s, max %.4g %s (%.3f and %.3f mean edges)\n", record.displacement.rms,
              unit.c_str(), record.displacement.max, unit.c_str(), record.displacement.rms / record.mean_edge,
              record.displacement.max / record.mean_edge);
  for (const auto& energy : solve.energies)
    std::printf("energy %s (weight %g): %.6g\n", energy.name.c_str(), energy.weight, energy.value);
  print_demands(record);
  print_diagnosis(record, unit);
  if (record.clusters) print_clusters(*record.clusters, unit);
  print_construction(record, unit);
}

ExitStatus judge(const SolveRecord& record) {
  const SolveReport& solve = record.solve;
  const std::string begin = beginning(record);
  warn_of_conflicts(record);
  warn_of_oddities(record);
  if (const ExitStatus status = exit_status(solve.status); status != kSuccess) {
    std::fprintf(stderr, "%s%s: %s\n", begin.c_str(), name(solve.status), solve.stop_reason.c_str());
    return status;
  }
  if (record.planarity.max_relative_to_bbox > kPlanarRelativeToBox) {
    std::fprintf(stderr, "%sthe written panels are planar to %.1e of the diagonal only\n", begin.c_str(),
                 record.planarity.max_relative_to_bbox);
    return kNotMet;
  }
  for (const auto& constraint : solve.constraints)
    if (is_demand(constraint) && constraint.violated > 0) {
      std::fprintf(stderr, "%sthe constraint '%s' is not met at %d places, the worst is %s\n", begin.c_str(),
                   constraint.name.c_str(), constraint.violated, text(constraint.worst).c_str());
      return kNotMet;
    }
  if (const auto crossing = forbidden_self_crossings(record); !crossing.empty()) {
    std::fprintf(stderr, "%s%zu panels cross themselves all the same, the first is panel %d\n", begin.c_str(),
                 crossing.size(), crossing.front());
    return kNotMet;
  }
  if (record.clusters && !clustering_done(*record.clusters, begin)) return kNotMet;
  if (record.settings.no_penetration && solve.crossings != solve.crossings_waived) {
    if (solve.crossings < 0)
      std::fprintf(stderr, "%swhether panels cross the mesh was not found out\n", begin.c_str());
    else
      std::fprintf(stderr, "%s%d pairs of a panel and a face of the mesh still cross\n", begin.c_str(),
                   solve.crossings - solve.crossings_waived);
    return kNotMet;
  }
  return kSuccess;
}

}  // namespace planewright::cli
