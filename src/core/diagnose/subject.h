// Subject: what the detectors of diagnose/ look at. All three have to outlive the call. Points, lengths:
// model units, relative to the complex's origin. Threads: a view.
#pragma once

#include "core/complex/state.h"
#include "core/diagnose/mesh_places.h"

namespace planewright {

struct Subject {
  const TangentComplex& complex;
  const State& state;
  const MeshPlaces& mesh;

  Vector3d absolute(const Vector3d& local) const { return local + complex.origin; }
  Vector3d point(int j) const { return state.x.row(j); }
  Vector3d middle(const PanelEdge& edge) const { return 0.5 * (point(edge.a) + point(edge.b)); }
  Vector3d centre(int panel) const { return centroid(state.x, complex.panels[panel]); }
};

}  // namespace planewright
