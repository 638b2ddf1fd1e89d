// Names of mesh elements that outlive edits: numbers that every vertex, edge and face is given when the mesh
// is opened (its index) or when an edit makes it (the next one that no element of the document ever had).
//
// Indices and numbers: 0-based. Threads: plain values.
#pragma once

#include <string>
#include <vector>

#include "core/complex/dual.h"
#include "core/complex/tangent_complex.h"
#include "core/mesh/element_map.h"
#include "core/mesh/polygon_mesh.h"

namespace planewright {

// The number of each element of a mesh.
struct ElementIds {
  std::vector<int> vertices, edges, faces;
  bool operator==(const ElementIds&) const = default;
};

// Gives numbers; each once, however often edits are undone.
class ElementNumbering {
 public:
  ElementNumbering() = default;
  explicit ElementNumbering(const PolygonMesh& opened);

  ElementIds opened() const;
  // Survivors keep theirs.
  ElementIds edited(const ElementIds& before, const ElementMap& map);

 private:
  int opened_vertices_ = 0, opened_edges_ = 0, opened_faces_ = 0;
  int next_vertex_ = 0, next_edge_ = 0, next_face_ = 0;
};

// Between any two meshes of a document, whatever lies between them: elements of the same number are the same.
ElementMap map_between(const ElementIds& from, const ElementIds& to);

// What panels are called: by the index that they had in the layer when the mesh was opened, so that the names
// of an unedited mesh are those of every report. Panels that came later follow on.
class PanelNumbers {
 public:
  PanelNumbers() = default;
  explicit PanelNumbers(const PolygonMesh& opened);

  // origin: TangentComplex::plane_origin of the panel, in the mesh that `ids` belongs to. -1: out of range.
  int number(ComplexKind kind, BorderPolicy border, const ElementIds& ids, int origin) const;

 private:
  // By vertex of the opened mesh; one that had no panel then follows behind those that had.
  std::vector<int> closed_, interior_;
};

// "panel 17", as text(ElementRef) has it
std::string panel_name(int number);

}  // namespace planewright
