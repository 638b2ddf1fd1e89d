// planewright-cli: the command line on the same core as the window. Parses, dispatches, maps to exit
// statuses.
#include <clocale>
#include <cstdio>
#include <exception>

#include "cli/commands.h"
#include "core/base/version.h"

int main(int argc, char** argv) {
  using namespace planewright;
  CLI::App app{
      "Turns freeform surfaces into structures made of planar panels.\n"
      "Exit status: 0 converged; 1 written, but not converged or a tolerance missed; 2 bad usage;\n"
      "3 input unreadable or refused; 4 demands contradict; 5 the machine lacks something."};
  app.name("planewright-cli");
  app.set_version_flag("--version", kVersion);
  app.require_subcommand(1);
  cli::ExitStatus status = cli::kSuccess;
  cli::add_sample_command(app, status);
  cli::add_dual_command(app, status);
  cli::add_planarize_command(app, status);
  cli::add_panels_command(app, status);
  cli::add_cluster_command(app, status);
  cli::add_check_command(app, status);
  cli::add_diagnose_command(app, status);
  cli::add_improve_command(app, status);
  cli::add_export_command(app, status);
  cli::add_render_command(app, status);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? cli::kSuccess : cli::kUsage;
  } catch (const std::exception& bug) {
    std::fprintf(stderr, "planewright-cli: internal error: %s. Please report it with the command you gave\n",
                 bug.what());
    return cli::kUnavailable;
  }
  return status;
}
