#include "cli/solve_options.h"

#include "cli/finite_number.h"
#include "cli/named_choice.h"
#include "core/design/presets.h"
#include "core/problem/demands/demand_catalogue.h"

namespace planewright::cli {
namespace {

using Options = std::shared_ptr<SolveCommandOptions>;

// "vertex, face, ..."
template <class Entries>
std::string names_of(const Entries& entries) {
  std::string names;
  for (const auto& entry : entries) names += (names.empty() ? "" : ", ") + entry.name;
  return names;
}

void declare_files(CLI::App& command, const Options& options) {
  command.add_option("IN", options->input, "Mesh to work on (.obj .off .ply .stl)")->required();
  command.add_option("--report", options->report, "JSON report to write");
  command.add_option("--unit", options->unit, "Unit of the model, for messages and projects")
      ->check(CLI::IsMember({"mm", "cm", "m", "in", "ft"}));
  command.add_flag("--quiet", options->quiet, "No progress and no summary; errors and warnings still appear");
}

// What steers an optimisation. Returned: what means nothing where there is none.
std::vector<CLI::Option*> declare_wishes(CLI::App& command, const Options& options) {
  return {
      command
          .add_option("--freedom", options->settings.freedom,
                      "What may change of the planes: 'fixed', 'normals', or 'all' (normals and offsets, the "
                      "default)")
          ->transform(named_choice<Freedom>({{"fixed", Freedom::Fixed},
                                             {"normals", Freedom::Normals},
                                             {"all", Freedom::NormalsAndOffsets}})),
      command.add_option("--preset", options->preset,
                         "Weights and constraints for a purpose: " + names_of(presets())),
      command.add_option("--weights", options->weights,
                         "Weights of the energies, over the preset's: position=1,fairing=0.1"),
      command.add_option("--reference", options->reference,
                         "Mesh that 'closeness' refers to, instead of IN (.obj .off .ply .stl)"),
      command
          .add_option(
              "--max-iterations", options->settings.max_iterations,
              "Stop a solve after this many steps; each further round of solves (renewed foot points, "
              "conflicts set aside, crossings separated) begins to count anew")
          ->check(CLI::Range(0, 1000000)),
      command
          .add_option("--tolerance", options->settings.tolerance,
                      "First-order residual at which the solve counts as converged (weights relative to the "
                      "largest, lengths in mean edges)")
          ->check(finite_number())
          ->check(positive_number())};
}

std::vector<CLI::Option*> declare_demands(CLI::App& command, const Options& options) {
  return {
      command
          .add_option(
              "--constraint", options->constraints,
              "What has to hold: NAME[=VALUE[:VALUE...]][@SELECTION], model units, an empty value takes "
              "its default; may be given several times, and all then hold. Names: " +
                  names_of(demand_catalogue()))
          ->expected(1)
          ->take_all(),
      command.add_flag("--no-penetration", options->no_penetration,
                       "Panels stay clear of the mesh: constraints vertex, face and edge, and a test of the "
                       "finished panels"),
      command
          .add_option("--margin", options->settings.demands.margin,
                      "By how much inequalities are met, mean edges (default 1e-4)")
          ->check(finite_number())
          ->check(not_negative()),
      command
          .add_option(
              "--side", options->settings.side,
              "Side of the mesh that the panels lie on, 'outside' or 'inside' (default: by the offset)")
          ->transform(named_choice<Side>({{"outside", Side::Outside}, {"inside", Side::Inside}})),
      command.add_option("--select", options->selections,
                         "File of named selections, for --constraint ...@NAME"),
      command.add_option("--pin", options->pins, "File of pinned points and planes"),
      command
          .add_option(
              "--waive", options->waive,
              "Earlier report: the constraints it names as conflicts are given up where they conflict")
          ->expected(1)
          ->take_all()};
}

std::vector<CLI::Option*> declare_layers(CLI::App& command, const Options& options) {
  return {command.add_option(
      "--layers", options->layers,
      "Several layers: NAME=OFFSET,NAME=OFFSET,... or a .json file with settings for each")};
}

void declare_outputs(CLI::App& command, const Options& options) {
  command.add_option("-o,--output", options->output, "Panels to write (.obj .off .ply .stl)")->required();
  command
      .add_option(
          "--thickness", options->thickness,
          "Also write the panels' parallel offset by this thickness (OUT with '-offset'), model units, "
          "negative to the inside")
      ->check(finite_number());
  command.add_option("--beams", options->beams,
                     "Also write the beams between the panels and their offset, or between two layers");
}

}  // namespace

std::vector<CLI::Option*> declare_unwritten_solve_options(CLI::App& command, const Options& options) {
  declare_files(command, options);
  auto* offset = command
                     .add_option("--offset", options->settings.offset,
                                 "Wanted distance from the input along its normals, model units")
                     ->check(finite_number());
  std::vector<std::pair<std::string, SolverKind>> solvers;
  for (const SolverKind kind : all_solvers()) solvers.emplace_back(name(kind), kind);
  auto* solver =
      command
          .add_option(
              "--solver", options->solver,
              "'tangent': the fast structured solver; 'ipopt': the general one; 'auto' (the default): "
              "tangent first, then Ipopt from there to confirm")
          ->transform(named_choice(std::move(solvers)));
  auto* explicit_points = command.add_flag(
      "--explicit", options->explicit_points,
      "No optimisation: intersect the tangent planes directly (the baseline), and say where that fails");
  explicit_points->excludes(solver);
  std::vector<CLI::Option*> steering{solver, offset, explicit_points};
  for (const auto& declare : {declare_wishes, declare_demands, declare_layers})
    for (CLI::Option* option : declare(command, options)) {
      explicit_points->excludes(option);
      steering.push_back(option);
    }
  return steering;
}

void declare_solve_options(CLI::App& command, const Options& options) {
  declare_unwritten_solve_options(command, options);
  declare_outputs(command, options);
}

CLI::Option* declare_border_option(CLI::App& command, const Options& options) {
  return command
      .add_option("--border", options->settings.border,
                  "'closed': the outline of the design survives (default); 'interior': panels of inner "
                  "vertices alone")
      ->transform(named_choice<BorderPolicy>(
          {{"closed", BorderPolicy::Closed}, {"interior", BorderPolicy::Interior}}));
}

}  // namespace planewright::cli
