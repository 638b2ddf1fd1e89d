// planewright-cli improve IN -o OUT [--max-edits N] [--mesh MESH]: solves, edits the mesh where that betters
// the panels, solves again, and writes the panels and the edited mesh.
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>

#include "cli/commands.h"
#include "cli/design_files.h"
#include "cli/edit_progress.h"
#include "cli/finding_options.h"
#include "cli/improve_summary.h"
#include "cli/layer_jobs.h"
#include "cli/layer_run.h"
#include "cli/named_choice.h"
#include "cli/output_files.h"
#include "cli/solve_options.h"
#include "core/base/atomic_file.h"
#include "core/design/design.h"
#include "core/export/improve_record.h"
#include "core/mesh/mesh_io.h"

namespace planewright::cli {
namespace {

using Clock = std::chrono::steady_clock;

struct ImproveCommandOptions {
  std::shared_ptr<SolveCommandOptions> solve = std::make_shared<SolveCommandOptions>();
  std::optional<ComplexKind> mode;  // none: whichever fits the mesh
  std::string mesh;                 // file; empty: not asked for
  std::vector<std::string> thresholds;
  int max_edits = -1;
};

Result<void> check_files(const ImproveCommandOptions& options) {
  for (const std::string& file : {options.solve->output, options.mesh})
    if (!file.empty())
      if (const auto format = format_of(file); !format) return tl::unexpected(format.error());
  return check_outputs(
      inputs_of(*options.solve),
      {{"-o", options.solve->output}, {"--mesh", options.mesh}, {"--report", options.solve->report}});
}

// The result of no edit at all, where there is nothing that edits could start from.
ImproveReport unedited(const Advised& design, SolveReport solve, const FindingSettings& findings) {
  ImproveReport report;
  if (auto measured = measure_design(design, diagnose(*design.complex, design.state, findings)))
    report.before = report.after = *measured;
  report.stopped = solve.status == SolveStatus::Stopped;
  report.map = identity_map(*design.mesh);
  report.design = design;
  report.solve = std::move(solve);
  return report;
}

bool is_planar(SolveStatus status) {
  return status == SolveStatus::Converged || status == SolveStatus::Planar;
}

Result<ImproveReport> improved(const LayerJob& job, const ImproveCommandOptions& options,
                               const DesignFiles& files, const std::shared_ptr<const PolygonMesh>& mesh,
                               const FindingSettings& findings) {
  const SolveCommandOptions& solve = *options.solve;
  auto solved = solve_job(job, solve, files, {});
  if (!solved) return tl::unexpected(solved.error());
  const Advised design{mesh,
                       job.complex,
                       solved->state,
                       job.layer.settings,
                       files.selections,
                       files.reference,
                       solved->status == SolveStatus::Converged};
  if (!is_planar(solved->status)) return unedited(design, std::move(*solved), findings);
  ImproveOptions improving;
  improving.max_edits = options.max_edits;
  improving.findings = findings;
  improving.solve = solve_options(job.layer.settings);
  // Rounds are solves from nearby; confirming each by another solver would take most of the time.
  const auto solver = make_solver(solve.solver == SolverKind::Auto ? SolverKind::Tangent : solve.solver);
  EditProgress progress(solve.quiet);
  auto report = improve(*solver, design, improving, &progress, progress.stop_token());
  if (report && report->applied.empty()) report->solve = std::move(*solved);
  return report;
}

Result<Planarity> planarity_of_file(const std::string& path, const Panels& panels) {
  const auto format = format_of(path);
  if (!format) return tl::unexpected(format.error());
  if (*format == MeshFormat::Stl) return measure_planarity(panels.points, panels.polygons);
  const auto content = read_file(path);
  if (!content) return tl::unexpected(content.error());
  const auto soup = parse_mesh(*content, *format, path);
  if (!soup) return tl::unexpected(soup.error());
  return measure_planarity(soup->positions, soup->faces);
}

Result<void> write_all(const ImproveCommandOptions& options, ImproveRecord& record) {
  const Advised& design = record.report.design;
  const Panels panels = panels_of(*design.complex, design.state);
  if (auto saved = save_mesh(record.panels_file, panels.points, panels.polygons); !saved) return saved;
  const auto planarity = planarity_of_file(record.panels_file, panels);
  if (!planarity) return tl::unexpected(planarity.error());
  record.planarity = *planarity;
  if (!record.mesh_file.empty())
    if (auto saved = save_mesh(record.mesh_file, design.mesh->positions(), design.mesh->faces()); !saved)
      return saved;
  if (!options.solve->report.empty()) return write_file_atomically(options.solve->report, to_json(record));
  return {};
}

Result<ExitStatus> run(const ImproveCommandOptions& options) {
  const auto begun = Clock::now();
  const SolveCommandOptions& solve = *options.solve;
  const auto findings = parse_finding_settings({}, options.thresholds);
  if (!findings) return tl::unexpected(findings.error());
  auto plan = plan_layers(solve);
  if (!plan) return tl::unexpected(plan.error());
  if (auto checked = check_files(options); !checked) return tl::unexpected(checked.error());
  const auto checked = load_mesh(solve.input);
  if (!checked) return tl::unexpected(checked.error());
  if (!checked->health.healthy())
    std::fprintf(stderr, "planewright-cli: note: %s: %s\n", solve.input.c_str(),
                 checked->health.summary().c_str());
  const auto mesh = std::make_shared<const PolygonMesh>(checked->mesh);
  const auto files = read_design_files(solve, *mesh);
  if (!files) return tl::unexpected(files.error());
  if (auto prepared =
          prepare_layers(*plan, solve, options.mode.value_or(suggested_mode(*mesh)), *files, *mesh);
      !prepared)
    return tl::unexpected(prepared.error());

  auto report = improved(plan->jobs.front(), options, *files, mesh, *findings);
  if (!report) return tl::unexpected(report.error());
  ImproveRecord record;
  record.input = solve.input;
  record.panels_file = solve.output;
  record.mesh_file = options.mesh;
  record.health = checked->health;
  record.report = std::move(*report);
  record.seconds = std::chrono::duration<double>(Clock::now() - begun).count();
  if (auto written = write_all(options, record); !written) return tl::unexpected(written.error());
  if (!solve.quiet) print_improvement(record, solve.unit);
  for (const std::string& dropped : record.report.dropped)
    std::fprintf(stderr, "planewright-cli: note: went with what the edits removed: %s\n", dropped.c_str());
  if (record.report.stopped)
    std::fprintf(stderr, "planewright-cli: warning: stopped; what was reached by then is written\n");
  else if (!is_planar(record.report.solve.status))
    std::fprintf(stderr, "planewright-cli: warning: no edit was tried, because the solve ended with: %s\n",
                 record.report.solve.stop_reason.c_str());
  const bool missed = record.report.stopped || record.report.after.unbuildable() > 0;
  return std::max(exit_status(record.report.solve.status), missed ? kNotMet : kSuccess);
}

}  // namespace

void add_improve_command(CLI::App& app, ExitStatus& status) {
  auto options = std::make_shared<ImproveCommandOptions>();
  auto* command = app.add_subcommand(
      "improve", "Solve, and edit the mesh until no edit betters the panels (status 1: bad places are left)");
  declare_unwritten_solve_options(*command, options->solve);
  declare_border_option(*command, options->solve);
  // Edits are rated for one layer, and by its optimisation.
  for (const char* name : {"--layers", "--explicit"}) command->remove_option(command->get_option(name));
  command->add_option("-o,--output", options->solve->output, "Panels to write (.obj .off .ply .stl)")
      ->required();
  command->add_option("--mesh", options->mesh, "Also write the edited mesh (.obj .off .ply .stl)");
  command->add_option("--max-edits", options->max_edits, "At most this many edits (default: all that help)")
      ->check(CLI::Range(0, 1000000));
  command->add_option("--mode", options->mode, "'dual' or 'planarize' (default: whichever fits the mesh)")
      ->transform(
          named_choice<ComplexKind>({{"dual", ComplexKind::Dual}, {"planarize", ComplexKind::Planarize}}));
  declare_thresholds(*command, options->thresholds);
  command->callback([options, &status] {
    const auto result = run(*options);
    status = result ? *result : report(result.error());
  });
}

}  // namespace planewright::cli
