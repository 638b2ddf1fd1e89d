// ElementMap: where the elements of a mesh went when it was edited, and where those of the edited mesh come
// from.
//
// Invariant: a partial one-to-one map; to_new and to_old say the same. Of two elements that became one, the
// survivor is mapped and the other is gone. Indices: 0-based. Threads: plain values.
#pragma once

#include <vector>

#include "core/mesh/polygon_mesh.h"

namespace planewright {

struct IndexMap {
  std::vector<int> to_new;  // #old; -1: gone
  std::vector<int> to_old;  // #new; -1: new
  bool operator==(const IndexMap&) const = default;
};

struct ElementMap {
  IndexMap vertices, edges, faces;
  bool operator==(const ElementMap&) const = default;
};

// Every element of the mesh stays what it is.
ElementMap identity_map(const PolygonMesh& mesh);
// `first` and then `second`, which starts at the mesh that `first` ends at. What `second` makes is new; what
// `first` made and `second` removed does not show.
IndexMap composed(const IndexMap& first, const IndexMap& second);
ElementMap composed(const ElementMap& first, const ElementMap& second);
// From the edited mesh back to the one before: what is gone is new, and the other way round.
IndexMap inverse(IndexMap map);
ElementMap inverse(ElementMap map);

// to_new from to_old, which holds each of 0..old_count-1 at most once.
IndexMap index_map(std::vector<int> to_old, int old_count);

}  // namespace planewright
