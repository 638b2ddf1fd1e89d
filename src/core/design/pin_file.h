// Pin file: points held at coordinates and panels held in planes, as text that a designer writes; a line per
// pin, '#' begins a comment:
//
//   vertex 17 0 0 -          # planarize: the corner at mesh vertex 17; '-': this coordinate stays free
//   face 3 1.5 2 *           # dual: the point of mesh face 3; '*': where the design wants it
//   edge 12 * * *            # dual: the point of border edge 12 ...
//   edge 7 8 * * *           # ... or of the one that joins vertices 7 and 8
//   corner 5 0 0 0           # dual: the outline's corner at border vertex 5
//   plane vertex 12          # dual: the panel of vertex 12 stays in the plane it starts in
//   plane face 4 0 0 1 2.5   # planarize: face 4 lies in 0 x + 0 y + 1 z = 2.5 (the normal is made unit, the
//                            # distance counts along the unit normal)
//
// Numbers of elements count from 0 (mesh after its repair, as reports and the window name them); coordinates:
// model units, absolute. Threads: pure.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/complex/tangent_complex.h"
#include "core/mesh/polygon_mesh.h"
#include "core/problem/demand.h"

namespace planewright {

struct PinCoordinate {
  enum class Kind { Free, Wanted, Given } kind = Kind::Free;
  double value = 0.0;  // Given
};

// What the file says, before a complex gives "where it is wanted" a meaning.
struct PinFile {
  struct Point {
    PointOrigin point;
    std::array<PinCoordinate, 3> at;
    std::string where;  // "pins.txt:4"
  };
  struct Plane {
    bool of_vertex;  // else of a face
    int element;
    std::optional<PlanePin::Equation> plane;
    std::string where;
  };
  std::vector<Point> points;
  std::vector<Plane> planes;
};

// name: what errors call the file. Fails with ErrorCode::Unreadable, with the line: an unknown word, a number
// missing, too many or none, a pin of nothing, an element that the mesh does not have.
Result<PinFile> parse_pin_file(std::string_view content, const std::string& name, const PolygonMesh& mesh);

// Adds the file's pins to the demands of a layer of this complex. Fails with ErrorCode::Unreadable where the
// complex has no such point or panel (a vertex of a dual, an inner edge); with ErrorCode::Infeasible where
// two lines hold one coordinate at different places; demands then stay as they were.
Result<void> add_pins(const PinFile& file, const TangentComplex& complex, Demands& demands);

}  // namespace planewright
