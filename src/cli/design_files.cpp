#include "cli/design_files.h"

#include <utility>

#include "core/base/atomic_file.h"
#include "core/design/reference_file.h"
#include "core/design/selection_file.h"
#include "core/export/solve_record.h"

namespace planewright::cli {
namespace {

int count_of(const TangentComplex& complex, ElementKind kind) {
  switch (kind) {
    case ElementKind::Point:
      return complex.point_count();
    case ElementKind::Panel:
      return complex.plane_count();
    case ElementKind::PanelEdge:
      return static_cast<int>(complex.panel_edges.size());
  }
  return 0;
}

}  // namespace

Result<DesignFiles> read_design_files(const SolveCommandOptions& options, const PolygonMesh& mesh) {
  DesignFiles files;
  if (!options.selections.empty()) {
    const auto content = read_file(options.selections);
    if (!content) return tl::unexpected(content.error());
    auto selections = parse_selection_file(*content, options.selections, mesh);
    if (!selections) return tl::unexpected(selections.error());
    files.selections = std::move(*selections);
  }
  if (!options.pins.empty()) {
    const auto content = read_file(options.pins);
    if (!content) return tl::unexpected(content.error());
    auto pins = parse_pin_file(*content, options.pins, mesh);
    if (!pins) return tl::unexpected(pins.error());
    files.pins = std::move(*pins);
  }
  if (!options.reference.empty()) {
    auto reference = load_reference(options.reference, mesh);
    if (!reference) return tl::unexpected(reference.error());
    files.reference = std::move(*reference);
  }
  return files;
}

Result<std::vector<Waiver>> read_waived(const std::vector<std::string>& reports, const std::string& layer,
                                        const TangentComplex& complex) {
  std::vector<Waiver> waived;
  for (const std::string& path : reports) {
    const auto content = read_file(path);
    if (!content) return tl::unexpected(content.error());
    const auto read = read_waivers(*content, path, layer);
    if (!read) return tl::unexpected(read.error());
    if (read->panels != complex.plane_count() || read->points != complex.point_count())
      return fail(ErrorCode::Unreadable,
                  "the report is of another design: it has " + std::to_string(read->panels) + " panels and " +
                      std::to_string(read->points) + " points, this one " +
                      std::to_string(complex.plane_count()) + " and " + std::to_string(complex.point_count()),
                  path, "Give a report of the same mesh, mode and border");
    for (const Waiver& waiver : read->waivers) {
      if (waiver.element.index >= count_of(complex, waiver.element.kind))
        return fail(ErrorCode::Unreadable,
                    "the report is of another design: these panels have no " + text(waiver.element), path,
                    "Give a report of the same mesh, mode and border");
      waived.push_back(waiver);
    }
  }
  return waived;
}

}  // namespace planewright::cli
