// The options of `cluster` that say how faces become regions, as the user gave them.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <memory>
#include <optional>

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
};

// Declares them on a command.
void declare_region_options(CLI::App& command, const std::shared_ptr<RegionRequest>& request);

// What they mean for a mesh of so many faces. Fails with ErrorCode::Usage: neither panels nor error, a seed
// number for seeds that are not random.
Result<ClusterOptions> cluster_options(const RegionRequest& request, int faces);

// An error of the clustering speaks of its settings; the user knows the options that they come from.
Error as_given(Error error);

}  // namespace planewright::cli
