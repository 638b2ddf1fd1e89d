// What a design says about elements of the mesh, after the mesh was edited.
//
// Indices: the meshes' own, those of waivers the layer's complex's. Threads: pure.
#pragma once

#include <string>
#include <vector>

#include "core/design/clustered_mesh.h"
#include "core/design/layer_settings.h"
#include "core/mesh/element_map.h"
#include "core/mesh/polygon_mesh.h"

namespace planewright {

// Without the elements that are gone; ascending.
Selection remapped(const Selection& selection, const ElementMap& map);

struct RemappedDesign {
  Design design;
  // What went with elements that are gone, each a line for the designer: "2 elements of selection roof".
  std::vector<std::string> dropped;
};
// Of the mesh before and after; null where none are known.
struct ClustersChange {
  SharedClusters before, after;
};
// Selections, pins, plane pins and waivers name the same elements as before. What named only elements that
// are gone goes too: a selection that has nothing left takes the demands on it along, since without it they
// would hold for the whole model. `map` leads from `before` to `after`. Of layers of clusters, pinned corners
// stay that are corners still, pinned panels where their region is known again (same_regions()).
RemappedDesign remapped(Design design, const ElementMap& map, const PolygonMesh& before,
                        const PolygonMesh& after, const ClustersChange& clusters = {});
// The same for other clusters of one mesh: only what names their panels is concerned.
RemappedDesign with_clusters_changed(Design design, const PolygonMesh& mesh, const ClustersChange& clusters);

}  // namespace planewright
