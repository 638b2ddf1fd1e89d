#include "core/complex/dual.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/complex/local_mesh.h"

namespace planewright {
namespace {

class DualBuilder {
 public:
  DualBuilder(const PolygonMesh& primal, const DualOptions& options)
      : primal_(primal), options_(options), local_(primal), faces_(primal.faces()) {}

  Result<TangentComplex> build() {
    add_planes();
    if (complex_.plane_origin.empty())
      return fail(ErrorCode::Refused, "no panel results: every vertex lies on the border", {},
                  "Use the border policy 'closed', or a mesh with inner vertices");
    for (int f = 0; f < primal_.face_count(); ++f) add_face_point(f);
    if (options_.border == BorderPolicy::Closed) {
      add_border_edge_points();
      add_corners();
    }
    add_panels();
    store_points();
    finish(complex_);
    complex_.input = local_.input_surface(primal_);
    add_crossed_edges();
    return std::move(complex_);
  }

 private:
  void add_planes() {
    plane_of_vertex_.assign(static_cast<size_t>(primal_.vertex_count()), -1);
    for (int v = 0; v < primal_.vertex_count(); ++v) {
      if (primal_.is_isolated(v)) continue;
      if (options_.border == BorderPolicy::Interior && primal_.is_border_vertex(v)) continue;
      plane_of_vertex_[v] = static_cast<int>(complex_.plane_origin.size());
      complex_.plane_origin.push_back(v);
    }
    const int count = static_cast<int>(complex_.plane_origin.size());
    complex_.kind = ComplexKind::Dual;
    complex_.origin = local_.origin;
    complex_.anchors.resize(count, 3);
    complex_.normals.resize(count, 3);
    complex_.offsets = Vector::Constant(count, options_.offset);
    for (int i = 0; i < count; ++i) {
      const int v = complex_.plane_origin[i];
      complex_.anchors.row(i) = local_.positions.row(v);
      complex_.normals.row(i) = local_.vertex_normal(primal_, v);
    }
  }

  // face: the mesh face it belongs to, or -1.
  int add_point(const Vector3d& wanted, PointOrigin origin, int face, std::vector<int> planes) {
    std::sort(planes.begin(), planes.end());
    planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
    wanted_.push_back(wanted);
    complex_.point_origin.push_back(origin);
    complex_.face_of_point.push_back(face);
    complex_.planes_of_point.push_back(planes);
    return static_cast<int>(wanted_.size()) - 1;
  }

  void add_face_point(int f) {
    std::vector<int> planes;
    for (int v : faces_[f])
      if (plane_of_vertex_[v] >= 0) planes.push_back(plane_of_vertex_[v]);
    if (planes.empty()) {  // Interior: all corners lie on the border
      point_of_face_.push_back(-1);
      return;
    }
    const Vector3d wanted = centroid(local_.positions, faces_[f]) + options_.offset * local_.face_normal(f);
    point_of_face_.push_back(add_point(wanted, {PointKind::Face, f}, f, std::move(planes)));
  }

  void add_border_edge_points() {
    point_of_edge_.assign(static_cast<size_t>(primal_.edge_count()), -1);
    for (int e = 0; e < primal_.edge_count(); ++e) {
      const MeshEdge edge = primal_.edge(e);
      if (!edge.border()) continue;
      const int face = edge.left >= 0 ? edge.left : edge.right;
      const Vector3d middle = 0.5 * (local_.positions.row(edge.a) + local_.positions.row(edge.b));
      point_of_edge_[e] =
          add_point(middle + options_.offset * local_.face_normal(face), {PointKind::BorderEdge, e}, face,
                    {plane_of_vertex_[edge.a], plane_of_vertex_[edge.b]});
    }
  }

  void add_corners() {
    corner_of_vertex_.assign(static_cast<size_t>(primal_.vertex_count()), -1);
    for (int v = 0; v < primal_.vertex_count(); ++v) {
      const int i = plane_of_vertex_[v];
      if (i < 0 || !primal_.is_border_vertex(v)) continue;
      const Vector3d wanted = complex_.anchors.row(i) + options_.offset * complex_.normals.row(i);
      corner_of_vertex_[v] = add_point(wanted, {PointKind::Corner, v}, -1, {i});
    }
  }

  // Faces round a vertex run counter-clockwise, so do their points. At the border the outline goes on from
  // the last face over the arriving border edge's point, the corner, and the leaving border edge's point back
  // to the first.
  void add_panels() {
    for (int v : complex_.plane_origin) {
      std::vector<int> panel;
      const bool border = primal_.is_border_vertex(v);
      const auto edges = primal_.edges_around(v);
      if (border) panel.push_back(point_of_edge_[edges.front()]);
      for (int f : primal_.faces_around(v)) panel.push_back(point_of_face_[f]);
      // edges[k] lies before faces[k]; so do the steps of the outline that cross it.
      const size_t first = border ? 0 : 1;
      if (border) panel.push_back(point_of_edge_[edges.back()]);
      for (size_t k = 0; k < (border ? panel.size() - 1 : panel.size()); ++k)
        crossings_.push_back({panel[k], panel[(k + 1) % panel.size()], v,
                              other_end(edges[(k + first) % edges.size()], v)});
      if (border) panel.push_back(corner_of_vertex_[v]);
      complex_.panels.push_back(panel);
    }
  }

  int other_end(int edge, int v) const {
    const MeshEdge e = primal_.edge(edge);
    return e.a == v ? e.b : e.a;
  }

  // Valence-2 vertices can give two panel edges between the same points: those of the same left panel.
  void add_crossed_edges() {
    std::map<std::array<int, 3>, int> across;  // a, b, vertex whose outline runs a -> b
    for (const Crossing& c : crossings_) across[{c.a, c.b, c.vertex}] = c.other;
    for (const PanelEdge& edge : complex_.panel_edges) {
      std::array<int, 2> crossed{-1, -1};
      if (edge.left >= 0) {
        const int vertex = complex_.plane_origin[edge.left];
        if (const auto found = across.find({edge.a, edge.b, vertex}); found != across.end())
          crossed = {vertex, found->second};
      } else {
        const int vertex = complex_.plane_origin[edge.right];
        if (const auto found = across.find({edge.b, edge.a, vertex}); found != across.end())
          crossed = {found->second, vertex};
      }
      complex_.crossed_edge.push_back(crossed);
    }
  }

  void store_points() {
    complex_.preferred.resize(static_cast<Eigen::Index>(wanted_.size()), 3);
    for (size_t j = 0; j < wanted_.size(); ++j)
      complex_.preferred.row(static_cast<Eigen::Index>(j)) = wanted_[j];
  }

  const PolygonMesh& primal_;
  const DualOptions& options_;
  LocalMesh local_;
  Polygons faces_;
  TangentComplex complex_;
  std::vector<Vector3d> wanted_;
  // A step a -> b of the outline of `vertex`'s panel crosses the mesh edge from there to `other`.
  struct Crossing {
    int a, b, vertex, other;
  };
  std::vector<Crossing> crossings_;
  std::vector<int> plane_of_vertex_, point_of_face_, point_of_edge_, corner_of_vertex_;
};

}  // namespace

Result<TangentComplex> build_dual(const PolygonMesh& primal, const DualOptions& options) {
  if (!std::isfinite(options.offset))
    return fail(ErrorCode::Usage, "the offset is not a finite number", "offset",
                "Give a length in model units");
  return DualBuilder(primal, options).build();
}

}  // namespace planewright
