// The options of `cluster` that say how faces become regions, as the user gave them.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/output_files.h"
#include "core/base/result.h"
#include "core/cluster/clustering.h"

namespace planewright::cli {

enum class MetricChoice { L21, L2 };

struct RegionRequest {
  std::optional<int> panels;
  std::optional<double> error;
  std::optional<MetricChoice> metric;
  std::optional<double> normal, distance, compactness;  // over the metric's
  std::optional<SeedKind> seeds;
  std::optional<std::uint32_t> seed_number;
  std::string seed_faces;    // "3,17,40-44", or a file of such; empty: not given
  std::string from_regions;  // file to read; empty: regions are found
  std::string regions;       // file to write; empty: not wanted
};

// Declares them on a command.
void declare_region_options(CLI::App& command, const std::shared_ptr<RegionRequest>& request);

// Files that are read, with the option that names each.
std::vector<NamedFile> inputs_of(const RegionRequest& request);

// The metric that its parts make.
ClusterMetric metric_of(const RegionRequest& request);

// The regions of from_regions, which has to be given. Fails as read_file() and parse_region_csv() do, and
// with ErrorCode::Usage beside options that say how to find regions.
Result<std::vector<int>> read_regions(const RegionRequest& request, int faces);

// What they mean for a mesh of so many faces. Fails with ErrorCode::Usage: neither panels nor error nor seed
// faces, a seed number for seeds that are not random, seed faces that go with other seeds or an error; as
// read_file() and parse_face_list() do for seed faces.
Result<ClusterOptions> cluster_options(const RegionRequest& request, int faces);

// An error of the clustering speaks of its settings; the user knows the options that they come from.
Error as_given(Error error);

}  // namespace planewright::cli
