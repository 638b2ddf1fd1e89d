// planewright-cli dual | planarize | panels IN -o OUT: mesh in, planar panels out.
#include <chrono>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/finite_number.h"
#include "cli/output_files.h"
#include "cli/progress.h"
#include "cli/weights_option.h"
#include "core/base/atomic_file.h"
#include "core/complex/explicit_intersection.h"
#include "core/export/solve_record.h"
#include "core/mesh/mesh_io.h"
#include "core/design/design.h"
#include "core/solve/ipopt_solver.h"

namespace planewright::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kPlanarRelativeToBox = 1e-9;

struct SolveCommandOptions {
  std::string input, output, report, unit = "m", weights, solver = "ipopt";
  LayerSettings settings;
  bool quiet = false, explicit_points = false;
  bool mode_by_mesh = false;  // `panels`: triangles become a dual, anything else is planarized
};

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

// Planarity of what the file says, not of what was meant to be written. STL holds triangles alone; there the
// panels themselves are measured.
Result<Planarity> planarity_as_written(const std::string& path, const Panels& panels) {
  const auto format = format_of(path);
  if (!format) return tl::unexpected(format.error());
  if (*format == MeshFormat::Stl) return measure_planarity(panels.points, panels.polygons);
  const auto content = read_file(path);
  if (!content) return tl::unexpected(content.error());
  const auto soup = parse_mesh(*content, *format, path);
  if (!soup) return tl::unexpected(soup.error());
  return measure_planarity(soup->positions, soup->faces);
}

void print_summary(const SolveRecord& record, const std::string& output, const std::string& unit) {
  const SolveReport& solve = record.solve;
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

// The baseline without optimisation, as a report like any other.
SolveReport solve_explicitly(const TangentComplex& complex) {
  const auto begun = Clock::now();
  TpiResult result = explicit_intersection(complex);
  SolveReport report;
  report.solver = "explicit";
  report.state = std::move(result.state);
  report.incidence_residual =
      incidence_residuals(complex, report.state).cwiseAbs().maxCoeff() / complex.mean_edge;
  report.status = result.failed.empty() ? SolveStatus::Converged : SolveStatus::NotPlanar;
  report.stop_reason = "every point was computed from its planes";
  // Nothing was minimised, so there are no multipliers to measure a slope with; 0 would claim a stationary
  // state.
  report.first_order_residual = std::numeric_limits<double>::quiet_NaN();
  if (!result.failed.empty()) {
    std::map<TpiFailure, int> counts;
    for (const auto& failed : result.failed) ++counts[failed.why];
    report.stop_reason = std::to_string(result.failed.size()) + " points could not be computed:";
    for (const auto& [why, count] : counts)
      report.stop_reason += " " + std::to_string(count) + " have " + name(why) + ",";
    report.stop_reason.back() = ';';
    report.stop_reason += " the first is point " + std::to_string(result.failed.front().point);
  }
  report.seconds = seconds_since(begun);
  return report;
}

// What the energies of an optimisation come to where nothing was optimised, for comparison. Left out where
// the problem cannot be stated.
std::vector<SolveReport::Energy> energies_at(const State& state,
                                             const std::shared_ptr<const TangentComplex>& complex,
                                             const LayerSettings& settings) {
  std::vector<SolveReport::Energy> energies;
  const auto problem = build_problem(complex, settings);
  if (!problem) return energies;
  const Vector z = (*problem)->from_state(state);
  for (const auto& share : (*problem)->energy_shares(z.data()))
    energies.push_back({share.name, share.weight, share.value});
  return energies;
}

Result<ExitStatus> run(SolveCommandOptions& options) {
  const auto begun = Clock::now();
  // What cannot be written should be known before the work, not after it.
  if (const auto format = format_of(options.output); !format) return tl::unexpected(format.error());
  if (!options.weights.empty()) {
    auto weights = parse_weights(options.weights);
    if (!weights) return tl::unexpected(weights.error());
    for (const auto& [name, weight] : *weights) options.settings.weights[name] = weight;
  }
  if (auto writable =
          check_outputs({{"IN", options.input}}, {{"-o", options.output}, {"--report", options.report}});
      !writable)
    return tl::unexpected(writable.error());

  SolveRecord record;
  record.input = options.input;
  record.settings = options.settings;
  const auto checked = load_mesh(options.input);
  if (!checked) return tl::unexpected(checked.error());
  record.health = checked->health;
  if (options.mode_by_mesh) record.settings.mode = options.settings.mode = suggested_mode(checked->mesh);
  if (!checked->health.healthy())
    std::fprintf(stderr, "planewright-cli: note: %s: %s\n", options.input.c_str(),
                 checked->health.summary().c_str());

  const auto complex = build_complex(checked->mesh, options.settings);
  if (!complex) return tl::unexpected(complex.error());
  if (options.explicit_points) {
    record.seconds_build = seconds_since(begun);
    record.solve = solve_explicitly(**complex);
    record.solve.energies = energies_at(record.solve.state, *complex, options.settings);
  } else {
    const auto problem = build_problem(*complex, options.settings);
    if (!problem) return tl::unexpected(problem.error());
    record.seconds_build = seconds_since(begun);
    Progress progress(options.quiet, options.settings.tolerance);
    record.solve =
        make_ipopt_solver()->solve(**problem, start_state(**complex, options.settings),
                                   solve_options(options.settings), &progress, progress.stop_token());
  }

  const Panels panels = panels_of(**complex, record.solve.state);
  if (auto saved = save_mesh(options.output, panels.points, panels.polygons); !saved)
    return tl::unexpected(saved.error());
  const auto planarity = planarity_as_written(options.output, panels);
  if (!planarity) return tl::unexpected(planarity.error());
  record.planarity = *planarity;
  record.panels = panels.polygons.size();
  record.points = static_cast<int>(panels.points.rows());
  record.mean_edge = (*complex)->mean_edge;
  record.displacement = measure_displacement(record.solve.state.x, (*complex)->preferred);
  record.ill_determined = find_ill_determined(**complex, record.solve.state);
  record.self_crossing = find_self_crossing(panels.points, panels.polygons);
  record.short_edges = find_short_edges(**complex, record.solve.state);
  record.seconds_total = seconds_since(begun);

  // Told before the report is written: should that fail, the panels are there and how they are is known.
  if (!options.quiet) print_summary(record, options.output, options.unit);
  std::fflush(stdout);  // the report may go to the same place (/dev/stdout), past this buffer
  ExitStatus status = exit_status(record.solve.status);
  if (status != kSuccess) {
    std::fprintf(stderr, "planewright-cli: warning: %s: %s\n", name(record.solve.status),
                 record.solve.stop_reason.c_str());
  } else if (record.planarity.max_relative_to_bbox > kPlanarRelativeToBox) {
    std::fprintf(stderr,
                 "planewright-cli: warning: the written panels are planar to %.1e of the diagonal only\n",
                 record.planarity.max_relative_to_bbox);
    status = kNotMet;
  }

  if (!options.report.empty())
    if (auto saved = write_file_atomically(options.report, to_json(record)); !saved)
      return tl::unexpected(saved.error());
  return status;
}

CLI::App* add_solve_command(CLI::App& app, ExitStatus& status, ComplexKind mode, const char* command_name,
                            const char* description, const std::shared_ptr<SolveCommandOptions>& options) {
  options->settings.mode = mode;
  auto* command = app.add_subcommand(command_name, description);
  command->add_option("IN", options->input, "Mesh to work on (.obj .off .ply .stl)")->required();
  command->add_option("-o,--output", options->output, "Panels to write (.obj .off .ply .stl)")->required();
  command
      ->add_option("--offset", options->settings.offset,
                   "Wanted distance from the input along its normals, model units")
      ->check(finite_number());
  auto* freedom = command
                      ->add_option("--freedom", options->settings.freedom,
                                   "What may change of the planes: 'fixed', 'normals', or 'all' (normals and "
                                   "offsets, the default)")
                      ->transform(CLI::CheckedTransformer(
                          std::map<std::string, Freedom>{{"fixed", Freedom::Fixed},
                                                         {"normals", Freedom::Normals},
                                                         {"all", Freedom::NormalsAndOffsets}}));
  auto* weights =
      command->add_option("--weights", options->weights, "Weights of the energies: position=1,fairing=0.1");
  command->add_option("--solver", options->solver, "Which solver")->check(CLI::IsMember({"ipopt"}));
  auto* max_iterations =
      command->add_option("--max-iterations", options->settings.max_iterations, "Stop after this many")
          ->check(CLI::Range(0, 1000000));
  auto* tolerance =
      command
          ->add_option(
              "--tolerance", options->settings.tolerance,
              "First-order residual at which the solve counts as converged (weights relative to the "
              "largest, lengths in mean edges)")
          ->check(finite_number())
          ->check(CLI::PositiveNumber);
  // What steers an optimisation means nothing where there is none.
  command
      ->add_flag(
          "--explicit", options->explicit_points,
          "No optimisation: intersect the tangent planes directly (the baseline), and say where that fails")
      ->excludes(freedom)
      ->excludes(weights)
      ->excludes(max_iterations)
      ->excludes(tolerance);
  command->add_option("--report", options->report, "JSON report to write");
  command->add_option("--unit", options->unit, "Unit of the model, for messages")
      ->check(CLI::IsMember({"mm", "cm", "m", "in"}));
  command->add_flag("--quiet", options->quiet,
                    "No progress and no summary; errors and warnings still appear");
  command->callback([options, &status] {
    const auto result = run(*options);
    status = result ? *result : report(result.error());
  });
  return command;
}

}  // namespace

void add_dual_command(CLI::App& app, ExitStatus& status) {
  auto options = std::make_shared<SolveCommandOptions>();
  auto* command = add_solve_command(app, status, ComplexKind::Dual, "dual",
                                    "Hexagon-dominant planar dual of a triangle (or polygon) mesh", options);
  command
      ->add_option("--border", options->settings.border,
                   "'closed': the outline of the design survives (default); 'interior': panels of inner "
                   "vertices alone")
      ->transform(CLI::CheckedTransformer(std::map<std::string, BorderPolicy>{
          {"closed", BorderPolicy::Closed}, {"interior", BorderPolicy::Interior}}));
}

void add_planarize_command(CLI::App& app, ExitStatus& status) {
  add_solve_command(app, status, ComplexKind::Planarize, "planarize", "Planar version of a polygon mesh",
                    std::make_shared<SolveCommandOptions>());
}

void add_panels_command(CLI::App& app, ExitStatus& status) {
  auto options = std::make_shared<SolveCommandOptions>();
  add_solve_command(app, status, ComplexKind::Dual, "panels",
                    "Whichever fits the mesh: dual for triangles, planarize for anything else", options);
  options->mode_by_mesh = true;
}

}  // namespace planewright::cli
