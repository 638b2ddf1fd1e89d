// RegionView: the mesh being designed on with its regions in colours, as arrays for the renderer.
//
// Regions beside each other differ in colour, and a region keeps its colour from one clustering to the next,
// so that a slider being dragged moves borders and does not flicker. Threads: a plain value; made on any.
#pragma once

#include <memory>
#include <vector>

#include "core/design/clustered_mesh.h"
#include "ui/mesh_view.h"
#include "ui/render/panel_arrays.h"

namespace planewright::ui {

struct RegionView {
  SharedClusters clusters;
  std::shared_ptr<const MeshView> mesh;  // of the clusters' mesh
  render::RegionArrays arrays;
  std::vector<int> colour_of_region;  // entries of render::Palette::regions
};

// before: an earlier view, whose colours and triangles are kept where that is possible; may be null.
RegionView make_region_view(SharedClusters clusters, std::shared_ptr<const MeshView> mesh,
                            const RegionView* before = nullptr);

// A colour below render::kRegionColours for each region, other than its neighbours' where that is possible.
// preferred: #K, -1: none.
std::vector<int> colour_regions(const FaceGraph& graph, const std::vector<int>& region_of_face, int count,
                                const std::vector<int>& preferred);

}  // namespace planewright::ui
