// Selecting: which elements of the mesh a designer means by "the strip through here", "the border", "more of
// it". Pure functions over the mesh; a selection's elements are those that problem/demand.h names.
//
//            panels are        corners (points) are
//   dual     vertices          faces, and border edges (closed border)
//   planarize faces            vertices
//
// Indices: the mesh's own, 0-based; every list that is returned inside a Selection ascends. Threads: pure.
#pragma once

#include <vector>

#include "core/complex/tangent_complex.h"
#include "core/mesh/polygon_mesh.h"
#include "core/problem/demand.h"

namespace planewright {

enum class SelectWhat { Panels, Corners };
enum class Combine { Replace, Add, Remove };

// base with or without the elements of `other`; the name stays base's.
Selection combined(Selection base, const Selection& other, Combine how);
int element_count(const Selection& selection);

// The elements that panels, or points, of a complex are named by; none for corners of a dual, which their
// panel's vertex stands for.
Selection named_panels(const TangentComplex& complex, const std::vector<int>& panels);
Selection named_points(const TangentComplex& complex, const std::vector<int>& points);
// The panels, and the points, of a complex that a selection names itself, ascending. (A demand on a selected
// panel holds for its points, too.)
std::vector<int> panels_named(const TangentComplex& complex, const Selection& selection);
std::vector<int> points_named(const TangentComplex& complex, const Selection& selection);

// Edges straight on through the inner vertices of even valence, from one end of the line to the other; a line
// that comes back to `edge` begins with it. A border edge gives its border loop.
std::vector<int> edge_line(const PolygonMesh& mesh, int edge);
// Faces that a line across `edge` passes, leaving each face of even valence by the edge opposite; it ends in
// the first face of odd valence, or at the border. A ring of faces names each once.
std::vector<int> face_strip(const PolygonMesh& mesh, int edge);
// The border edges of the loop that `edge` is in, in the direction in which the border runs (faces at its
// left); empty for an inner edge.
std::vector<int> border_loop(const PolygonMesh& mesh, int edge);
// Every border edge, loop after loop.
std::vector<int> border_edges(const PolygonMesh& mesh);

// The mesh edge that a panel edge lies on (planarize) or crosses (dual; for one along the border the border
// edge that it runs along); -1 where the mesh has none, as it has changed since.
int mesh_edge_of(const PolygonMesh& mesh, const TangentComplex& complex, int panel_edge);

// What lies along border edges: panels that touch them with an edge (planarize) or a vertex of theirs (dual);
// or the points on them.
Selection along_border(const PolygonMesh& mesh, ComplexKind kind, SelectWhat what,
                       const std::vector<int>& edges);
// The loop through a mesh edge: along_border() of its loop for a border edge. For an inner one the strip of
// panels across it (planarize), or along it (dual: the panels of the line's vertices); as corners the line's
// vertices (planarize) or the strip's faces (dual).
Selection loop_through(const PolygonMesh& mesh, ComplexKind kind, SelectWhat what, int edge);

Selection everything(const PolygonMesh& mesh, ComplexKind kind, SelectWhat what);
// everything() without the selection.
Selection inverted(const PolygonMesh& mesh, ComplexKind kind, SelectWhat what, const Selection& selection);

// With all neighbours: vertices that share an edge, faces that share an edge, edges that share an end (for a
// border edge only the border's).
Selection grown(const PolygonMesh& mesh, const Selection& selection);
// Without the elements that have a neighbour outside.
Selection shrunk(const PolygonMesh& mesh, const Selection& selection);
// With all of every connected component that it touches, in the lists that are not empty.
Selection whole_components(const PolygonMesh& mesh, const Selection& selection);

}  // namespace planewright
