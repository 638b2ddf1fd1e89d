#include "cli/cluster_options.h"

#include <string>
#include <utility>

#include "cli/finite_number.h"
#include "cli/named_choice.h"
#include "core/base/atomic_file.h"
#include "core/design/face_list.h"
#include "core/design/region_file.h"

namespace planewright::cli {
namespace {

// A list is told from a file's name by what it is made of.
bool is_list(const std::string& text) {
  return text.find_first_not_of("0123456789,- ") == std::string::npos;
}

Result<std::vector<int>> read_seed_faces(const std::string& text, int faces) {
  if (is_list(text)) {
    auto list = parse_face_list(text, "--seed-faces", faces);
    if (list) return list;
    return fail(ErrorCode::Usage, list.error().what, "--seed-faces", list.error().remedy);
  }
  const auto content = read_file(text);
  if (!content) return tl::unexpected(content.error());
  return parse_face_list(*content, text, faces);
}

Result<void> seed_at(const RegionRequest& request, int faces, ClusterOptions& options) {
  if (request.seeds || request.seed_number)
    return fail(ErrorCode::Usage, "regions start at the faces given, and cannot start elsewhere too",
                "--seed-faces", "Leave out --seeds and --seed");
  if (request.error)
    return fail(ErrorCode::Usage,
                "seed faces say how many regions there are, but --error asks for the number", "--seed-faces",
                "Give one of the two");
  auto list = read_seed_faces(request.seed_faces, faces);
  if (!list) return tl::unexpected(list.error());
  options.seeds = SeedKind::Given;
  options.given = std::move(*list);
  options.panels = request.panels.value_or(static_cast<int>(options.given.size()));
  return {};
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
  command.add_option(
      "--seed-faces", request->seed_faces,
      "Faces that regions start at, one each: 3,17,40-44, or a file of such (instead of --seeds; K is "
      "their number)");
  command.add_option("--from-regions", request->from_regions,
                     "CSV file as --regions writes it: takes these regions instead of finding some");
  command.add_option("--regions", request->regions,
                     "CSV file to write: the region of each face, which is the number of its panel");
}

std::vector<NamedFile> inputs_of(const RegionRequest& request) {
  std::vector<NamedFile> files{{"--from-regions", request.from_regions}};
  if (!is_list(request.seed_faces)) files.push_back({"--seed-faces", request.seed_faces});
  return files;
}

ClusterMetric metric_of(const RegionRequest& request) {
  ClusterMetric metric;
  if (request.metric)
    metric = *request.metric == MetricChoice::L2 ? ClusterMetric::l2() : ClusterMetric::l21();
  if (request.normal) metric.normal = *request.normal;
  if (request.distance) metric.distance = *request.distance;
  if (request.compactness) metric.compactness = *request.compactness;
  return metric;
}

Result<std::vector<int>> read_regions(const RegionRequest& request, int faces) {
  if (request.panels || request.error || request.seeds || request.seed_number || !request.seed_faces.empty())
    return fail(ErrorCode::Usage, "the regions are given, and need not be found", "--from-regions",
                "Leave out --panels, --error, --seeds, --seed and --seed-faces");
  const auto content = read_file(request.from_regions);
  if (!content) return tl::unexpected(content.error());
  return parse_region_csv(*content, request.from_regions, faces);
}

Result<ClusterOptions> cluster_options(const RegionRequest& request, int faces) {
  ClusterOptions options;
  options.metric = metric_of(request);
  if (!request.seed_faces.empty()) {
    if (auto seeded = seed_at(request, faces, options); !seeded) return tl::unexpected(seeded.error());
    return options;
  }
  if (!request.panels && !request.error)
    return fail(ErrorCode::Usage, "how many panels there are to be is not said", "--panels",
                "Give --panels K, --error E, --seed-faces or --from-regions");
  if (request.seed_number && request.seeds == SeedKind::Farthest)
    return fail(ErrorCode::Usage, "a number is for random seeds, but these are to be farthest", "--seed",
                "Leave it out, or give --seeds random");
  options.panels = request.panels.value_or(faces);
  if (request.error)
    (options.metric.normal > 0.0 ? options.target_normal : options.target_distance) = request.error;
  options.seeds = request.seeds.value_or(request.seed_number ? SeedKind::Random : SeedKind::Farthest);
  options.seed_number = request.seed_number.value_or(options.seed_number);
  return options;
}

Error as_given(Error error) {
  for (const auto& [setting, option] : {std::pair{"panels", "--panels"},
                                        {"target", "--error"},
                                        {"metric", "--metric"},
                                        {"seeds", "--seed-faces"}})
    if (error.where == setting) error.where = option;
  return error;
}

}  // namespace planewright::cli
