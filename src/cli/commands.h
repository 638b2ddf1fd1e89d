// The commands of planewright-cli, one file each. Each add_* declares its options below `app` and, when the
// user names the command, stores what it ended with in `status`.
#pragma once

#include <CLI/CLI.hpp>

#include "cli/exit_status.h"

namespace planewright::cli {

void add_sample_command(CLI::App& app, ExitStatus& status);
void add_dual_command(CLI::App& app, ExitStatus& status);
void add_planarize_command(CLI::App& app, ExitStatus& status);
void add_panels_command(CLI::App& app, ExitStatus& status);
void add_cluster_command(CLI::App& app, ExitStatus& status);
void add_check_command(CLI::App& app, ExitStatus& status);
void add_diagnose_command(CLI::App& app, ExitStatus& status);
void add_improve_command(CLI::App& app, ExitStatus& status);
void add_export_command(CLI::App& app, ExitStatus& status);
void add_render_command(CLI::App& app, ExitStatus& status);

}  // namespace planewright::cli
