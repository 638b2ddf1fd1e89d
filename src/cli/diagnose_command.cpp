// planewright-cli diagnose IN [--mode dual|planarize] [--as-is]: solves as dual and planarize would and tells
// where the panels are bad, why, and which edits of the mesh would better them. Writes no panels.
#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/design_files.h"
#include "cli/edit_progress.h"
#include "cli/finding_options.h"
#include "cli/findings_table.h"
#include "cli/layer_jobs.h"
#include "cli/layer_run.h"
#include "cli/named_choice.h"
#include "cli/output_files.h"
#include "cli/solve_options.h"
#include "cli/suggestions_table.h"
#include "core/advise/advisor.h"
#include "core/base/atomic_file.h"
#include "core/design/design.h"
#include "core/export/diagnosis_record.h"
#include "core/mesh/mesh_io.h"

namespace planewright::cli {
namespace {

// How far corners of panels that a file holds may lie from their planes, mean edges: files of other programs
// have few digits.
constexpr double kPlanarAsIs = 1e-4;

struct DiagnoseOptions {
  std::shared_ptr<SolveCommandOptions> solve = std::make_shared<SolveCommandOptions>();
  std::optional<ComplexKind> mode;      // none: whichever fits the mesh
  std::vector<std::string> only;        // kinds, by name; empty: all
  std::vector<std::string> thresholds;  // KIND=VALUE
  bool as_is = false, json = false, no_suggestions = false;
};

Result<FindingSettings> settings_of(const DiagnoseOptions& options) {
  auto settings = parse_finding_settings(options.only, options.thresholds);
  if (settings && options.as_is) settings->planar = kPlanarAsIs;
  return settings;
}

Result<std::vector<DiagnosisRecord>> diagnose_as_is(const PolygonMesh& mesh,
                                                    const FindingSettings& settings) {
  LayerSettings layer;
  layer.mode = ComplexKind::Planarize;
  const auto complex = build_complex(mesh, layer);
  if (!complex) return tl::unexpected(complex.error());
  DiagnosisRecord record;
  record.complex = *complex;
  record.diagnosis = diagnose(**complex, initial_state(**complex), settings);
  return std::vector{std::move(record)};
}

// Rates the edits that may help; what keeps it from that is told, and no failure.
void suggest(DiagnosisRecord& record, const LayerJob& job, const DesignFiles& files,
             const std::shared_ptr<const PolygonMesh>& mesh, bool quiet) {
  if (!record.solve || !record.diagnosis.solved || record.solve->status == SolveStatus::Stopped) return;
  const Advised advised{
      mesh, job.complex, record.solve->state, job.layer.settings, files.selections, files.reference};
  const auto solver = PatchSolver::create(advised);
  if (!solver) {
    record.unrated = solver.error().text();
    return;
  }
  EditProgress progress(quiet);
  AdviceOptions options;
  options.progress = [&](int rated, int of) { progress.on_rated(0, rated, of); };
  record.suggestions =
      rate(*solver, find_candidates(advised, record.diagnosis.findings), options, {}, progress.stop_token());
}

Result<std::vector<DiagnosisRecord>> diagnose_solved(LayerPlan& plan, const SolveCommandOptions& options,
                                                     ComplexKind mode,
                                                     const std::shared_ptr<const PolygonMesh>& mesh,
                                                     const FindingSettings& settings, bool no_suggestions) {
  const auto files = read_design_files(options, *mesh);
  if (!files) return tl::unexpected(files.error());
  if (auto prepared = prepare_layers(plan, options, mode, *files, *mesh); !prepared)
    return tl::unexpected(prepared.error());
  std::vector<SolvedLayer> solved;
  std::vector<DiagnosisRecord> records;
  for (LayerJob& job : plan.jobs) {
    auto report = solve_job(job, options, *files, solved);
    if (!report) return tl::unexpected(report.error());
    // Beams go to the layer that this one is made to fit, else to the one before.
    if (job.layer.coplanar_with < 0) job.layer.coplanar_with = static_cast<int>(solved.size()) - 1;
    DiagnosisRecord record;
    if (job.named) record.layer = job.layer.name;
    record.complex = job.complex;
    record.diagnosis = diagnose(*job.complex, report->state, settings, neighbour_of(job, solved).get());
    solved.push_back({job.complex, report->state, {}});
    record.solve = std::move(*report);
    if (!no_suggestions) suggest(record, job, *files, mesh, options.quiet);
    records.push_back(std::move(record));
    if (records.back().solve->status == SolveStatus::Stopped) break;
  }
  return records;
}

ExitStatus judge(const DiagnosisRecord& record) {
  const ExitStatus solved = record.solve ? exit_status(record.solve->status) : kSuccess;
  const bool clean = record.diagnosis.solved && record.diagnosis.findings.empty();
  return std::max(solved, clean ? kSuccess : kNotMet);
}

Result<ExitStatus> run(const DiagnoseOptions& options) {
  const SolveCommandOptions& solve = *options.solve;
  const auto settings = settings_of(options);
  if (!settings) return tl::unexpected(settings.error());
  auto plan = plan_layers(solve);
  if (!plan) return tl::unexpected(plan.error());
  if (auto checked = check_outputs(inputs_of(solve), {{"--report", solve.report}}); !checked)
    return tl::unexpected(checked.error());
  const auto checked = load_mesh(solve.input);
  if (!checked) return tl::unexpected(checked.error());
  if (!checked->health.healthy())
    std::fprintf(stderr, "planewright-cli: note: %s: %s\n", solve.input.c_str(),
                 checked->health.summary().c_str());
  const auto mesh = std::make_shared<const PolygonMesh>(checked->mesh);
  const auto records = options.as_is
                           ? diagnose_as_is(*mesh, *settings)
                           : diagnose_solved(*plan, solve, options.mode.value_or(suggested_mode(*mesh)), mesh,
                                             *settings, options.no_suggestions);
  if (!records) return tl::unexpected(records.error());
  const std::string json = to_json(solve.input, *mesh, *records, checked->health);
  ExitStatus status = kSuccess;
  for (const DiagnosisRecord& record : *records) {
    if (!options.json && !solve.quiet) {
      print_findings(record, solve.input);
      if (record.suggestions) print_suggestions(*record.suggestions, *mesh);
    }
    if (!record.unrated.empty())
      std::fprintf(stderr, "planewright-cli: note: no edits were rated: %s\n", record.unrated.c_str());
    status = std::max(status, judge(record));
  }
  if (options.json) std::fputs(json.c_str(), stdout);
  std::fflush(stdout);  // the report may go to the same place (/dev/stdout), past this buffer
  if (!solve.report.empty())
    if (auto saved = write_file_atomically(solve.report, json); !saved) return tl::unexpected(saved.error());
  return status;
}

}  // namespace

void add_diagnose_command(CLI::App& app, ExitStatus& status) {
  auto options = std::make_shared<DiagnoseOptions>();
  auto* command = app.add_subcommand(
      "diagnose", "Solve, and tell where the panels are bad and why (status 1: something was found)");
  std::vector<CLI::Option*> of_solve = declare_unwritten_solve_options(*command, options->solve);
  of_solve.push_back(declare_border_option(*command, options->solve));
  of_solve.push_back(
      command->add_option("--mode", options->mode, "'dual' or 'planarize' (default: whichever fits the mesh)")
          ->transform(named_choice<ComplexKind>(
              {{"dual", ComplexKind::Dual}, {"planarize", ComplexKind::Planarize}})));
  auto* as_is = command->add_flag("--as-is", options->as_is,
                                  "Take the faces of IN as finished planar panels, and solve nothing");
  for (CLI::Option* option : of_solve) as_is->excludes(option);
  command
      ->add_option("--only", options->only,
                   "Kinds of findings to look for, with commas between (default: all)")
      ->delimiter(',');
  declare_thresholds(*command, options->thresholds);
  command->add_flag("--no-suggestions", options->no_suggestions,
                    "Only the findings; rating edits of the mesh takes as long as several solves");
  command->add_flag("--json", options->json, "Print the report instead of a table");
  command->callback([options, &status] {
    const auto result = run(*options);
    status = result ? *result : report(result.error());
  });
}

}  // namespace planewright::cli
