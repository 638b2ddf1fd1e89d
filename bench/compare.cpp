#include "compare.h"

#include <cstdio>
#include <memory>

#include "contenders.h"
#include "goals.h"
#include "models.h"
#include "run_options.h"
#include "table.h"

namespace planewright::bench {
namespace {

struct CompareOptions : RunOptions {
  double feasible = StopTest{}.feasible;
};

void compare(const CompareOptions& options) {
  const std::filesystem::path meshes = meshes_folder(options.meshes);
  std::vector<Contender> contenders;
  for (const std::string& name : options.only) contenders.push_back(find_contender(name));
  const std::vector<Model> models = find_models(options.models);

  std::printf(
      "Planar panels near the design: position energy alone. Every solver stops at one first-order residual\n"
      "(largest weight 1, mean edge 1): %g on the torus, %g on real meshes; baselines also ask that no row\n"
      "is violated by more than %g. Ipopt default works in raw coordinates.\n"
      "wall, CPU: building the problem and solving it; MB: peak resident memory of the row's own process;\n"
      "residual: by one function, at the final state; planarity: of the diagonal; energy: mean edges\n"
      "squared; rms, max: displacement, mean edges. Best CPU of %d; a row gets %g s, and %g GB of "
      "addresses.\n"
      "\n",
      find_model("torus-1k").tolerance, find_model("fertility").tolerance, options.feasible, options.repeat,
      options.limits.seconds, options.limits.memory_gb);
  print_solver_head();
  Comparison rows;
  for (const Model& model : models) {
    for (const Contender contender : contenders) {
      const std::string name = model.name + ' ' + bench::name(contender);
      if (!available(model, meshes)) {
        print_skipped(name, "there is no " + model.file + "; name its folder with --meshes");
        continue;
      }
      if (model.name == kLargest && contender != Contender::Tangent) {
        print_skipped(name, "tangent alone is measured at this size");
        continue;
      }
      const MeasuredRow row = measure(contender, model, meshes, {model.tolerance, options.feasible},
                                      options.repeat, options.limits);
      print_solver_row(name, row);
      rows[{model.name, contender}] = row;
    }
  }
  print_goals(rows);
}

}  // namespace

void declare_compare(CLI::App& app) {
  auto options = std::make_shared<CompareOptions>();
  options->only = {"default", "tuned", "tangent", "auto"};
  options->models = {"torus-1k", "torus-10k", "torus-100k", "fertility", "dragon", "train-station"};
  CLI::App* command = app.add_subcommand(
      "compare", "Solvers side by side, to the same first-order residual (hours with all)");
  declare_solvers(*command, *options);
  declare_models(*command, *options);
  command
      ->add_option("--feasible", options->feasible,
                   "Largest violation of a row at which the baselines may stop, mean edges")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->callback([options] { compare(*options); });
}

}  // namespace planewright::bench
