// Layout: where each unknown of a complex stands in the solver's vector z, and which of them are free.
//
// z = (x_0, ..., x_X-1, n_0, ..., n_P-1, h_0, ..., h_P-1): 3X + 4P numbers, 0-based. Normalised units:
// lengths in mean edges, centroid of the wanted points at 0. Nodes: points 0..X-1, then planes X..X+P-1.
#pragma once

#include <cstddef>
#include <vector>

namespace planewright {

// The three stages of [Z 2.1, 2.2].
enum class Freedom {
  Fixed,              // classic tangent plane intersection; the energies settle flat places alone
  Normals,            // normals turn, offsets stay
  NormalsAndOffsets,  // both
};

struct Layout {
  int points = 0;
  int planes = 0;
  Freedom freedom = Freedom::NormalsAndOffsets;
  // Nodes that stay where they are, because only a patch of the complex is solved (1 = outside it); empty:
  // none.
  std::vector<char> outside = {};

  int size() const { return 3 * points + 4 * planes; }
  int x(int point, int axis = 0) const { return 3 * point + axis; }
  int n(int plane, int axis = 0) const { return 3 * points + 3 * plane + axis; }
  int h(int plane) const { return 3 * points + 3 * planes + plane; }
  int node_of(int variable) const {
    if (variable < 3 * points) return variable / 3;
    if (variable < 3 * (points + planes)) return points + (variable - 3 * points) / 3;
    return points + variable - 3 * (points + planes);
  }
  bool is_outside(int node) const { return !outside.empty() && outside[static_cast<std::size_t>(node)] != 0; }
  bool is_free(int variable) const {
    if (is_outside(node_of(variable))) return false;
    if (variable < 3 * points) return true;
    if (variable < 3 * points + 3 * planes) return freedom != Freedom::Fixed;
    return freedom == Freedom::NormalsAndOffsets;
  }
};

}  // namespace planewright
