#include "core/mesh/edge_table.h"

#include <algorithm>
#include <map>
#include <utility>

namespace planewright {

EdgeTable build_edge_table(const Polygons& faces, int vertex_count) {
  const std::vector<int>& indices = faces.indices();
  const int corner_count = static_cast<int>(indices.size());
  EdgeTable table;
  table.face_of_corner.resize(corner_count);
  table.edge_of_corner.assign(corner_count, -1);
  table.corners.resize(corner_count);

  // Sorted by the smaller end with a counting sort, then inside each bucket by the greater end and the
  // corner: fast for common meshes, and still n log n for a fan of a million triangles.
  std::vector<int> bucket(static_cast<size_t>(vertex_count) + 1, 0);
  auto ends = [&](int f, int c) { return std::minmax(indices[c], indices[next_corner(faces, f, c)]); };
  for (int f = 0; f < faces.size(); ++f)
    for (int c = faces.offsets()[f]; c < faces.offsets()[f + 1]; ++c) {
      table.face_of_corner[c] = f;
      ++bucket[ends(f, c).first + 1];
    }
  for (int v = 0; v < vertex_count; ++v) bucket[v + 1] += bucket[v];
  std::vector<std::pair<int, int>> sorted(corner_count);  // greater end, corner
  {
    std::vector<int> fill(bucket.begin(), bucket.end() - 1);
    for (int f = 0; f < faces.size(); ++f)
      for (int c = faces.offsets()[f]; c < faces.offsets()[f + 1]; ++c) {
        const auto [low, high] = ends(f, c);
        sorted[fill[low]++] = {high, c};
      }
  }

  // Each run of equal ends is an edge. Its first corner stands for it until the edges get their numbers.
  for (int v = 0; v < vertex_count; ++v) {
    const auto begin = sorted.begin() + bucket[v], end = sorted.begin() + bucket[v + 1];
    std::sort(begin, end);
    for (auto run = begin; run != end;) {
      auto i = run;
      for (; i != end && i->first == run->first; ++i) table.edge_of_corner[i->second] = run->second;
      run = i;
    }
  }
  int edges = 0;
  std::vector<int> count;
  for (int c = 0; c < corner_count; ++c) {
    const int representative = table.edge_of_corner[c];  // c itself, or an earlier corner, numbered already
    table.edge_of_corner[c] = representative == c ? edges++ : table.edge_of_corner[representative];
    if (representative == c) count.push_back(0);
    ++count[table.edge_of_corner[c]];
  }
  table.first.assign(static_cast<size_t>(edges) + 1, 0);
  for (int e = 0; e < edges; ++e) table.first[e + 1] = table.first[e] + count[e];
  std::vector<int> fill(table.first.begin(), table.first.end() - 1);
  for (int c = 0; c < corner_count; ++c) table.corners[fill[table.edge_of_corner[c]]++] = c;
  return table;
}

int renumber(EdgeTable& table, const Polygons& faces, std::span<const std::array<int, 2>> edges) {
  const std::vector<int>& indices = faces.indices();
  std::map<std::array<int, 2>, int> corner_of;  // by the ends of its edge, in its direction
  for (int f = 0; f < faces.size(); ++f)
    for (int c = faces.offsets()[f]; c < faces.offsets()[f + 1]; ++c)
      corner_of[{indices[c], indices[next_corner(faces, f, c)]}] = c;

  EdgeTable renumbered = table;
  std::vector<char> taken(edges.size(), 0);
  renumbered.corners.clear();
  for (size_t e = 0; e < edges.size(); ++e) {
    const auto found = corner_of.find(edges[e]);
    if (found == corner_of.end()) return static_cast<int>(e);
    const int first = found->second, old = table.edge_of_corner[first];
    if (taken[old]) return static_cast<int>(e);
    taken[old] = 1;
    renumbered.first[e] = static_cast<int>(renumbered.corners.size());
    renumbered.corners.push_back(first);
    for (int k = 0; k < table.corner_count(old); ++k)
      if (table.corner(old, k) != first) renumbered.corners.push_back(table.corner(old, k));
    for (int k = 0; k < table.corner_count(old); ++k)
      renumbered.edge_of_corner[table.corner(old, k)] = static_cast<int>(e);
  }
  table = std::move(renumbered);
  return -1;
}

}  // namespace planewright
