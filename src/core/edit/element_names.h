// Names of mesh elements that outlive edits: numbers that every vertex, edge and face is given when the mesh
// is opened (its index) or when an edit makes it (the next one that no element of the document ever had).
//
// Indices and numbers: 0-based. Threads: plain values.
#pragma once

#include <string>
#include <utility>
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

// How many numbers there are of each kind.
struct NumberCounts {
  int vertices = 0, edges = 0, faces = 0;
  bool operator==(const NumberCounts&) const = default;
};

// Gives numbers; each once, however often edits are undone.
class ElementNumbering {
 public:
  ElementNumbering() = default;
  explicit ElementNumbering(const PolygonMesh& opened);
  // One that goes on: `opened` elements had the mesh at first, `next` numbers are given.
  ElementNumbering(NumberCounts opened, NumberCounts next) : opened_(opened), next_(next) {}

  ElementIds opened() const;
  // Survivors keep theirs.
  ElementIds edited(const ElementIds& before, const ElementMap& map);

  const NumberCounts& opened_counts() const { return opened_; }
  const NumberCounts& given() const { return next_; }
  bool operator==(const ElementNumbering&) const = default;

 private:
  NumberCounts opened_, next_;
};

// Between any two meshes of a document, whatever lies between them: elements of the same number are the same.
ElementMap map_between(const ElementIds& from, const ElementIds& to);

// What panels are called: by the index that they had in the layer when the mesh was opened, so that the names
// of an unedited mesh are those of every report. Panels that came later follow on.
class PanelNumbers {
 public:
  PanelNumbers() = default;
  explicit PanelNumbers(const PolygonMesh& opened);
  // By vertex of the mesh as it was opened: the number of its panel in duals of either border policy, each a
  // permutation.
  PanelNumbers(std::vector<int> closed, std::vector<int> interior)
      : closed_(std::move(closed)), interior_(std::move(interior)) {}
  const std::vector<int>& closed() const { return closed_; }
  const std::vector<int>& interior() const { return interior_; }

  // origin: TangentComplex::plane_origin of the panel, in the mesh that `ids` belongs to. -1: out of range.
  int number(ComplexKind kind, BorderPolicy border, const ElementIds& ids, int origin) const;
  bool operator==(const PanelNumbers&) const = default;

 private:
  // By vertex of the opened mesh; one that had no panel then follows behind those that had.
  std::vector<int> closed_, interior_;
};

// All that names rest on, as a project file keeps it.
struct ElementNames {
  ElementIds ids;  // of the mesh as it is now
  ElementNumbering numbering;
  PanelNumbers panels;
  bool operator==(const ElementNames&) const = default;
};
// Of a mesh as it is opened.
ElementNames names_of_opened(const PolygonMesh& mesh);

// "panel 17", as text(ElementRef) has it
std::string panel_name(int number);

}  // namespace planewright
