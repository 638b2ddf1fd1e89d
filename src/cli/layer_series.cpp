#include "cli/layer_series.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "cli/layer_crossings.h"
#include "cli/output_files.h"
#include "cli/solve_summary.h"
#include "core/base/atomic_file.h"
#include "core/edit/project_file.h"
#include "core/export/solve_record.h"
#include "core/mesh/mesh_io.h"

namespace planewright::cli {
namespace {

// Of several layers the status of the worst: demands that contradict each other before anything else missed.
ExitStatus worse(ExitStatus a, ExitStatus b) {
  return std::max(a, b);
}

}  // namespace

Result<void> check_files(const SolveCommandOptions& options, const LayerPlan& plan,
                         const std::vector<NamedFile>& further_inputs,
                         const std::vector<NamedFile>& further_outputs) {
  std::vector<NamedFile> inputs = inputs_of(options);
  inputs.insert(inputs.end(), further_inputs.begin(), further_inputs.end());
  std::vector<NamedFile> outputs = outputs_of(plan);
  for (const NamedFile& output : outputs)
    if (!output.path.empty())
      if (const auto format = format_of(output.path); !format) return tl::unexpected(format.error());
  outputs.push_back({"--report", options.report});
  if (!options.project.empty() && !options.project.ends_with(kProjectEnding))
    return fail(ErrorCode::Usage, "the name does not end in " + std::string(kProjectEnding),
                "--project " + options.project, "Projects are known by that ending");
  outputs.push_back({"--project", options.project});
  outputs.insert(outputs.end(), further_outputs.begin(), further_outputs.end());
  return check_outputs(inputs, outputs);
}

Result<ExitStatus> solve_layers(const LayerPlan& plan, const SolveCommandOptions& options,
                                const DesignFiles& files, const HealthReport& health, double seconds_build,
                                std::vector<SolvedLayer>& solved) {
  std::vector<SolveRecord> records;
  ExitStatus status = kSuccess;
  for (const LayerJob& job : plan.jobs) {
    auto record = run_layer(plan.jobs, options, files, solved);
    if (!record) return tl::unexpected(record.error());
    record->health = health;
    record->seconds_build = seconds_build;
    record->seconds_total += seconds_build;
    // Told before the report is written: should that fail, the panels are there and how they are is known.
    if (!options.quiet) print_summary(*record, job.output, options.unit);
    std::fflush(stdout);  // the report may go to the same place (/dev/stdout), past this buffer
    status = worse(status, judge(*record));
    records.push_back(std::move(*record));
    if (records.back().solve.status == SolveStatus::Stopped && records.size() < plan.jobs.size()) {
      std::fprintf(stderr, "planewright-cli: warning: the layers after '%s' were not solved\n",
                   job.layer.name.c_str());
      break;
    }
  }
  count_crossings(solved, records);
  if (!options.quiet) print_crossings(records);
  std::fflush(stdout);
  status = worse(status, judge_crossings(records));
  if (!options.report.empty()) {
    const std::string json = options.layers.empty() ? to_json(records.front()) : to_json(records);
    if (auto saved = write_file_atomically(options.report, json); !saved)
      return tl::unexpected(saved.error());
  }
  return status;
}

void note_idle_reference(const LayerPlan& plan, const SolveCommandOptions& options) {
  const bool used = std::any_of(plan.jobs.begin(), plan.jobs.end(), [](const LayerJob& job) {
    const auto& weights = job.layer.settings.weights;
    const auto closeness = weights.find("closeness");
    return closeness != weights.end() && closeness->second > 0.0;
  });
  if (!options.reference.empty() && !used)
    std::fprintf(
        stderr,
        "planewright-cli: note: --reference changes nothing, because 'closeness' has no weight; give "
        "one with --weights closeness=1 or --preset close\n");
}

}  // namespace planewright::cli
