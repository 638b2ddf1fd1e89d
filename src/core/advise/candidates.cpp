#include "core/advise/candidates.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "core/diagnose/reversed_edges.h"

namespace planewright {
namespace {

constexpr double kMostDeviation = 0.35;
const double kLeastCosine = std::cos(72.0 * M_PI / 180.0);
constexpr int kFewestFaces =
    5;  // of an inner vertex before it loses one, so that its panel keeps four corners

constexpr double kJoinGivesUp = 1.0, kSplitGivesUp = 1.0, kCollapseGivesUp = 2.0;

// Of a triangle.
int opposite(const PolygonMesh& mesh, int face, const MeshEdge& edge) {
  for (const int v : mesh.corners(face))
    if (v != edge.a && v != edge.b) return v;
  return -1;
}

tl::unexpected<Error> refuse(std::string reason) {
  return fail(ErrorCode::Refused, std::move(reason));
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

  // A flip, join, split or collapse of an edge, or why not.
  Result<Candidate> consider(const MeshEdit& edit) const {
    if (auto allowed = may_apply(mesh_, edit); !allowed) return tl::unexpected(allowed.error());
    switch (edit.kind) {
      case EditKind::SplitEdge:
        return split(edit);
      case EditKind::Collapse:
        return collapse(edit);
      default:
        return diagonal(edit);
    }
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
      out.push_back({MeshEdit::collapse(shortest), shortest, ends(shortest), 0.0, 0.0, urgency(shortest)});
    for (const int v : corners) {
      if (mesh_.is_border_vertex(v) || mesh_.faces_around(v).size() == 4) continue;
      Vector3d middle = Vector3d::Zero();
      const std::vector<int> edges = mesh_.edges_around(v);
      for (const int e : edges) {
        const MeshEdge edge = mesh_.edge(e);
        middle += at(edge.a == v ? edge.b : edge.a);
      }
      middle /= static_cast<double>(edges.size());
      const MeshEdit edit = MeshEdit::move_vertex(v, middle);
      if (may_apply(mesh_, edit)) out.push_back({edit, edges.front(), {v}, 0.0, 0.0, urgency(edges.front())});
    }
  }

  double urgency(int e) const { return crossing_length_[static_cast<size_t>(e)]; }
  const PolygonMesh& mesh() const { return mesh_; }

  // The edges of the faces on both sides, the edge itself among them.
  std::vector<int> edges_beside(int e) const {
    std::vector<int> edges{e};
    const MeshEdge edge = mesh_.edge(e);
    for (const int face : {edge.left, edge.right}) {
      if (face < 0) continue;
      const std::vector<int> corners = mesh_.corners(face);
      for (size_t k = 0; k < corners.size(); ++k)
        edges.push_back(mesh_.find_edge(corners[k], corners[(k + 1) % corners.size()]));
    }
    return edges;
  }

 private:
  Vector3d at(int v) const { return mesh_.positions().row(v); }
  std::vector<int> ends(int e) const { return {mesh_.edge(e).a, mesh_.edge(e).b}; }
  // Panels keep four corners.
  bool may_lose_a_face(int v) const {
    return advised_.complex->kind != ComplexKind::Dual || mesh_.is_border_vertex(v) ||
           static_cast<int>(mesh_.faces_around(v).size()) >= kFewestFaces;
  }
  bool triangles_beside(const MeshEdge& edge) const {
    for (const int face : {edge.left, edge.right})
      if (face >= 0 && mesh_.valence(face) != 3) return false;
    return true;
  }
  std::vector<int> opposite_corners(const MeshEdge& edge) const {
    std::vector<int> corners;
    for (const int face : {edge.left, edge.right})
      if (face >= 0) corners.push_back(opposite(mesh_, face, edge));
    return corners;
  }
  Vector3d area_of(int face) const {
    const std::vector<int> corners = mesh_.corners(face);
    return newell_vector(mesh_.positions(), std::span<const int>(corners));
  }

  Result<Candidate> diagonal(const MeshEdit& edit) const {
    const int e = edit.element;
    const MeshEdge edge = mesh_.edge(e);
    if (edge.border() || !triangles_beside(edge)) return refuse("it is not between two triangles");
    if (!may_lose_a_face(edge.a) || !may_lose_a_face(edge.b))
      return refuse("a panel would have fewer than four corners");
    const std::vector<int> opposite = opposite_corners(edge);
    const int p = opposite[0], q = opposite[1];
    const Vector3d i = at(edge.a), j = at(edge.b), k = at(p), l = at(q);
    const Vector3d normal = ((j - i).cross(k - i)).normalized() + ((i - j).cross(l - j)).normalized();
    if (edit.kind == EditKind::Flip)
      for (const Vector3d& area : {Vector3d((i - k).cross(l - k)), Vector3d((j - l).cross(k - l))})
        if (!(area.dot(normal) >= kLeastCosine * area.norm() * normal.norm()))
          return refuse("the mesh would fold over");
    const double deviation = line_distance(i, j, k, l) / unit_;
    if (!(deviation <= kMostDeviation)) return refuse("it would change the surface too much");
    return Candidate{
        edit,      e, {edge.a, edge.b, p, q}, deviation, edit.kind == EditKind::Join ? kJoinGivesUp : 0.0,
        urgency(e)};
  }

  Result<Candidate> split(const MeshEdit& edit) const {
    const MeshEdge edge = mesh_.edge(edit.element);
    if (!triangles_beside(edge)) return refuse("it is not between triangles");
    std::vector<int> centre = opposite_corners(edge);
    centre.insert(centre.begin(), {edge.a, edge.b});
    return Candidate{edit, edit.element, std::move(centre), 0.0, kSplitGivesUp, urgency(edit.element)};
  }

  Result<Candidate> collapse(const MeshEdit& edit) const {
    const MeshEdge edge = mesh_.edge(edit.element);
    if (!triangles_beside(edge)) return refuse("it is not between triangles");
    const std::vector<int> opposite = opposite_corners(edge);
    for (const int v : opposite)
      if (!may_lose_a_face(v)) return refuse("a panel would have fewer than four corners");
    const bool a_on_border = mesh_.is_border_vertex(edge.a), b_on_border = mesh_.is_border_vertex(edge.b);
    const Vector3d merged = a_on_border == b_on_border ? Vector3d(0.5 * (at(edge.a) + at(edge.b)))
                            : a_on_border              ? at(edge.a)
                                                       : at(edge.b);
    double deviation = 0.0;
    for (const int end : {edge.a, edge.b}) {
      Vector3d normal = Vector3d::Zero();
      for (const int face : mesh_.faces_around(end)) {
        const Vector3d area = area_of(face);
        normal += area;
        if (face == edge.left || face == edge.right) continue;
        if (folds(face, edge, merged, area)) return refuse("the mesh would fold over");
      }
      deviation = std::max(deviation, std::abs((merged - at(end)).dot(normal.normalized())) / unit_);
    }
    if (!(deviation <= kMostDeviation)) return refuse("it would change the surface too much");
    std::vector<int> centre{edge.a, edge.b};
    centre.insert(centre.end(), opposite.begin(), opposite.end());
    return Candidate{edit,      edit.element,     std::move(centre),
                     deviation, kCollapseGivesUp, urgency(edit.element)};
  }

  // Whether a face turns away when the ends of the edge come together.
  bool folds(int face, const MeshEdge& edge, const Vector3d& merged, const Vector3d& area) const {
    const std::vector<int> corners = mesh_.corners(face);
    Points moved(static_cast<Eigen::Index>(corners.size()), 3);
    std::vector<int> order;
    for (size_t k = 0; k < corners.size(); ++k) {
      const bool end = corners[k] == edge.a || corners[k] == edge.b;
      moved.row(static_cast<Eigen::Index>(k)) = end ? merged : at(corners[k]);
      order.push_back(static_cast<int>(k));
    }
    const Vector3d after = newell_vector(moved, std::span<const int>(order));
    return !(after.dot(area) >= kLeastCosine * after.norm() * area.norm());
  }

  const Advised& advised_;
  const PolygonMesh& mesh_;
  double unit_;
  std::vector<double> crossing_length_;  // per mesh edge
};

void add(const Finder& finder, const MeshEdit& edit, std::vector<Candidate>& found) {
  if (auto candidate = finder.consider(edit)) found.push_back(std::move(*candidate));
}

}  // namespace

std::vector<Candidate> candidates_at(const Advised& advised, int mesh_edge, bool joins) {
  const Finder finder(advised);
  std::vector<Candidate> found;
  add(finder, MeshEdit::flip(mesh_edge), found);
  if (joins) add(finder, MeshEdit::join(mesh_edge), found);
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
    for (const int beside : finder.edges_beside(e)) flips.insert(beside);
  }
  std::vector<Candidate> found;
  for (const int e : flips) add(finder, MeshEdit::flip(e), found);
  for (const int e : flagged) add(finder, MeshEdit::join(e), found);
  for (const int face : quads) finder.quad(face, found);
  std::stable_sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
    return std::tuple(a.urgency, a.mesh_edge, a.edit.kind) < std::tuple(b.urgency, b.mesh_edge, b.edit.kind);
  });
  return found;
}

LastResorts last_resorts(const Advised& advised, const Finding& finding) {
  const Finder finder(advised);
  std::set<int> edges;
  for (const int e : finding.mesh_edges)
    if (e >= 0 && e < finder.mesh().edge_count())
      for (const int beside : finder.edges_beside(e)) edges.insert(beside);
  LastResorts found;
  for (const int e : edges)
    for (const MeshEdit& edit :
         {MeshEdit::flip(e), MeshEdit::join(e), MeshEdit::split_edge(e), MeshEdit::collapse(e)}) {
      if (auto candidate = finder.consider(edit))
        found.allowed.push_back(std::move(*candidate));
      else
        found.refused.push_back({edit, candidate.error().what});
    }
  return found;
}

}  // namespace planewright
