// planewright-cli dual | planarize | panels IN -o OUT: mesh in, planar panels out.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/design_files.h"
#include "cli/layer_crossings.h"
#include "cli/layer_jobs.h"
#include "cli/layer_run.h"
#include "cli/output_files.h"
#include "cli/solve_options.h"
#include "cli/solve_summary.h"
#include "core/base/atomic_file.h"
#include "core/design/design.h"
#include "core/export/solve_record.h"
#include "core/mesh/mesh_io.h"

namespace planewright::cli {
namespace {

using Clock = std::chrono::steady_clock;

// What cannot be written should be known before the work, not after it.
Result<void> check_files(const SolveCommandOptions& options, const LayerPlan& plan) {
  std::vector<NamedFile> outputs = outputs_of(plan);
  for (const NamedFile& output : outputs)
    if (!output.path.empty())
      if (const auto format = format_of(output.path); !format) return tl::unexpected(format.error());
  outputs.push_back({"--report", options.report});
  return check_outputs(inputs_of(options), outputs);
}

// Of several layers the status of the worst: demands that contradict each other before anything else missed.
ExitStatus worse(ExitStatus a, ExitStatus b) {
  return std::max(a, b);
}

Result<ExitStatus> solve_layers(const LayerPlan& plan, const SolveCommandOptions& options,
                                const DesignFiles& files, const HealthReport& health, double seconds_build) {
  std::vector<SolvedLayer> solved;
  std::vector<SolveRecord> records;
  ExitStatus status = kSuccess;
  for (const LayerJob& job : plan.jobs) {
    auto record = run_layer(plan.jobs, options, files, solved);
    if (!record) return tl::unexpected(record.error());
    record->health = health;
    record->seconds_build = seconds_build;
    record->seconds_total += seconds_build;
    // Told before the report is written: should that fail, the panels are there and how they are is known.
    if (!options.quiet) print_summary(*record, job.output, options.unit);
    std::fflush(stdout);  // the report may go to the same place (/dev/stdout), past this buffer
    status = worse(status, judge(*record));
    records.push_back(std::move(*record));
    if (records.back().solve.status == SolveStatus::Stopped && records.size() < plan.jobs.size()) {
      std::fprintf(stderr, "planewright-cli: warning: the layers after '%s' were not solved\n",
                   job.layer.name.c_str());
      break;
    }
  }
  count_crossings(solved, records);
  if (!options.quiet) print_crossings(records);
  std::fflush(stdout);
  status = worse(status, judge_crossings(records));
  if (!options.report.empty()) {
    const std::string json = options.layers.empty() ? to_json(records.front()) : to_json(records);
    if (auto saved = write_file_atomically(options.report, json); !saved)
      return tl::unexpected(saved.error());
  }
  return status;
}

// A reference steers nothing but closeness.
void note_idle_reference(const LayerPlan& plan, const SolveCommandOptions& options) {
  const bool used = std::any_of(plan.jobs.begin(), plan.jobs.end(), [](const LayerJob& job) {
    const auto& weights = job.layer.settings.weights;
    const auto closeness = weights.find("closeness");
    return closeness != weights.end() && closeness->second > 0.0;
  });
  if (!options.reference.empty() && !used)
    std::fprintf(
        stderr,
        "planewright-cli: note: --reference changes nothing, because 'closeness' has no weight; give "
        "one with --weights closeness=1 or --preset close\n");
}

Result<ExitStatus> run(const SolveCommandOptions& options) {
  const auto begun = Clock::now();
  if (const auto format = format_of(options.output); !format) return tl::unexpected(format.error());
  auto plan = plan_layers(options);
  if (!plan) return tl::unexpected(plan.error());
  if (auto checked = check_files(options, *plan); !checked) return tl::unexpected(checked.error());

  const auto checked = load_mesh(options.input);
  if (!checked) return tl::unexpected(checked.error());
  if (!checked->health.healthy())
    std::fprintf(stderr, "planewright-cli: note: %s: %s\n", options.input.c_str(),
                 checked->health.summary().c_str());
  const auto files = read_design_files(options, checked->mesh);
  if (!files) return tl::unexpected(files.error());
  const ComplexKind mode = options.mode_by_mesh ? suggested_mode(checked->mesh) : options.settings.mode;
  if (auto prepared = prepare_layers(*plan, options, mode, *files, checked->mesh); !prepared)
    return tl::unexpected(prepared.error());
  note_idle_reference(*plan, options);
  const double seconds_build = std::chrono::duration<double>(Clock::now() - begun).count();
  return solve_layers(*plan, options, *files, checked->health, seconds_build);
}

CLI::App* add_solve_command(CLI::App& app, ExitStatus& status, ComplexKind mode, const char* command_name,
                            const char* description, const std::shared_ptr<SolveCommandOptions>& options) {
  options->settings.mode = mode;
  auto* command = app.add_subcommand(command_name, description);
  declare_solve_options(*command, options);
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
  declare_border_option(*command, options);
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
