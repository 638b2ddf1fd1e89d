// The files besides the mesh that say what is wanted: selections, pins, a reference surface, earlier reports.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/solve_options.h"
#include "core/base/result.h"
#include "core/complex/tangent_complex.h"
#include "core/design/pin_file.h"
#include "core/mesh/closest_point.h"
#include "core/mesh/polygon_mesh.h"
#include "core/problem/demand.h"

namespace planewright::cli {

struct DesignFiles {
  std::vector<Selection> selections;
  PinFile pins;
  std::shared_ptr<const ReferenceSurface> reference;  // null: the mesh itself
};

// Reads those that are named. Fails as the readers do (ErrorCode::Unreadable, Refused: a reference that is
// empty, or far away from the mesh).
Result<DesignFiles> read_design_files(const SolveCommandOptions& options, const PolygonMesh& mesh);

// What the earlier reports (--waive) give up in the layer of this name (empty: the only one). Fails with
// ErrorCode::Unreadable: no reports, or of another design.
Result<std::vector<Waiver>> read_waived(const std::vector<std::string>& reports, const std::string& layer,
                                        const TangentComplex& complex);

}  // namespace planewright::cli
