// planewright-cli sample NAME [--panels N] -o OUT: writes a sample design made by formula.
#include <cstdio>

#include "cli/commands.h"
#include "cli/output_files.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/sample_shapes.h"

namespace planewright::cli {
namespace {

struct SampleOptions {
  std::string name, output;
  int panels = 0;
};

ExitStatus run(const SampleOptions& options) {
  // What cannot be written should be known before the work, not after it.
  if (const auto format = format_of(options.output); !format) return report(format.error());
  if (const auto writable = check_outputs({}, {{"-o", options.output}}); !writable)
    return report(writable.error());
  const auto mesh = make_sample(options.name, options.panels);
  if (!mesh) return report(mesh.error());
  if (const auto saved = save_mesh(options.output, mesh->positions(), mesh->faces()); !saved)
    return report(saved.error());
  std::printf("%s: %d vertices, %d faces\n", options.output.c_str(), mesh->vertex_count(),
              mesh->face_count());
  return kSuccess;
}

}  // namespace

void add_sample_command(CLI::App& app, ExitStatus& status) {
  auto options = std::make_shared<SampleOptions>();
  std::string names;
  for (const SampleInfo& info : samples())
    names += "\n  " + std::string(info.name) + ": " + std::string(info.description);
  auto* command = app.add_subcommand("sample", "Write a sample design made by formula:" + names);
  command->add_option("NAME", options->name, "Which one")->required();
  command->add_option("--panels", options->panels, "How many panels it should have, about");
  command->add_option("-o,--output", options->output, "File to write (.obj .off .ply .stl)")->required();
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace planewright::cli
