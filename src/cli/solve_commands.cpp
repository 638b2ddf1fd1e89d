// planewright-cli dual | planarize | panels IN -o OUT: mesh in, planar panels out.
#include <chrono>
#include <cstdio>
#include <memory>
#include <vector>

#include "cli/commands.h"
#include "cli/design_files.h"
#include "cli/layer_jobs.h"
#include "cli/layer_series.h"
#include "cli/project_output.h"
#include "cli/solve_options.h"
#include "core/design/design.h"
#include "core/mesh/mesh_io.h"

namespace planewright::cli {
namespace {

using Clock = std::chrono::steady_clock;

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
  std::vector<SolvedLayer> solved;
  const auto status = solve_layers(*plan, options, *files, checked->health, seconds_build, solved);
  if (!status) return status;
  if (auto saved = save_project_of(options, checked->mesh, *plan, *files, solved); !saved)
    return tl::unexpected(saved.error());
  return status;
}

CLI::App* add_solve_command(CLI::App& app, ExitStatus& status, ComplexKind mode, const char* command_name,
                            const char* description, const std::shared_ptr<SolveCommandOptions>& options) {
  options->settings.mode = mode;
  auto* command = app.add_subcommand(command_name, description);
  declare_solve_options(*command, options);
  declare_project_option(*command, options);
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
