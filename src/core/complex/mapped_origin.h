// Where the mesh elements that a complex is made of went when the mesh was edited. -1: gone.
#pragma once

#include "core/complex/tangent_complex.h"
#include "core/mesh/element_map.h"

namespace planewright {

// What planes, or points, of a kind stand for. Regions of a cluster are no elements of the mesh, and are
// found anew when it is edited: none of them is mapped.
inline const IndexMap& plane_origins(const ElementMap& edited, ComplexKind kind) {
  static const IndexMap none;
  switch (kind) {
    case ComplexKind::Dual:
      return edited.vertices;
    case ComplexKind::Planarize:
      return edited.faces;
    case ComplexKind::Cluster:
      break;
  }
  return none;
}
inline const IndexMap& point_origins(const ElementMap& edited, PointKind kind) {
  switch (kind) {
    case PointKind::Face:
      return edited.faces;
    case PointKind::BorderEdge:
      return edited.edges;
    case PointKind::Corner:
    case PointKind::Vertex:
      break;
  }
  return edited.vertices;
}

inline int mapped(const IndexMap& map, int element) {
  return element >= 0 && element < static_cast<int>(map.to_new.size())
             ? map.to_new[static_cast<size_t>(element)]
             : -1;
}

}  // namespace planewright
