// RegionGrower: floods a mesh from one face per region, cheapest face first, so that every region is
// connected and every face that can be reached is in one. Internal to this folder.
#pragma once

#include <span>
#include <vector>

#include "core/cluster/proxy.h"

namespace planewright {

class RegionGrower {
 public:
  explicit RegionGrower(const FaceGraph& graph) : graph_(graph) {}

  // seeds: distinct faces, one per region; proxies: as many; metric: of for_regions(). region_of_face: #F, is
  // overwritten; -1 where no seed is in the component. Of equally cheap faces the one of the lower index goes
  // first, of regions that want it equally the lower one. O(#F log #F), no allocation from the second call
  // on.
  void grow(std::span<const int> seeds, std::span<const Proxy> proxies, const ClusterMetric& metric,
            std::vector<int>& region_of_face);

 private:
  // A face that a region next to it wants. Each face is kept at its cheapest offer so far; dearer ones are
  // never queued, and those that were outbid are skipped when they come up.
  struct Offer {
    double cost;
    int face, region;
    bool operator<(const Offer& other) const {
      if (cost != other.cost) return cost < other.cost;
      if (face != other.face) return face < other.face;
      return region < other.region;
    }
  };
  void push(const Offer& offer);
  Offer pop();

  const FaceGraph& graph_;
  std::vector<Offer> heap_;  // of four children each: half as deep as a binary one, and within cache lines
  std::vector<double> best_;
};

}  // namespace planewright
