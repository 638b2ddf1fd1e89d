#include "core/cluster/region_growing.h"

#include <algorithm>
#include <limits>

namespace planewright {

void RegionGrower::push(const Offer& offer) {
  size_t at = heap_.size();
  heap_.push_back(offer);
  while (at > 0) {
    const size_t parent = (at - 1) / 4;
    if (!(offer < heap_[parent])) break;
    heap_[at] = heap_[parent];
    at = parent;
  }
  heap_[at] = offer;
}

RegionGrower::Offer RegionGrower::pop() {
  const Offer top = heap_.front(), last = heap_.back();
  heap_.pop_back();
  const size_t size = heap_.size();
  if (size == 0) return top;
  size_t at = 0;
  while (true) {
    const size_t first = 4 * at + 1;
    if (first >= size) break;
    size_t least = first;
    for (size_t k = first + 1; k < std::min(first + 4, size); ++k)
      if (heap_[k] < heap_[least]) least = k;
    if (!(heap_[least] < last)) break;
    heap_[at] = heap_[least];
    at = least;
  }
  heap_[at] = last;
  return top;
}

void RegionGrower::grow(std::span<const int> seeds, std::span<const Proxy> proxies,
                        const ClusterMetric& metric, std::vector<int>& region_of_face) {
  const size_t faces = static_cast<size_t>(graph_.face_count());
  region_of_face.assign(faces, -1);
  best_.assign(faces, std::numeric_limits<double>::infinity());
  heap_.clear();
  const auto& offsets = graph_.faces.offsets();
  const auto offer_neighbours = [&](int f, int region) {
    for (int c = offsets[f]; c < offsets[f + 1]; ++c) {
      const int g = graph_.beside[c];
      if (g < 0 || region_of_face[g] >= 0) continue;
      const double cost = error_density(graph_, g, proxies[region], metric);
      if (!(cost < best_[g])) continue;
      best_[g] = cost;
      push({cost, g, region});
    }
  };
  // All seeds are taken before any of them grows.
  for (size_t i = 0; i < seeds.size(); ++i) region_of_face[seeds[i]] = static_cast<int>(i);
  for (size_t i = 0; i < seeds.size(); ++i) offer_neighbours(seeds[i], static_cast<int>(i));
  while (!heap_.empty()) {
    const Offer offer = pop();
    if (region_of_face[offer.face] >= 0) continue;
    region_of_face[offer.face] = offer.region;
    offer_neighbours(offer.face, offer.region);
  }
}

}  // namespace planewright
