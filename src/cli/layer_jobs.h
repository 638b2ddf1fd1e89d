// The layers that one run solves: settings and file names of each, decided before the work begins.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/design_files.h"
#include "cli/layers_option.h"
#include "cli/output_files.h"
#include "cli/solve_options.h"
#include "cli/steering.h"
#include "core/base/result.h"
#include "core/design/cluster_report.h"
#include "core/design/layer_settings.h"

namespace planewright::cli {

struct LayerJob {
  Layer layer;
  std::string preset;                               // empty: none
  bool named = false;                               // by --layers; else it is the only one
  Steering steering;                                // of its own, over that of all
  std::string output, offset_output, beams_output;  // empty: not asked for
  int beams_to = -1;                                // an earlier layer; -1: its own parallel offset
  std::shared_ptr<const TangentComplex> complex;    // by prepare_layers
  std::shared_ptr<const ClusteredMesh> clustered;   // by prepare_layers; null: not of clusters
};

struct LayerPlan {
  Steering common;
  std::vector<LayerJob> jobs;  // at least one
  // The regions that all layers are made of, before prepare_layers() for ComplexKind::Cluster; else null.
  std::shared_ptr<const ClusteredMesh> clustered;
};

// What needs no mesh: names, options that are texts, files to write. Fails with ErrorCode::Usage or
// Unreadable as the parsers do; --beams without --thickness or a second layer.
Result<LayerPlan> plan_layers(const SolveCommandOptions& options);

// All files that a run reads, by the option that names them.
std::vector<NamedFile> inputs_of(const SolveCommandOptions& options);
// All files that the jobs will write, by the option that asks for them.
std::vector<NamedFile> outputs_of(const LayerPlan& plan);

// Complexes, settings (mode: decided) and pins of all jobs. Fails as the builders do, as steer() and
// Problem::create do (a demand that does not exist, that contradicts another, ...), so that nothing is solved
// in vain.
Result<void> prepare_layers(LayerPlan& plan, const SolveCommandOptions& options, ComplexKind mode,
                            const DesignFiles& files, const PolygonMesh& mesh);

}  // namespace planewright::cli
