// What `planewright-cli export` takes. Threads: plain values.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/fabricate/export_run.h"
#include "core/workshop/contract.h"

namespace planewright::cli {

struct ExportOptions {
  std::string input, folder;
  std::vector<std::string> formats;
  std::string unit;        // of a mesh; empty: not given
  std::string layer;       // of a project; empty: its first
  std::string sheet;       // "3210x6000", "none"; empty: not given
  std::string tolerances;  // file
  std::string keep_names;  // an earlier schedule
  std::string reference;   // surface for the distance
  std::string up = "z";
  std::optional<double> thickness, gap, density;
  std::optional<double> planarity, distance, edge_min, edge_max, area_min, area_max, interior_min,
      interior_max, dihedral_min, dihedral_max;
  std::optional<NameStyle> names;
  NestingOptions nesting;
  CongruenceOptions congruence;
  LabelOptions labels;
  TitleBlock title;
  OnFailure on_failure = OnFailure::Mark;
  DxfVersion dxf = DxfVersion::R2000;
  bool overwrite = false, quiet = false;
};

void declare_export_options(CLI::App& command, const std::shared_ptr<ExportOptions>& options);

// The contract that `project` has (or the default), with what the options say otherwise. Fails with
// ErrorCode::Usage (a minimum above its maximum, an unreadable size), Unreadable (the file of tolerances).
Result<WorkshopContract> contract_of(const ExportOptions& options, WorkshopContract project);

// Formats, nesting, labels and the rest. Fails with ErrorCode::Usage.
Result<ExportSettings> export_settings(const ExportOptions& options, const WorkshopContract& contract);

}  // namespace planewright::cli
