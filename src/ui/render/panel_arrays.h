// One state of the panels, and the ghost of the input, as the arrays that go to the GPU. They are made on
// whatever thread has time for it, so that the window's own thread only hands memory over. No OpenGL.
//
// Threads: plain values, no shared state.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "ui/render/ground_shadow.h"
#include "ui/render/panel_geometry.h"

namespace planewright::render {

struct PanelArrays {
  std::shared_ptr<const PanelGeometry> geometry;  // shared by states that are cut alike; null: no panels
  std::vector<PanelPlace> places;                 // #geometry->vertex_count()
  std::optional<GroundShadow> shadow;
};

// `before`: the geometry of an earlier state. Where its polygons are these, it is kept (the very same
// object), or its copy with those polygons cut anew that the points have folded over.
PanelArrays make_panel_arrays(const Points& points, const Polygons& polygons,
                              std::shared_ptr<const PanelGeometry> before = {});

// The triangles of some of the polygons (ascending), to be drawn once more; without shadow. The geometry of
// what is returned lists those polygons alone, and over no points that a caller has.
PanelArrays triangles_of(const PanelArrays& all, const std::vector<int>& polygons);

// Lines as rectangles: both ends in each of four corners, two triangles.
struct LineArrays {
  std::vector<std::array<float, 6>> vertices;
  std::vector<std::uint32_t> indices;
};
// ends: two per line.
LineArrays make_line_arrays(const std::vector<Vector3d>& ends);

// A mesh whose faces have one of a few colours: Palette::regions.
inline constexpr int kRegionColours = 8;
struct RegionArrays {
  PanelArrays faces;  // with lines between regions alone
  Vector colours;     // #polygons of 0..kRegionColours-1
};

struct GhostArrays {
  PanelArrays faces;
  LineArrays lines;        // every edge once
  float mean_edge = 0.0f;  // scene units
};
GhostArrays make_ghost_arrays(const Points& points, const Polygons& polygons);

}  // namespace planewright::render
