#include "core/cluster/seeds.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace planewright {

int draw_below(std::mt19937& random, int count) {
  const std::uint64_t range = std::uint64_t{1} << 32, n = static_cast<std::uint64_t>(count);
  const std::uint64_t limit = range - range % n;
  std::uint64_t drawn;
  do drawn = static_cast<std::uint64_t>(random());
  while (drawn >= limit);
  return static_cast<int>(drawn % n);
}

std::vector<int> random_seeds(const FaceGraph& graph, int count, std::uint32_t seed_number) {
  std::mt19937 random(seed_number);
  const int faces = graph.face_count();
  std::vector<int> order(static_cast<size_t>(faces));
  for (int f = 0; f < faces; ++f) order[f] = f;
  for (int k = 0; k < faces - 1; ++k) std::swap(order[k], order[k + draw_below(random, faces - k)]);
  // The first of each component, then the first of what is left.
  std::vector<char> taken(order.size(), 0), seeded(static_cast<size_t>(graph.component_count()), 0);
  std::vector<int> seeds;
  for (const int f : order) {
    char& done = seeded[graph.component_of_face[f]];
    if (done) continue;
    done = 1;
    taken[f] = 1;
    seeds.push_back(f);
  }
  for (const int f : order)
    if (static_cast<int>(seeds.size()) < count && !taken[f]) seeds.push_back(f);
  std::sort(seeds.begin(), seeds.end());
  return seeds;
}

std::vector<int> farthest_seeds(const FaceGraph& graph, int count) {
  const size_t faces = static_cast<size_t>(graph.face_count());
  std::vector<double> distance(faces, std::numeric_limits<double>::infinity());
  std::vector<int> seeds;
  // The first of each component is the largest face of it; a component without one is infinitely far.
  std::vector<int> first(static_cast<size_t>(graph.component_count()), -1);
  for (size_t f = 0; f < faces; ++f) {
    int& largest = first[graph.component_of_face[f]];
    if (largest < 0 || graph.shapes[f].area > graph.shapes[largest].area) largest = static_cast<int>(f);
  }
  int farthest = -1;
  const auto take = [&](int seed) {
    seeds.push_back(seed);
    const FaceShape at = graph.shapes[seed];
    const int component = graph.component_of_face[seed];
    const bool alone = graph.component_count() == 1;
    double most = -1.0;
    distance[seed] = -1.0;
    for (size_t f = 0; f < faces; ++f) {
      const FaceShape& shape = graph.shapes[f];
      if (alone || graph.component_of_face[f] == component) {
        // A face without area is nobody's choice while there are others.
        const double d = shape.area > 0.0
                             ? (shape.normal - at.normal).squaredNorm() +
                                   4.0 * std::numbers::pi * (shape.centre - at.centre).squaredNorm()
                             : 0.0;
        distance[f] = std::min(distance[f], d);
      }
      if (distance[f] > most) {
        most = distance[f];
        farthest = static_cast<int>(f);
      }
    }
  };
  for (const int f : first) take(f);
  while (static_cast<int>(seeds.size()) < count) take(farthest);
  return seeds;
}

}  // namespace planewright
