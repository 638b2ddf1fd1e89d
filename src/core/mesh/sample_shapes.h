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
  std::string_view flaw_of = {};  // of a sample with planted bad places: the same design without them
};

// Every sample: torus, dome, vault, saddle-roof, wave-roof, alpine-hut, train-station,
// train-station-unsymmetric, saddle (triangles), twisted-roof, straight-strip (quads); and those with planted
// bad places: flat-patch-dome of dome, bad-saddle of saddle (triangles), turning-strip of straight-strip
// (quads).
const std::vector<SampleInfo>& samples();

// `panels`: how many panels the design should have, 0 for the default: vertices for a triangle sample (one
// panel of its dual each), faces for a quad sample. The nearest possible grid is taken; the deviation is
// under 25 % from 50 panels up. Fails with ErrorCode::Usage: unknown name (lists the known ones), panels out
// of 8..4,000,000.
Result<PolygonMesh> make_sample(std::string_view name, int panels = 0);

// A bad place that was planted, by the elements of the mesh where it is seen. Empty: none of that kind.
struct PlantedPlace {
  std::string what;        // one clause
  std::vector<int> edges;  // of the mesh, ascending
  std::vector<int> faces;  // ascending
};

// What is bad about a sample: each place is bad at least at one of its elements, once the panels are solved
// for their wanted positions; the design that it is a flaw of has no bad place. Empty for samples without
// planted places, and below 200 panels (strips of quads: never), where the flaws are lost among the panels of
// the border. Fails as make_sample does, of which the arguments are.
Result<std::vector<PlantedPlace>> planted_places(std::string_view name, int panels = 0);

// The torus of the benchmarks, on an exact rows x columns grid of triangles (R = 1, r = 0.4): #V = rows *
// columns.
PolygonMesh make_torus(int rows, int columns);

}  // namespace planewright
