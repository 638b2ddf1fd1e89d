// Sample designs made by formula, in any number of panels: what the program shows at its first start, what
// the assets are made from, and what tests and benchmarks use. All lengths are metres. Deterministic.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/mesh/polygon_mesh.h"

namespace planewright {

struct SampleInfo {
  std::string_view name;         // "alpine-hut", as the command line takes it
  std::string_view description;  // one line
  bool triangles;                // a dual's primal (true) or a polygon mesh to planarize (false)
  int default_panels;
};

// Every sample: torus, dome, vault, saddle-roof, wave-roof, alpine-hut, train-station,
// train-station-unsymmetric (triangles) and twisted-roof (quads).
const std::vector<SampleInfo>& samples();

// `panels`: how many panels the design should have, 0 for the default: vertices for a triangle sample (one
// panel of its dual each), faces for a quad sample. The nearest possible grid is taken; the deviation is
// under 25 % from 50 panels up. Fails with ErrorCode::Usage: unknown name (lists the known ones), panels out
// of 8..4,000,000.
Result<PolygonMesh> make_sample(std::string_view name, int panels = 0);

// The torus of the benchmarks, on an exact rows x columns grid of triangles (R = 1, r = 0.4): #V = rows *
// columns.
PolygonMesh make_torus(int rows, int columns);

}  // namespace planewright
