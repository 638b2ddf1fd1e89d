// Partition: which face is in which region, with sums, proxy and error of each region kept up to date.
// Internal to this folder.
//
// Invariants: every region has at least one face; `error` is the sum of the regions' errors by the metric
// with which refit() was last called. Indices: 0-based.
#pragma once

#include <array>
#include <vector>

#include "core/cluster/proxy.h"

namespace planewright {

struct Partition {
  std::vector<int> region_of_face;  // #F
  std::vector<RegionSums> sums;     // #K
  std::vector<FittedProxy> fitted;  // #K
  double error = 0.0;

  int regions() const { return static_cast<int>(sums.size()); }
  std::vector<Proxy> proxies() const;
  // Sums, proxies and errors from region_of_face, of which `count` is the number of regions. metric: of
  // for_regions().
  void refit(const FaceGraph& graph, int count, const ClusterMetric& metric);
  // Region b's faces go to a, and the last region takes the number b. Precondition: a != b.
  void merge(int a, int b, const ClusterMetric& metric);
};

// Neighbouring regions, the lower first, ascending, each pair once.
std::vector<std::array<int, 2>> neighbouring_regions(const FaceGraph& graph,
                                                     const std::vector<int>& region_of_face);

// By how much the error would grow if the two regions were one.
double merge_cost(const Partition& partition, std::array<int, 2> pair, const ClusterMetric& metric);

// Of each region the face with the least (worst: greatest) error, ties to the lower index; a face without
// area only where there is no other. Least: per area, as region growing asks for it; worst: of the whole
// face, and never the face that is best, unless it is the only one.
std::vector<int> best_faces(const FaceGraph& graph, const Partition& partition, const ClusterMetric& metric);
std::vector<int> worst_faces(const FaceGraph& graph, const Partition& partition, const ClusterMetric& metric);

// A face's own plane.
Proxy proxy_of_face(const FaceGraph& graph, int f);

}  // namespace planewright
