#include "warm_start.h"

#include <cstdio>
#include <memory>

#include "contenders.h"
#include "models.h"
#include "run_options.h"
#include "table.h"

namespace planewright::bench {
namespace {

void print(const std::string& name, const MeasuredRow& alone, const MeasuredRow& warm) {
  const auto number = [](const MeasuredRow& row, int value) {
    return row.end == ChildEnd::Finished ? std::to_string(value) : std::string("-");
  };
  std::printf("%-16s %9s %9.2f %-11s %9s %9s %9.2f %-11s\n", name.c_str(),
              number(alone, alone.value.ipopt_iterations).c_str(), alone.usage.cpu, verdict(alone).c_str(),
              number(warm, warm.value.ipopt_iterations).c_str(), number(warm, warm.value.iterations).c_str(),
              warm.usage.cpu, verdict(warm).c_str());
  for (const MeasuredRow* row : {&alone, &warm})
    if (row->end != ChildEnd::Finished) std::printf("    %s\n", row->why.c_str());
  std::fflush(stdout);
}

void measure_warm_starts(const RunOptions& options) {
  const std::filesystem::path meshes = meshes_folder(options.meshes);
  const std::vector<Model> models = find_models(options.models);
  std::printf(
      "Iterations of Ipopt alone, and within auto, started from tangent's state and multipliers. CPU: of "
      "the\n"
      "whole process. Rows are cut off after %g s.\n\n",
      options.limits.seconds);
  std::printf("%-16s %9s %9s %-11s %9s %9s %9s %-11s\n", "", "alone", "CPU s", "status", "in auto", "of all",
              "CPU s", "status");
  for (const Model& model : models) {
    if (!available(model, meshes)) {
      print_skipped(model.name, "there is no " + model.file + "; name its folder with --meshes");
      continue;
    }
    const auto run = [&](Contender contender) {
      return measure(contender, model, meshes, {.tolerance = model.tolerance}, options.repeat,
                     options.limits);
    };
    const MeasuredRow alone = run(Contender::Ipopt);
    print(model.name, alone, run(Contender::Auto));
  }
}

}  // namespace

void declare_warm_start(CLI::App& app) {
  auto options = std::make_shared<RunOptions>();
  options->models = {"torus-1k", "torus-10k", "fertility", "train-station"};
  CLI::App* command =
      app.add_subcommand("warm-start", "Iterations of Ipopt alone, and to confirm the tangent solver");
  declare_models(*command, *options);
  command->callback([options] { measure_warm_starts(*options); });
}

}  // namespace planewright::bench
