// The triangles that draw a polygon layer, as the arrays that go to the GPU. No OpenGL, so it can be tested,
// and made, anywhere.
//
// What hangs on the polygons alone is made once (triangles, which of their edges are panel edges); what hangs
// on the points is written anew for each iterate in one pass over them. Threads: no shared state.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ui/render/scene.h"

namespace planewright::render {

// Bits of a triangle's edge mask: edge k lies opposite its corner k.
constexpr std::uint32_t edge_bit(int k) {
  return 1u << k;
}  // an edge of the polygon, not a diagonal
constexpr std::uint32_t border_edge_bit(int k) {
  return 1u << (k + 3);
}  // and no other polygon shares it

struct PanelShape {         // per triangle corner, fixed
  std::uint32_t edge_mask;  // of the triangle; the same in its three corners
  float size;               // of the polygon: the root of its area when it was made, scene units
};

struct PanelPlace {  // per triangle corner, changes with the points
  float x, y, z;
  std::uint32_t normal;  // unit normal of the whole polygon, signed 10-10-10-2 bits as OpenGL has them
};

struct PanelGeometry {
  Polygons polygons;
  std::vector<char> border;  // per entry of polygons.indices(): the edge from it to the next is a border
  std::vector<int> corners;  // #triangles x 3 rows of the points
  std::vector<int> first_triangle;  // #polygons + 1
  std::vector<PanelShape> shapes;   // #triangles x 3

  int vertex_count() const { return static_cast<int>(corners.size()); }
};

// Cuts the polygons into triangles. Polygons with fewer than 3 corners are left out.
PanelGeometry make_panel_geometry(const Points& points, const Polygons& polygons);

// The polygons that have a triangle facing the other way: cut for other points, or crossing themselves.
std::vector<int> find_folded(const PanelGeometry& geometry, const Points& points);
// Cuts one polygon anew, in the place of its old triangles. False when they stay the same.
bool cut_again(PanelGeometry& geometry, const Points& points, int polygon);

// out: #vertex_count. points may differ from those the geometry was made with, not in number.
void write_places(const PanelGeometry& geometry, const Points& points, std::span<PanelPlace> out);

// Spreads one value per polygon or per point onto the triangle corners; where both are given, the polygons
// win; what is missing or not finite becomes kNoValue (plain card). out: #vertex_count.
inline constexpr float kNoValue = 3e38f;
void write_values(const PanelGeometry& geometry, const Vector& polygon_values, const Vector& point_values,
                  std::span<float> out);

// A unit vector as OpenGL's GL_INT_2_10_10_10_REV; the zero vector becomes straight up.
std::uint32_t pack_normal(const Vector3d& normal);

}  // namespace planewright::render
