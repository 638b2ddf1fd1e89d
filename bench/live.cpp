#include "live.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/design/design.h"
#include "core/design/layer_solve.h"
#include "core/design/presets.h"
#include "core/solve/solver_choice.h"
#include "measurement.h"
#include "models.h"
#include "run_options.h"
#include "table.h"
#include "value_of.h"

namespace planewright::bench {
namespace {

constexpr double kStep = 0.03;    // of a weight, per step of its slider
constexpr double kPlanar = 1e-9;  // mean edges

// CPU, median, at so many panels.
struct Goal {
  int panels;
  double ms;
};
constexpr Goal kGoals[] = {{1024, 33.0}, {10000, 400.0}};

struct LiveRow {
  int panels = 0, frames = 0;
  SolveStatus warm = SolveStatus::Failed;
  double median_cpu = 0.0, worst_cpu = 0.0, median_wall = 0.0;  // until the frame, ms
  double median_turn = 0.0;                                     // CPU until the solver is free again, ms
  double residual = 0.0;  // of the worst frame: largest |n.(x - v) - h|, mean edges
};

// Takes the first planar state that a step made, and ends the solve there, as a slider that moves on does.
class FirstFrame final : public SolveObserver {
 public:
  explicit FirstFrame(std::stop_source& enough) : enough_(enough) {}
  void on_iteration(const Iteration& iteration, const State* shown) override {
    if (state || !shown || !iteration.planar || iteration.number < 1) return;
    cpu = cpu_seconds();
    wall = wall_seconds();
    state = *shown;
    enough_.request_stop();
  }
  std::optional<State> state;
  double cpu = 0.0, wall = 0.0;

 private:
  std::stop_source& enough_;
};

// The weight whose slider moves: one beside position, which alone would change nothing.
std::string slider_of(const LayerSettings& settings) {
  for (const auto& [name, weight] : settings.weights)
    if (name != "position" && weight > 0.0) return name;
  return "fairing";
}

// Up for half of the steps and down again, never twice the same; from 0 in shares of position's weight.
double weight_at(int step, int steps, double base, double position) {
  const int k = 1 + std::min(step, steps / 2 * 2 - step);
  return base > 0.0 ? base * std::pow(1.0 + kStep, k) : position * kStep * k;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

LiveRow drag_slider(const Model& model, const std::filesystem::path& meshes, const Preset& preset,
                    SolverKind kind, int steps) {
  LayerSettings settings;
  const auto complex = complex_of(model, meshes, settings);
  if (const auto applied = apply(preset, settings); !applied)
    throw std::runtime_error(applied.error().text());
  const std::string slider = slider_of(settings);
  const double base = settings.weights[slider], position = settings.weights["position"];
  const auto solver = make_solver(kind);
  const SolveReport converged =
      value_of(solve_layer(*solver, {complex, settings, {}, {}, {}}, start_state(*complex, settings),
                           solve_options(settings), nullptr, {}));
  LiveRow row;
  row.panels = complex->plane_count();
  row.warm = converged.status;
  State at = converged.state;
  std::vector<double> cpu, wall, turn;
  for (int step = 0; step < steps; ++step) {
    settings.weights[slider] = weight_at(step, steps, base, position);
    std::stop_source enough;
    FirstFrame frame(enough);
    const double cpu_begun = cpu_seconds(), wall_begun = wall_seconds();
    const auto problem = value_of(build_problem(complex, settings, {}, {&at, {}, {}, {}}));
    SolveOptions options = solve_options(settings);
    options.near_solution = true;
    options.abandoned = enough.get_token();
    const SolveReport report = solver->solve(*problem, start_state(*complex, settings, complex.get(), &at),
                                             options, &frame, enough.get_token());
    turn.push_back(1e3 * (cpu_seconds() - cpu_begun));
    if (frame.state) {
      cpu.push_back(1e3 * (frame.cpu - cpu_begun));
      wall.push_back(1e3 * (frame.wall - wall_begun));
      row.residual =
          std::max(row.residual,
                   incidence_residuals(*complex, *frame.state).cwiseAbs().maxCoeff() / complex->mean_edge);
    }
    at = frame.state ? *frame.state : report.state;
  }
  row.frames = static_cast<int>(cpu.size());
  row.median_cpu = median(cpu);
  row.worst_cpu = cpu.empty() ? 0.0 : *std::max_element(cpu.begin(), cpu.end());
  row.median_wall = median(wall);
  row.median_turn = median(turn);
  return row;
}

// "met", or what is wrong; nothing where there is no goal for that size.
std::string judged(const LiveRow& row, int steps) {
  if (row.warm != SolveStatus::Converged) return "unconverged start";
  if (row.frames < steps) return "frames are missing";
  if (row.residual > kPlanar) return "frames are not planar";
  for (const Goal& goal : kGoals)
    if (row.panels == goal.panels) return row.median_cpu <= goal.ms ? "met" : "MISSED";
  return {};
}

struct LiveOptions : RunOptions {
  std::vector<std::string> presets;
  int steps = 24;
};

void print(const std::string& name, const std::string& solver, const ChildOutcome<LiveRow>& outcome,
           int steps) {
  const LiveRow& row = outcome.value;
  if (outcome.end != ChildEnd::Finished) {
    std::printf("%-26s %-7s %s\n", name.c_str(), solver.c_str(), outcome.why.c_str());
  } else {
    std::printf("%-26s %-7s %6d %3d/%-3d ", name.c_str(), solver.c_str(), row.panels, row.frames, steps);
    if (row.frames > 0)
      std::printf("%8.1f %8.1f %8.1f %8.1f %9.1e", row.median_cpu, row.worst_cpu, row.median_wall,
                  row.median_turn, row.residual);
    else
      std::printf("%8s %8s %8s %8.1f %9s", "-", "-", "-", row.median_turn, "-");
    std::printf("  %s\n", judged(row, steps).c_str());
  }
  std::fflush(stdout);
}

void measure_live(const LiveOptions& options) {
  const std::filesystem::path meshes = meshes_folder(options.meshes);
  const std::vector<Model> models = find_models(options.models);
  std::vector<const Preset*> chosen;
  for (const std::string& name : options.presets) chosen.push_back(value_of(find_preset(name)));
  std::vector<SolverKind> solvers;
  for (const std::string& name : options.only) solvers.push_back(value_of(find_solver(name)));
  std::printf(
      "From a converged state one weight, the one beside position (fairing from 0 where there is none),\n"
      "changes by %g %% a step. A step starts at the newest state shown and ends at the first planar one\n"
      "that an iteration of it made. frame: from the change, building the problem included, to that state;\n"
      "turn: until the solver is free for the next one; both are medians. residual: the worst frame's\n"
      "(<= %g). Goals, CPU of a frame: %g ms at %d panels, %g ms at %d.\n\n",
      100.0 * kStep, kPlanar, kGoals[0].ms, kGoals[0].panels, kGoals[1].ms, kGoals[1].panels);
  std::printf("%-26s %-7s %6s %7s %8s %8s %8s %8s %9s\n", "", "solver", "panels", "frames", "frame", "worst",
              "frame", "turn", "residual");
  std::printf("%-26s %-7s %6s %7s %8s %8s %8s %8s %9s\n", "", "", "", "", "CPU ms", "CPU ms", "wall ms",
              "CPU ms", "edges");
  for (const Model& model : models) {
    if (!available(model, meshes)) {
      print_skipped(model.name, "there is no " + model.file + "; name its folder with --meshes");
      continue;
    }
    for (const Preset* preset : chosen) {
      for (const SolverKind kind : solvers) {
        const std::function<LiveRow()> drag = [&] {
          return drag_slider(model, meshes, *preset, kind, options.steps);
        };
        auto best = run_in_child(drag, options.limits);
        for (int k = 1; k < options.repeat && best.end == ChildEnd::Finished; ++k) {
          auto next = run_in_child(drag, options.limits);
          if (next.end != ChildEnd::Finished || next.value.median_cpu < best.value.median_cpu) best = next;
        }
        print(model.name + ' ' + preset->name, name(kind), best, options.steps);
      }
    }
  }
}

}  // namespace

void declare_live(CLI::App& app) {
  auto options = std::make_shared<LiveOptions>();
  options->only = {"tangent"};
  options->models = {"torus-1k", "torus-10k"};
  for (const Preset& preset : presets())
    if (preset.for_dual) options->presets.push_back(preset.name);
  CLI::App* command =
      app.add_subcommand("live", "Time from a slider's move to the first planar panels, on the torus");
  command->add_option("--only", options->only, "Solvers: tangent, auto, ipopt")
      ->delimiter(',')
      ->capture_default_str();
  command->add_option("--presets", options->presets, "Presets for duals")
      ->delimiter(',')
      ->capture_default_str();
  command->add_option("--steps", options->steps, "Steps of the slider")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  declare_models(*command, *options);
  command->callback([options] { measure_live(*options); });
}

}  // namespace planewright::bench
