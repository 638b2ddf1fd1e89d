#include "cli/layer_run.h"

#include <algorithm>
#include <chrono>
#include <numbers>
#include <utility>

#include "cli/explicit_solve.h"
#include "cli/progress.h"
#include "core/base/atomic_file.h"
#include "core/design/design.h"
#include "core/design/layer_solve.h"
#include "core/layers/beams.h"
#include "core/layers/parallel_offset.h"
#include "core/mesh/mesh_io.h"

namespace planewright::cli {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

// Planarity of what the file says, not of what was meant to be written. STL holds triangles alone; there the
// panels themselves are measured.
Result<Planarity> planarity_as_written(const std::string& path, const Panels& panels) {
  const auto format = format_of(path);
  if (!format) return tl::unexpected(format.error());
  if (*format == MeshFormat::Stl) return measure_planarity(panels.points, panels.polygons);
  const auto content = read_file(path);
  if (!content) return tl::unexpected(content.error());
  const auto soup = parse_mesh(*content, *format, path);
  if (!soup) return tl::unexpected(soup.error());
  return measure_planarity(soup->positions, soup->faces);
}

Result<Planarity> write_panels(const std::string& path, const Panels& panels) {
  if (auto saved = save_mesh(path, panels.points, panels.polygons); !saved)
    return tl::unexpected(saved.error());
  return planarity_as_written(path, panels);
}

Result<OffsetRecord> write_offset(const LayerJob& job, const ParallelOffset& offset) {
  OffsetRecord record;
  record.file = job.offset_output;
  record.thickness = job.layer.thickness;
  record.blunted = offset.blunted;
  record.residuals = offset.residuals;
  const auto planarity = write_panels(job.offset_output, panels_of(*job.complex, offset.state));
  if (!planarity) return tl::unexpected(planarity.error());
  record.planarity = *planarity;
  return record;
}

Result<BeamsRecord> write_beams(const std::string& file, std::string with, const SolvedLayer& first,
                                const SolvedLayer& second) {
  const auto beams = make_beams(*first.complex, first.state, *second.complex, second.state);
  if (!beams) return tl::unexpected(beams.error());
  const Points points = beams->points.rowwise() + first.complex->origin.transpose();
  if (auto saved = save_mesh(file, points, beams->quads); !saved) return tl::unexpected(saved.error());
  const BeamSummary summary = summarise(*beams);
  const auto turned = std::count_if(beams->twist.begin(), beams->twist.end(),
                                    [](double twist) { return twist > 0.5 * std::numbers::pi; });
  return BeamsRecord{file,
                     std::move(with),
                     summary.beams,
                     summary.max_planarity,
                     summary.max_twist,
                     summary.most_twisted_edge,
                     static_cast<int>(turned)};
}

// Offset and beams of a layer that is the last of `layers`.
Result<void> write_construction(const std::vector<LayerJob>& jobs, std::vector<SolvedLayer>& layers,
                                SolveRecord& record) {
  const LayerJob& job = jobs[layers.size() - 1];
  SolvedLayer& solved = layers.back();
  if (!job.offset_output.empty()) {
    ParallelOffset offset = parallel_offset(*job.complex, solved.state, job.layer.thickness);
    auto written = write_offset(job, offset);
    if (!written) return tl::unexpected(written.error());
    record.offset_layer = std::move(*written);
    solved.offset = std::move(offset.state);
  }
  if (job.beams_output.empty()) return {};
  const auto to = static_cast<size_t>(std::max(job.beams_to, 0));
  auto beams = job.beams_to < 0 ? write_beams(job.beams_output, "offset", solved,
                                              {solved.complex, solved.offset.value(), {}})
                                : write_beams(job.beams_output, jobs[to].layer.name, layers[to], solved);
  if (!beams) return tl::unexpected(beams.error());
  record.beams = std::move(*beams);
  return {};
}

void measure(const TangentComplex& complex, const Panels& panels, SolveRecord& record) {
  const State& state = record.solve.state;
  record.panels = panels.polygons.size();
  record.points = static_cast<int>(panels.points.rows());
  record.mean_edge = complex.mean_edge;
  record.displacement = measure_displacement(state.x, complex.preferred);
  record.ill_determined = find_ill_determined(complex, state);
  record.self_crossing = find_self_crossing(panels.points, panels.polygons);
  record.short_edges = find_short_edges(complex, state);
}

}  // namespace

std::shared_ptr<const NeighbourLayer> neighbour_of(const LayerJob& job,
                                                   const std::vector<SolvedLayer>& earlier) {
  if (job.layer.coplanar_with < 0) return nullptr;
  const SolvedLayer& other = earlier[static_cast<size_t>(job.layer.coplanar_with)];
  return std::make_shared<NeighbourLayer>(NeighbourLayer{other.complex, other.state});
}

Result<SolveReport> solve_job(const LayerJob& job, const SolveCommandOptions& options,
                              const DesignFiles& files, const std::vector<SolvedLayer>& earlier) {
  const LayerSettings& settings = job.layer.settings;
  if (options.explicit_points) return solve_explicitly(job.complex, settings);
  const LayerProblem problem{job.complex, settings, files.selections, files.reference,
                             neighbour_of(job, earlier)};
  Progress progress(options.quiet, settings.tolerance);
  const auto solver = make_solver(options.solver);
  return solve_layer(*solver, problem, start_state(*job.complex, settings), solve_options(settings),
                     &progress, progress.stop_token());
}

Result<SolveRecord> run_layer(const std::vector<LayerJob>& jobs, const SolveCommandOptions& options,
                              const DesignFiles& files, std::vector<SolvedLayer>& earlier) {
  const auto begun = Clock::now();
  const LayerJob& job = jobs[earlier.size()];
  SolveRecord record;
  record.input = options.input;
  if (job.named) record.layer = job.layer.name;
  record.preset = job.preset;
  record.reference = options.reference;
  record.settings = job.layer.settings;

  auto solved = solve_job(job, options, files, earlier);
  if (!solved) return tl::unexpected(solved.error());
  record.solve = std::move(*solved);
  const Panels panels = panels_of(*job.complex, record.solve.state);
  const auto planarity = write_panels(job.output, panels);
  if (!planarity) return tl::unexpected(planarity.error());
  record.planarity = *planarity;
  measure(*job.complex, panels, record);
  if (job.clustered) record.clusters = measure_clusters(*job.clustered, panels);
  record.diagnosis = diagnose(*job.complex, record.solve.state, {}, neighbour_of(job, earlier).get());

  earlier.push_back({job.complex, record.solve.state, {}});
  if (auto written = write_construction(jobs, earlier, record); !written)
    return tl::unexpected(written.error());
  record.seconds_total = seconds_since(begun);
  return record;
}

}  // namespace planewright::cli
