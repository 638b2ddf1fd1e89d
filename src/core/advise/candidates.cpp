#include "core/advise/candidates.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/diagnose/reversed_edges.h"

namespace planewright {
namespace {

constexpr double kMostDeviation = 0.35;
const double kLeastCosine = std::cos(72.0 * M_PI / 180.0);
constexpr int kFewestFaces =
    5;  // of an inner vertex before it loses one, so that its panel keeps four corners

int opposite(const PolygonMesh& mesh, int face, const MeshEdge& edge) {
  for (const int v : mesh.corners(face))
    if (v != edge.a && v != edge.b) return v;
  return -1;
}

double line_distance(const Vector3d& a, const Vector3d& b, const Vector3d& p, const Vector3d& q) {
  const Vector3d across = (b - a).cross(q - p);
  const double length = across.norm();
  if (length <= 1e-12 * (b - a).norm() * (q - p).norm()) return (p - a).norm();
  return std::abs((p - a).dot(across)) / length;
}

class Finder {
 public:
  explicit Finder(const Advised& advised)
      : advised_(advised), mesh_(*advised.mesh), unit_(advised.complex->mean_edge) {
    crossing_length_.assign(static_cast<size_t>(mesh_.edge_count()), std::numeric_limits<double>::infinity());
    const TangentComplex& complex = *advised.complex;
    for (size_t e = 0; e < complex.panel_edges.size(); ++e) {
      const PanelEdge& edge = complex.panel_edges[e];
      int mesh_edge = -1;
      if (complex.kind == ComplexKind::Dual && complex.crossed_edge[e][0] >= 0)
        mesh_edge = mesh_.find_edge(complex.crossed_edge[e][0], complex.crossed_edge[e][1]);
      else if (complex.kind == ComplexKind::Planarize)
        mesh_edge = mesh_.find_edge(complex.point_origin[static_cast<size_t>(edge.a)].element,
                                    complex.point_origin[static_cast<size_t>(edge.b)].element);
      if (mesh_edge >= 0)
        crossing_length_[static_cast<size_t>(mesh_edge)] =
            std::abs(signed_length(complex, advised.state, static_cast<int>(e))) / unit_;
    }
  }

  void flip(int e, std::vector<Candidate>& out) const {
    if (may_apply(mesh_, MeshEdit::flip(e))) add_diagonal(MeshEdit::flip(e), e, out);
  }
  void join(int e, std::vector<Candidate>& out) const {
    if (may_apply(mesh_, MeshEdit::join(e))) add_diagonal(MeshEdit::join(e), e, out);
  }

  void quad(int face, std::vector<Candidate>& out) const {
    const std::vector<int> corners = mesh_.corners(face);
    const size_t n = corners.size();
    int shortest = -1;
    for (size_t k = 0; k < n; ++k) {
      const int e = mesh_.find_edge(corners[k], corners[(k + 1) % n]);
      if (shortest < 0 || urgency(e) < urgency(shortest)) shortest = e;
    }
    if (may_apply(mesh_, MeshEdit::collapse(shortest)))
      out.push_back({MeshEdit::collapse(shortest), shortest, ends(shortest), 0.0, urgency(shortest)});
    for (const int v : corners) {
      if (mesh_.is_border_vertex(v) || mesh_.faces_around(v).size() == 4) continue;
      Vector3d middle = Vector3d::Zero();
      const std::vector<int> edges = mesh_.edges_around(v);
      for (const int e : edges) {
        const MeshEdge edge = mesh_.edge(e);
        middle += mesh_.positions().row(edge.a == v ? edge.b : edge.a).transpose();
      }
      middle /= static_cast<double>(edges.size());
      const MeshEdit edit = MeshEdit::move_vertex(v, middle);
      if (may_apply(mesh_, edit)) out.push_back({edit, edges.front(), {v}, 0.0, urgency(edges.front())});
    }
  }

  double urgency(int e) const { return crossing_length_[static_cast<size_t>(e)]; }
  const PolygonMesh& mesh() const { return mesh_; }

 private:
  Vector3d at(int v) const { return mesh_.positions().row(v); }
  std::vector<int> ends(int e) const { return {mesh_.edge(e).a, mesh_.edge(e).b}; }
  bool may_lose_a_face(int v) const {
    return mesh_.is_border_vertex(v) || static_cast<int>(mesh_.faces_around(v).size()) >= kFewestFaces;
  }

  void add_diagonal(const MeshEdit& edit, int e, std::vector<Candidate>& out) const {
    const MeshEdge edge = mesh_.edge(e);
    if (edge.border() || mesh_.valence(edge.left) != 3 || mesh_.valence(edge.right) != 3) return;
    if (advised_.complex->kind == ComplexKind::Dual && (!may_lose_a_face(edge.a) || !may_lose_a_face(edge.b)))
      return;
    const int p = opposite(mesh_, edge.left, edge), q = opposite(mesh_, edge.right, edge);
    const Vector3d i = at(edge.a), j = at(edge.b), k = at(p), l = at(q);
    const Vector3d normal = ((j - i).cross(k - i)).normalized() + ((i - j).cross(l - j)).normalized();
    if (edit.kind == EditKind::Flip)
      for (const Vector3d& area : {Vector3d((i - k).cross(l - k)), Vector3d((j - l).cross(k - l))})
        if (!(area.dot(normal) >= kLeastCosine * area.norm() * normal.norm())) return;
    const double deviation = line_distance(i, j, k, l) / unit_;
    if (!(deviation <= kMostDeviation)) return;
    out.push_back({edit, e, {edge.a, edge.b, p, q}, deviation, urgency(e)});
  }

  const Advised& advised_;
  const PolygonMesh& mesh_;
  double unit_;
  std::vector<double> crossing_length_;  // per mesh edge
};

}  // namespace

std::vector<Candidate> candidates_at(const Advised& advised, int mesh_edge, bool joins) {
  const Finder finder(advised);
  std::vector<Candidate> found;
  finder.flip(mesh_edge, found);
  if (joins) finder.join(mesh_edge, found);
  return found;
}

std::vector<Candidate> find_candidates(const Advised& advised, const std::vector<Finding>& findings) {
  const Finder finder(advised);
  const PolygonMesh& mesh = finder.mesh();
  std::set<int> flagged, quads;
  for (const Finding& finding : findings) {
    if (!calls_for_edits(finding.kind)) continue;
    for (const int edge : finding.mesh_edges) {
      // Findings number the edges of the complex's input, which are the mesh's.
      if (edge >= 0 && edge < mesh.edge_count()) flagged.insert(edge);
    }
    if (finding.kind == FindingKind::CollapsedQuad)
      quads.insert(advised.complex->plane_origin[static_cast<size_t>(finding.element.index)]);
  }
  std::set<int> flips;
  for (const int e : flagged) {
    flips.insert(e);
    const MeshEdge edge = mesh.edge(e);
    for (const int face : {edge.left, edge.right}) {
      if (face < 0 || mesh.valence(face) != 3) continue;
      const std::vector<int> corners = mesh.corners(face);
      for (size_t k = 0; k < 3; ++k) flips.insert(mesh.find_edge(corners[k], corners[(k + 1) % 3]));
    }
  }
  std::vector<Candidate> found;
  for (const int e : flips) finder.flip(e, found);
  for (const int e : flagged) finder.join(e, found);
  for (const int face : quads) finder.quad(face, found);
  std::stable_sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
    return std::tuple(a.urgency, a.mesh_edge, a.edit.kind) < std::tuple(b.urgency, b.mesh_edge, b.edit.kind);
  });
  return found;
}

}  // namespace planewright
