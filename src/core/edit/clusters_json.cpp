#include "core/edit/clusters_json.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace planewright {
namespace {

using Json = nlohmann::json;
using Written = nlohmann::ordered_json;

constexpr std::pair<SeedKind, const char*> kSeeds[] = {
    {SeedKind::Random, "random"}, {SeedKind::Farthest, "farthest"}, {SeedKind::Given, "given"}};

void read_target(JsonReading& reading, JsonObject& object, const char* key, std::optional<double>& target) {
  const Json* json = object.find(key);
  if (!json) return;
  target = reading.number(*json, object.path_of(key));
  if (!reading.failed() && !(*target > 0.0))
    object.fail(key, "a target has to be above 0", "Leave it out for none");
}

ClusterMetric read_metric(JsonReading& reading, const Json* json, const std::string& path) {
  JsonObject object(reading, json, path);
  ClusterMetric metric;
  object.read_not_negative("normal", metric.normal);
  object.read_not_negative("distance", metric.distance);
  object.read_not_negative("compactness", metric.compactness);
  return metric;
}

ClusterOptions read_options(JsonReading& reading, JsonObject& object) {
  ClusterOptions options;
  object.read("panels", options.panels, 1);
  read_target(reading, object, "target_normal", options.target_normal);
  read_target(reading, object, "target_distance", options.target_distance);
  options.metric = read_metric(reading, object.find("metric"), object.path_of("metric"));
  object.read<SeedKind>("seeds", options.seeds, kSeeds);
  if (const Json* json = object.find("seed_number")) {
    const double number = reading.number(*json, object.path_of("seed_number"));
    if (!(number >= 0.0 && number <= std::numeric_limits<std::uint32_t>::max()) ||
        number != std::floor(number))
      object.fail("seed_number", "the number is no whole one of 32 bits");
    else
      options.seed_number = static_cast<std::uint32_t>(number);
  }
  // Of the mesh as it was clustered: edits may have left fewer faces.
  if (const Json* json = object.find("seed_faces"))
    options.given =
        reading.integers(*json, object.path_of("seed_faces"), 0, std::numeric_limits<int>::max());
  object.read("iterations", options.iterations, 0);
  object.read("teleports", options.teleports, 0);
  return options;
}

}  // namespace

Written clusters_json(const ClusterRecord& clusters) {
  const ClusterOptions& options = clusters.options;
  Written json = {{"panels", options.panels}};
  if (options.target_normal) json["target_normal"] = *options.target_normal;
  if (options.target_distance) json["target_distance"] = *options.target_distance;
  json["metric"] = {{"normal", options.metric.normal},
                    {"distance", options.metric.distance},
                    {"compactness", options.metric.compactness}};
  json["seeds"] = word_for<SeedKind>(options.seeds, kSeeds);
  json["seed_number"] = options.seed_number;
  if (!options.given.empty()) json["seed_faces"] = options.given;
  json["iterations"] = options.iterations;
  json["teleports"] = options.teleports;
  json["target_met"] = clusters.target_met;
  json["given"] = clusters.given;
  json["regions"] = clusters.region_of_face;
  return json;
}

ClusterRecord read_clusters(JsonReading& reading, const Json& json, const std::string& path, int faces) {
  JsonObject object(reading, &json, path);
  ClusterRecord clusters;
  clusters.options = read_options(reading, object);
  object.read("target_met", clusters.target_met);
  object.read("given", clusters.given);
  const Json* regions = object.needed("regions");
  if (!regions) return clusters;
  clusters.region_of_face = reading.integers(*regions, object.path_of("regions"), 0, std::max(faces - 1, 0));
  if (!reading.failed() && clusters.region_of_face.size() != static_cast<std::size_t>(faces))
    object.fail("regions",
                "there are regions of " + std::to_string(clusters.region_of_face.size()) +
                    " faces, but the mesh has " + std::to_string(faces),
                "Give the region of each face");
  return clusters;
}

}  // namespace planewright
