// Scene: what the viewport and the command line's pictures show, as plain arrays. The renderer draws it,
// picking casts rays at it; neither knows complexes or solvers.
//
// Units: model units relative to `origin` of the design (float on the GPU would lose far-away models
// otherwise). Threads: plain values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"

namespace planewright::render {

// A set of polygons: the panels, or the ghost of the input.
struct PolygonLayer {
  Points points;      // #N x 3
  Polygons polygons;  // #P
  // Optional scalar per polygon (#P) or per point (#N) to colour by; empty: plain card colour.
  Vector polygon_values;
  Vector point_values;
};

// What is drawn besides the panels that are worked on: other layers, the other side of thick panels, beams, a
// second surface to compare with; Crossing: Scene::crossing.
enum class Tone { OtherLayer, Back, Beam, Second, Crossing };
struct FurtherLayer {
  Tone tone;
  PolygonLayer layer;  // in plain card of its tone; values are not drawn
};

struct Marker {
  Vector3d position;
  enum class Kind { Warning, Error, Selected, Pinned } kind;
};

struct Segment {
  Vector3d a, b;
  // Warning, Error: of the panels, where something is bad; Suggested: of the input, to be clicked.
  enum class Kind { Warning, Error, Suggested, Hovered, Selected } kind;
};

// The colour map's range and what its legend says.
struct ColourScale {
  double low = 0.0, high = 1.0;     // model units
  std::string quantity;             // "Planarity"
  std::string unit;                 // "mm", "m"
  std::optional<double> tolerance;  // a hard break in the map here
  enum class Map { Viridis, Severity, Verdict } map = Map::Viridis;
};

struct Scene {
  std::optional<PolygonLayer> panels;
  std::vector<int> selected;  // panels that are tinted, ascending
  std::vector<int> crossing;  // panels that cross another surface, drawn red; ascending
  std::vector<FurtherLayer> further;
  std::optional<PolygonLayer> ghost;  // the input, drawn as a faint blue wire with a hint of faces
  std::vector<Marker> markers;
  std::vector<Segment> segments;
  std::optional<ColourScale> colours;  // set when panels carry values
};

}  // namespace planewright::render
