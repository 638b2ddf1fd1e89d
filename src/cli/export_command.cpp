// planewright-cli export PROJECT|MESH -o DIR --format ...: certified files for the workshop.
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <memory>

#include "cli/commands.h"
#include "cli/export_options.h"
#include "cli/export_summary.h"
#include "cli/interrupt_watch.h"
#include "cli/project_input.h"
#include "core/base/atomic_file.h"
#include "core/design/reference_file.h"
#include "core/edit/project_panels.h"
#include "core/mesh/mesh_io.h"
#include "core/writers/schedule_writers.h"

namespace planewright::cli {
namespace {

// The panels that IN means, model units.
struct ExportInput {
  Points points;
  Polygons panels;
  std::shared_ptr<const ReferenceSurface> surface;  // that they were made for; null: not known
  WorkshopContract contract;
  WorkshopOptions naming;  // title, numbers, kept names
};

Vector3d axis(const std::string& name) {
  return name == "x" ? Vector3d::UnitX() : name == "y" ? Vector3d::UnitY() : Vector3d::UnitZ();
}

Result<ExportInput> read_panel_mesh(const ExportOptions& options) {
  if (options.unit.empty())
    return fail(ErrorCode::Usage, "a mesh file does not say what its unit is", options.input,
                "Give --unit mm, cm, m, in or ft");
  if (!options.layer.empty())
    return fail(ErrorCode::Usage, "a mesh has no layers", "--layer", "Leave it out, or export a project");
  auto checked = load_mesh(options.input);
  if (!checked) return tl::unexpected(checked.error());
  if (!checked->health.healthy())
    std::fprintf(stderr, "planewright-cli: note: %s: %s\n", options.input.c_str(),
                 checked->health.summary().c_str());
  ExportInput input;
  input.points = checked->mesh.positions();
  input.panels = checked->mesh.faces();
  input.naming.title = std::filesystem::path(options.input).stem().string();
  return input;
}

Result<ExportInput> read_project_panels(const ExportOptions& options) {
  auto project = read_project_input(options.input);
  if (!project) return tl::unexpected(project.error());
  if (!options.unit.empty())
    return fail(ErrorCode::Usage,
                "a project has its own unit, " + std::string(symbol(project->contract.unit)), "--unit",
                "Leave it out");
  auto solved = solved_panels(*project, options.layer);
  if (!solved) return tl::unexpected(solved.error());
  ExportInput input;
  input.points = std::move(solved->panels.points);
  input.panels = std::move(solved->panels.polygons);
  const PolygonMesh& mesh = project->mesh;
  auto surface = project->design.reference.empty()
                     ? ReferenceSurface::create(mesh.positions(), mesh.faces(), project->name)
                     : load_reference(project->design.reference, mesh);
  if (!surface) return tl::unexpected(surface.error());
  input.surface = std::move(*surface);
  input.contract = project->contract;
  input.naming.title = project->name.empty() ? std::filesystem::path(options.input).stem().string()
                                             : std::filesystem::path(project->name).stem().string();
  input.naming.numbers = std::move(solved->numbers);
  input.naming.kept_names = std::move(solved->given_names);
  return input;
}

// The surface that distances are measured from. Fails as load_reference() does; ErrorCode::Usage: a limit on
// distances, and no surface.
Result<std::shared_ptr<const ReferenceSurface>> reference_of(const ExportOptions& options,
                                                             const ExportInput& input,
                                                             const ToleranceSheet& sheet) {
  if (!options.reference.empty())
    return load_reference(options.reference, input.points.colwise().minCoeff(),
                          input.points.colwise().maxCoeff());
  if (sheet.distance && !input.surface)
    return fail(ErrorCode::Usage, "there is no surface to measure the distance from", "--distance",
                "Name one with --reference");
  return input.surface;
}

ExportProgress progress_on_stderr(bool quiet) {
  if (quiet || ::isatty(STDERR_FILENO) == 0) return {};
  return [](std::string_view stage, double fraction) {
    std::fprintf(stderr, "\r%.*s %3.0f %%\033[K", static_cast<int>(stage.size()), stage.data(),
                 100.0 * fraction);
    std::fflush(stderr);
  };
}

void end_progress(const ExportProgress& progress) {
  if (progress) std::fputs("\r\033[K", stderr);
}

Result<ExitStatus> run(const ExportOptions& options) {
  auto input = is_project(options.input) ? read_project_panels(options) : read_panel_mesh(options);
  if (!input) return tl::unexpected(input.error());
  const auto contract = contract_of(options, input->contract);
  if (!contract) return tl::unexpected(contract.error());
  const auto settings = export_settings(options, *contract);
  if (!settings) return tl::unexpected(settings.error());

  WorkshopOptions naming = std::move(input->naming);
  naming.unit = contract->unit;
  naming.names = contract->names;
  naming.up = axis(options.up);
  if (!options.keep_names.empty()) {
    const auto text = read_file(options.keep_names);
    if (!text) return tl::unexpected(text.error());
    auto kept = read_kept_names(*text, options.keep_names);
    if (!kept) return tl::unexpected(kept.error());
    naming.kept_names = std::move(*kept);
  }
  const auto reference = reference_of(options, *input, contract->tolerances);
  if (!reference) return tl::unexpected(reference.error());
  const auto model = make_workshop_model(input->points, input->panels, naming);
  if (!model) return tl::unexpected(model.error());

  const InterruptWatch interrupt;
  const ExportProgress progress = progress_on_stderr(options.quiet);
  const auto prepared = prepare_export(*model, *settings, reference->get(), progress, interrupt.stop_token());
  if (!prepared) {
    end_progress(progress);
    return tl::unexpected(prepared.error());
  }
  const auto outcome =
      write_export(*model, *prepared, *settings, options.folder, progress, interrupt.stop_token());
  end_progress(progress);
  if (!outcome) return tl::unexpected(outcome.error());
  print_export(**model, *prepared, *outcome);
  return prepared->verdicts.failed == 0 && prepared->left_out.empty() && outcome->certificate.pass()
             ? kSuccess
             : kNotMet;
}

}  // namespace

void add_export_command(CLI::App& app, ExitStatus& status) {
  auto options = std::make_shared<ExportOptions>();
  auto* command = app.add_subcommand(
      "export",
      "Certified files for the workshop: patterns on sheets, schedules, solids (status 1: written, "
      "but panels fail)");
  declare_export_options(*command, options);
  command->callback([options, &status] {
    const auto result = run(*options);
    status = result ? *result : report(result.error());
  });
}

}  // namespace planewright::cli
