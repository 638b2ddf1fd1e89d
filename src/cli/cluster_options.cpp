#include "cli/cluster_options.h"

#include <string>
#include <utility>

#include "cli/finite_number.h"
#include "cli/named_choice.h"

namespace planewright::cli {
namespace {

ClusterMetric metric_of(const RegionRequest& request) {
  ClusterMetric metric;
  if (request.metric)
    metric = *request.metric == MetricChoice::L2 ? ClusterMetric::l2() : ClusterMetric::l21();
  if (request.normal) metric.normal = *request.normal;
  if (request.distance) metric.distance = *request.distance;
  if (request.compactness) metric.compactness = *request.compactness;
  return metric;
}

}  // namespace

void declare_region_options(CLI::App& command, const std::shared_ptr<RegionRequest>& request) {
  command.add_option(
      "--panels", request->panels,
      "How many regions; repairs may change it, and say so. With --error the most that may be used");
  command
      .add_option(
          "--error", request->error,
          "Instead of a number of panels: the fewest found whose regions meet this error, the root mean "
          "square "
          "of the normals' difference (about radians), or with --metric l2 of the distance to the planes "
          "(share of the square root of the area)")
      ->check(finite_number())
      ->check(positive_number());
  command
      .add_option("--metric", request->metric,
                  "'l21': normals alone; 'l2': distances alone (default: both, with some compactness)")
      ->transform(named_choice<MetricChoice>({{"l21", MetricChoice::L21}, {"l2", MetricChoice::L2}}));
  const auto weight = [&](const char* option, std::optional<double>& value, const char* description) {
    command.add_option(option, value, description)->check(finite_number())->check(not_negative());
  };
  weight("--normal", request->normal, "Weight of normals in the metric, over that of --metric (default 1)");
  weight("--distance", request->distance, "Weight of distances to the planes (default 50)");
  weight("--compactness", request->compactness, "Weight of round regions (default 0.5; with --metric 0)");
  command
      .add_option("--seeds", request->seeds,
                  "Where regions start: 'farthest' from each other (default), or at 'random' faces")
      ->transform(named_choice<SeedKind>({{"random", SeedKind::Random}, {"farthest", SeedKind::Farthest}}));
  command.add_option("--seed", request->seed_number,
                     "Number of the random seeds (default 1); means --seeds random");
}

Result<ClusterOptions> cluster_options(const RegionRequest& request, int faces) {
  if (!request.panels && !request.error)
    return fail(ErrorCode::Usage, "how many panels there are to be is not said", "--panels",
                "Give --panels K, or --error E");
  if (request.seed_number && request.seeds == SeedKind::Farthest)
    return fail(ErrorCode::Usage, "a number is for random seeds, but these are to be farthest", "--seed",
                "Leave it out, or give --seeds random");
  ClusterOptions options;
  options.metric = metric_of(request);
  options.panels = request.panels.value_or(faces);
  if (request.error)
    (options.metric.normal > 0.0 ? options.target_normal : options.target_distance) = request.error;
  options.seeds = request.seeds.value_or(request.seed_number ? SeedKind::Random : SeedKind::Farthest);
  options.seed_number = request.seed_number.value_or(options.seed_number);
  return options;
}

Error as_given(Error error) {
  for (const auto& [setting, option] :
       {std::pair{"panels", "--panels"}, {"target", "--error"}, {"metric", "--metric"}, {"seeds", "--seeds"}})
    if (error.where == setting) error.where = option;
  return error;
}

}  // namespace planewright::cli
