#include "core/diagnose/reversed_edges.h"

#include <Eigen/Geometry>

namespace planewright {
namespace {

// Any vector along which the edge should run.
Vector3d forwards(const TangentComplex& complex, int panel_edge) {
  const PanelEdge& edge = complex.panel_edges[static_cast<size_t>(panel_edge)];
  const auto [i, j] = complex.crossed_edge[static_cast<size_t>(panel_edge)];
  if (i < 0) return complex.preferred.row(edge.b) - complex.preferred.row(edge.a);
  Vector3d normal = Vector3d::Zero();
  for (const int point : {edge.a, edge.b})
    if (const int face = complex.face_of_point[static_cast<size_t>(point)]; face >= 0)
      normal += complex.input.face_normals.row(face);
  const Vector3d along = complex.input.vertices.row(j) - complex.input.vertices.row(i);
  return normal.cross(along);
}

}  // namespace

double signed_length(const TangentComplex& complex, const State& state, int panel_edge) {
  const PanelEdge& edge = complex.panel_edges[static_cast<size_t>(panel_edge)];
  const Vector3d run = state.x.row(edge.b) - state.x.row(edge.a);
  return run.dot(forwards(complex, panel_edge)) < 0.0 ? -run.norm() : run.norm();
}

std::vector<Finding> find_reversed_edges(const Subject& subject, double threshold) {
  const TangentComplex& complex = subject.complex;
  std::vector<Finding> found;
  for (size_t e = 0; e < complex.panel_edges.size(); ++e) {
    const int index = static_cast<int>(e);
    const double back = -signed_length(complex, subject.state, index) / complex.mean_edge;
    if (!(back > threshold)) continue;
    found.push_back(make_finding(FindingKind::ReversedEdge, {ElementKind::PanelEdge, index}, back, threshold,
                                 back - threshold));
    found.back().place = subject.absolute(subject.middle(complex.panel_edges[e]));
    found.back().cause =
        complex.crossed_edge[e][0] < 0
            ? "it runs against its direction in the design"
            : "it runs backwards over the mesh edge that it crosses, whose other diagonal may fit";
    found.back().mesh_edges = subject.mesh.of_panel_edge(index);
  }
  return found;
}

}  // namespace planewright
