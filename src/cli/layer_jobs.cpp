#include "cli/layer_jobs.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "cli/constraint_option.h"
#include "cli/weights_option.h"
#include "core/design/design.h"
#include "core/design/presets.h"

namespace planewright::cli {
namespace {

constexpr const char* kCoplanarBeams = "coplanar-beams";

// "panels.obj", "outer" -> "panels-outer.obj"
std::string with_suffix(const std::string& file, const std::string& suffix) {
  const std::filesystem::path path(file);
  return (path.parent_path() / (path.stem().string() + "-" + suffix + path.extension().string())).string();
}

Result<Steering> common_steering(const SolveCommandOptions& options) {
  Steering steering;
  if (!options.preset.empty()) {
    if (auto preset = find_preset(options.preset); !preset) {
      Error error = preset.error();
      error.where = "--preset";
      return tl::unexpected(std::move(error));
    }
    steering.preset = options.preset;
  }
  if (!options.weights.empty()) {
    auto weights = parse_weights(options.weights);
    if (!weights) return tl::unexpected(weights.error());
    steering.weights = std::move(*weights);
  }
  for (const std::string& text : options.constraints) {
    auto demand = parse_constraint(text);
    if (!demand) return tl::unexpected(demand.error());
    steering.demands.push_back(std::move(*demand));
  }
  if (options.no_penetration) steering.no_penetration = true;
  return steering;
}

LayerJob job_of(const LayerRequest& request, const SolveCommandOptions& options) {
  LayerJob job;
  job.named = true;
  job.steering = request.steering;
  job.layer.name = request.name;
  job.layer.settings = options.settings;
  if (request.offset) job.layer.settings.offset = *request.offset;
  job.layer.thickness = request.thickness.value_or(options.thickness);
  job.layer.coplanar_with = request.coplanar_with;
  job.output = with_suffix(options.output, request.name);
  return job;
}

// Which beams there are: to the layer's own offset if it has one, else to the layer it is made to fit, else
// to the one before.
Result<void> plan_beams(std::vector<LayerJob>& jobs, const std::string& file) {
  if (file.empty()) return {};
  std::vector<LayerJob*> with_beams;
  for (size_t k = 0; k < jobs.size(); ++k) {
    LayerJob& job = jobs[k];
    if (job.layer.thickness == 0.0) {
      if (k == 0) continue;
      job.beams_to = job.layer.coplanar_with >= 0 ? job.layer.coplanar_with : static_cast<int>(k) - 1;
    }
    with_beams.push_back(&job);
  }
  if (with_beams.empty())
    return fail(ErrorCode::Usage, "there is nothing for the beams to join", "--beams",
                "Give --thickness for a parallel offset, or several layers with --layers");
  for (LayerJob* job : with_beams)
    job->beams_output = with_beams.size() == 1 ? file : with_suffix(file, job->layer.name);
  return {};
}

// "coplanar-beams" needs a layer to fit: the one that is named, else the one before. The first has none and
// goes without, unless it is the only one (Problem::create then says so).
void join_layers(LayerJob& job, int index, size_t count) {
  auto& demands = job.layer.settings.demands.list;
  const auto demanded = std::find_if(demands.begin(), demands.end(),
                                     [](const Demand& demand) { return demand.name == kCoplanarBeams; });
  if (job.layer.coplanar_with >= 0) {
    if (demanded == demands.end()) demands.push_back({kCoplanarBeams, true, {}, {}});
  } else if (demanded != demands.end() && index > 0) {
    job.layer.coplanar_with = index - 1;
  } else if (demanded != demands.end() && count > 1) {
    std::erase_if(demands, [](const Demand& demand) { return demand.name == kCoplanarBeams; });
  }
}

// A problem speaks of its settings; the user knows the options that they come from.
Error as_given(Error error, const LayerJob& job) {
  for (const auto& [setting, option] :
       {std::pair{"demands", "--constraint"}, {"margin", "--margin"}, {"weights", "--weights"}})
    if (error.where == setting)
      error.where = option + (job.named ? " of layer '" + job.layer.name + "'" : "");
  return error;
}

// Whether the problem can be stated; nothing is solved.
Result<void> check_problem(const LayerPlan& plan, const LayerJob& job, const DesignFiles& files) {
  const LayerSettings& settings = job.layer.settings;
  const State start = start_state(*job.complex, settings);
  FrozenGeometry frozen;
  frozen.at = &start;
  frozen.reference = files.reference;
  if (job.layer.coplanar_with >= 0) {
    const LayerJob& other = plan.jobs[static_cast<size_t>(job.layer.coplanar_with)];
    frozen.neighbour = std::make_shared<NeighbourLayer>(
        NeighbourLayer{other.complex, start_state(*other.complex, other.layer.settings)});
  }
  const auto problem = build_problem(job.complex, settings, files.selections, frozen);
  return problem ? Result<void>() : tl::unexpected(as_given(problem.error(), job));
}

}  // namespace

Result<LayerPlan> plan_layers(const SolveCommandOptions& options) {
  LayerPlan plan;
  auto steering = common_steering(options);
  if (!steering) return tl::unexpected(steering.error());
  plan.common = std::move(*steering);
  if (options.layers.empty()) {
    LayerJob job;
    job.layer.settings = options.settings;
    job.layer.thickness = options.thickness;
    job.output = options.output;
    plan.jobs.push_back(std::move(job));
  } else {
    const auto requests = parse_layers(options.layers);
    if (!requests) return tl::unexpected(requests.error());
    for (const LayerRequest& request : *requests) plan.jobs.push_back(job_of(request, options));
  }
  for (LayerJob& job : plan.jobs) {
    job.preset = job.steering.preset.empty() ? plan.common.preset : job.steering.preset;
    if (job.layer.thickness != 0.0) job.offset_output = with_suffix(job.output, "offset");
  }
  if (auto beams = plan_beams(plan.jobs, options.beams); !beams) return tl::unexpected(beams.error());
  return plan;
}

std::vector<NamedFile> inputs_of(const SolveCommandOptions& options) {
  std::vector<NamedFile> files{{"IN", options.input},
                               {"--select", options.selections},
                               {"--pin", options.pins},
                               {"--reference", options.reference}};
  for (const std::string& report : options.waive) files.push_back({"--waive", report});
  if (options.layers.ends_with(".json")) files.push_back({"--layers", options.layers});
  return files;
}

std::vector<NamedFile> outputs_of(const LayerPlan& plan) {
  std::vector<NamedFile> files;
  for (const LayerJob& job : plan.jobs) {
    const std::string of_layer = job.named ? " of layer '" + job.layer.name + "'" : "";
    files.push_back({"-o" + of_layer, job.output});
    files.push_back({"the offset" + of_layer, job.offset_output});
    files.push_back({"--beams" + of_layer, job.beams_output});
  }
  return files;
}

Result<void> prepare_layers(LayerPlan& plan, const SolveCommandOptions& options, ComplexKind mode,
                            const DesignFiles& files, const PolygonMesh& mesh) {
  for (size_t k = 0; k < plan.jobs.size(); ++k) {
    LayerJob& job = plan.jobs[k];
    LayerSettings& settings = job.layer.settings;
    settings.mode = mode;
    Steering common = plan.common;
    if (job.steering.no_penetration) common.no_penetration = job.steering.no_penetration;
    if (auto steered = steer(common, settings); !steered) return steered;
    if (auto steered = steer(job.steering, settings); !steered) {
      Error error = steered.error();
      error.where = "--layers, layer '" + job.layer.name + "'";
      return tl::unexpected(std::move(error));
    }
    join_layers(job, static_cast<int>(k), plan.jobs.size());
    job.clustered = plan.clustered;
    auto complex = build_complex(mesh, settings, plan.clustered ? &plan.clustered->regions : nullptr);
    if (!complex) return tl::unexpected(complex.error());
    job.complex = std::move(*complex);
    if (auto pinned = add_pins(files.pins, *job.complex, settings.demands); !pinned) return pinned;
    auto waived = read_waived(options.waive, job.named ? job.layer.name : std::string(), *job.complex);
    if (!waived) return tl::unexpected(waived.error());
    settings.demands.waived = std::move(*waived);
    if (!options.explicit_points)
      if (auto possible = check_problem(plan, job, files); !possible) return possible;
  }
  return {};
}

}  // namespace planewright::cli
