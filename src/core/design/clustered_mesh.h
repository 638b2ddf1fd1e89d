// ClusteredMesh: a mesh with the regions that its panels are made of, as a value that is never changed: each
// way to other regions (cluster anew, go on from what is there, merge, split, paint, an edit of the mesh)
// gives another one that shares mesh and face graph where these are the same.
//
// Regions are numbered as in `regions`, that is after the repairs: those are the ones a designer sees.
// Indices: 0-based. Threads: immutable once made; pure functions.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/cluster/clustering.h"
#include "core/cluster/regions.h"
#include "core/mesh/element_map.h"
#include "core/mesh/polygon_mesh.h"

namespace planewright {

struct ClusteredMesh {
  std::shared_ptr<const PolygonMesh> mesh;
  std::shared_ptr<const FaceGraph> graph;  // of that mesh
  ClusterOptions options;
  bool given = false;     // regions that were given, not found: of the options only the metric counts
  Clustering clustering;  // before the repairs
  Regions regions;
};
using SharedClusters = std::shared_ptr<const ClusteredMesh>;

// What a ClusteredMesh of a known mesh is made again from, to the bit: for files.
struct ClusterRecord {
  ClusterOptions options;
  bool given = false;
  bool target_met = true;           // as Clustering has it
  std::vector<int> region_of_face;  // #F, before the repairs
};
ClusterRecord record_of(const ClusteredMesh& clusters);
// Fails as FaceGraph::create(), check_metric(), clustering_of() and make_regions() do.
Result<SharedClusters> clusters_of(std::shared_ptr<const PolygonMesh> mesh, const ClusterRecord& record);

// Clusters the mesh and makes regions of it, also of a clustering that was stopped. Fails as
// FaceGraph::create(), cluster() and make_regions() do.
Result<SharedClusters> cluster_mesh(std::shared_ptr<const PolygonMesh> mesh, const ClusterOptions& options,
                                    ClusterObserver* observer = nullptr, std::stop_token stop = {});
// The same with regions that are given, the region of each face. Fails also as clustering_of() does.
Result<SharedClusters> mesh_of_regions(std::shared_ptr<const PolygonMesh> mesh,
                                       std::vector<int> region_of_face, const ClusterMetric& metric);
// The mesh of `from`, clustered anew.
Result<SharedClusters> cluster_anew(const ClusteredMesh& from, const ClusterOptions& options,
                                    std::stop_token stop = {});
// Goes on from its regions to another number or metric, as a slider asks for: see cluster(). Targets are not
// looked at.
Result<SharedClusters> recluster(const ClusteredMesh& from, ClusterOptions options,
                                 std::stop_token stop = {});

// By hand: see region_edits.h, whose refusals they pass on. Repairs may follow.
Result<SharedClusters> with_regions_merged(const ClusteredMesh& of, int a, int b);
Result<SharedClusters> with_region_split(const ClusteredMesh& of, int region);

struct Painted {
  SharedClusters clusters;
  std::vector<int> refused;  // faces that could not go over
  std::optional<Error> why;  // the last of them; none: all went
};
// The faces go to the region of face `from`, in whatever order works. Fails only where repairs do.
Result<Painted> with_faces_painted(const ClusteredMesh& of, std::span<const int> faces, int from);

// The regions of a mesh that was edited; `faces` leads from the mesh before to `mesh`. New faces go to a
// neighbour's region, and so does what an edit has cut off from its region. Fails as make_regions() does.
Result<SharedClusters> carried_over(const ClusteredMesh& before, std::shared_ptr<const PolygonMesh> mesh,
                                    const IndexMap& faces);

// Which region of `after` is which one of `before`, by the faces that they share: those that have more in
// common with each other than with any other. Both of the same mesh.
IndexMap same_regions(const std::vector<int>& before, int count_before, const std::vector<int>& after,
                      int count_after);

}  // namespace planewright
