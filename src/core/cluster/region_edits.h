// Edits of a clustering by hand: merge two regions, split one, paint faces. Each gives a new clustering, or
// refuses (ErrorCode::Refused) with the reason and what to do instead. The clustering has to be one of the
// graph, as cluster() and clustering_of() make them. Indices: 0-based. Threads: pure, deterministic.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/cluster/clustering.h"

namespace planewright {

// The two become one under the lower number; the last region takes the freed number. Refused: no such region,
// the same one twice, regions that are no neighbours.
Result<Clustering> merge_regions(const FaceGraph& graph, const Clustering& clustering, int a, int b,
                                 const ClusterMetric& metric = {});

// In two, by Lloyd iterations inside the region: one part keeps the number, the other becomes the last
// region. Refused: no such region, or it has a single face.
Result<Clustering> split_region(const FaceGraph& graph, const Clustering& clustering, int region,
                                const ClusterMetric& metric = {});

// The face goes to `region`, which has to be beside it. Refused: no such face or region, the face is there
// already, the region is not beside it, or the face's own region would be empty or fall apart.
Result<Clustering> paint_face(const FaceGraph& graph, const Clustering& clustering, int face, int region,
                              const ClusterMetric& metric = {});

struct PaintedFaces {
  Clustering clustering;
  std::vector<int> refused;  // faces that could not go over, in the order given
  std::optional<Error> why;  // the last of them; none: all went
  bool changed = false;
};
// Likewise several faces, in whatever order works. Refused as a whole: no such region.
Result<PaintedFaces> paint_faces(const FaceGraph& graph, const Clustering& clustering,
                                 std::span<const int> faces, int region, const ClusterMetric& metric = {});

}  // namespace planewright
