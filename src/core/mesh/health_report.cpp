#include "core/mesh/health_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

#include "core/mesh/edge_table.h"
#include "core/mesh/point_index.h"

namespace planewright {
namespace {

// A face is said to have no area below this many squared mean edges.
constexpr double kLeastArea = 1e-12;

struct KindName {
  const char *one, *many;
};
// In the order of DefectKind.
constexpr std::array<KindName, 10> kNames{{
    {"non-manifold edge", "non-manifold edges"},
    {"non-manifold vertex", "non-manifold vertices"},
    {"inconsistently oriented face", "inconsistently oriented faces"},
    {"one-sided component", "one-sided components"},
    {"face with a repeated corner", "faces with a repeated corner"},
    {"degenerate face", "degenerate faces"},
    {"duplicate face", "duplicate faces"},
    {"duplicate vertex", "duplicate vertices"},
    {"isolated vertex", "isolated vertices"},
    {"index list that counts from 1", "index lists that count from 1"},
}};

std::string counted(int n, const char* one, const char* many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

// Sets of elements that grow together; the smallest element names the set.
class DisjointSets {
 public:
  explicit DisjointSets(int size) : parent_(static_cast<size_t>(size)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int find(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(int i, int j) {
    i = find(i), j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

 private:
  std::vector<int> parent_;
};

// One pass over raw polygons: each step finds one kind of defect, repairs it, and leaves polygons that the
// next step may rely on. Vertices keep the file's numbers until split_vertices().
class Repair {
 public:
  Repair(const Points& positions, const Polygons& faces) : positions_(positions), file_faces_(faces) {
    health_.vertices = static_cast<int>(positions.rows());
    health_.faces = faces.size();
  }

  Result<CheckedMesh> run() {
    if (auto ok = check_input(); !ok) return tl::unexpected(ok.error());
    drop_repeated_corners();
    drop_duplicate_faces();
    if (faces_.empty())
      return fail(ErrorCode::Refused, "no face of the mesh has 3 distinct corners", {},
                  "Check that the file holds a surface");
    edges_ = build_edge_table(faces_, health_.vertices);
    find_non_manifold();
    orient();
    split_vertices();
    measure();
    find_duplicate_and_isolated_vertices();

    std::sort(health_.defects.begin(), health_.defects.end(),
              [](const Defect& a, const Defect& b) { return a.kind < b.kind; });
    auto mesh = PolygonMesh::from_polygons(split_positions(), faces_);
    if (!mesh) return tl::unexpected(mesh.error());
    return CheckedMesh{std::move(*mesh), std::move(health_), std::move(vertex_origin_),
                       std::move(face_origin_)};
  }

 private:
  Defect& defect(DefectKind kind) {
    for (Defect& d : health_.defects)
      if (d.kind == kind) return d;
    health_.defects.push_back({kind, 0, {}, {}});
    return health_.defects.back();
  }

  void note(DefectKind kind, int element, bool repaired = true) {
    Defect& d = defect(kind);
    ++d.count;
    if (d.elements.size() < Defect::kMaxListed) d.elements.push_back(element);
    health_.repaired |= repaired;
  }

  void list_edge(DefectKind kind, int e) {
    Defect& d = defect(kind);
    if (d.elements.size() >= 2 * Defect::kMaxListed) return;
    const int c = edges_.corner(e, 0);
    const int next = next_corner(faces_, edges_.face_of_corner[c], c);
    d.elements.push_back(faces_.indices()[c]);
    d.elements.push_back(faces_.indices()[next]);
  }

  Result<void> check_input() const {
    if (file_faces_.empty())
      return fail(ErrorCode::Refused, "the mesh has no faces", {},
                  "Export it as a polygon mesh with its faces");
    for (Eigen::Index v = 0; v < positions_.rows(); ++v)
      if (!positions_.row(v).allFinite())
        return fail(ErrorCode::Refused, "a coordinate is not a finite number", "vertex " + std::to_string(v),
                    "Correct or remove the vertex");
    for (int f = 0; f < file_faces_.size(); ++f)
      for (int v : file_faces_[f])
        if (v < 0 || v >= positions_.rows())
          return fail(ErrorCode::Refused,
                      "the face names vertex " + std::to_string(v) + ", but there are " +
                          std::to_string(positions_.rows()) + " vertices",
                      "face " + std::to_string(f), "Correct or remove the face");
    return {};
  }

  // Leaves faces with at least 3 corners, all distinct.
  void drop_repeated_corners() {
    faces_.reserve(file_faces_.size(), static_cast<int>(file_faces_.indices().size()));
    std::vector<int> seen_in(static_cast<size_t>(positions_.rows()), -1);
    std::vector<int> corners;
    for (int f = 0; f < file_faces_.size(); ++f) {
      corners.clear();
      for (int v : file_faces_[f]) {
        if (seen_in[v] != f) corners.push_back(v);
        seen_in[v] = f;
      }
      if (corners.size() < 3) {
        note(DefectKind::DegenerateFace, f);
        defect(DefectKind::DegenerateFace).action = "dropped";
        continue;
      }
      if (static_cast<int>(corners.size()) < file_faces_.valence(f)) {
        note(DefectKind::RepeatedCorner, f);
        defect(DefectKind::RepeatedCorner).action = "corner dropped from the face";
      }
      faces_.push_back(corners);
      face_origin_.push_back(f);
    }
  }

  // Faces with the same set of corners as an earlier one. Equal sets are found through a hash that does not
  // depend on the order of the corners, and then compared.
  void drop_duplicate_faces() {
    auto mix = [](std::uint64_t x) {
      x = (x + 0x9e3779b97f4a7c15u) * 0xbf58476d1ce4e5b9u;
      x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
      return x ^ (x >> 31);
    };
    std::vector<std::pair<std::uint64_t, int>> order(static_cast<size_t>(faces_.size()));
    for (int f = 0; f < faces_.size(); ++f) {
      std::uint64_t sum = static_cast<std::uint64_t>(faces_.valence(f));
      for (int v : faces_[f]) sum += mix(static_cast<std::uint64_t>(v));
      order[f] = {sum, f};
    }
    std::sort(order.begin(), order.end());
    auto sorted_corners = [&](int f) {
      std::vector<int> corners(std::as_const(faces_)[f].begin(), std::as_const(faces_)[f].end());
      std::sort(corners.begin(), corners.end());
      return corners;
    };
    std::vector<char> drop(static_cast<size_t>(faces_.size()), 0);
    bool any = false;
    for (size_t run = 0; run < order.size();) {
      size_t end = run + 1;
      while (end < order.size() && order[end].first == order[run].first) ++end;
      if (end - run > 1) {
        const std::vector<int> first = sorted_corners(order[run].second);
        for (size_t i = run + 1; i < end; ++i)
          if (sorted_corners(order[i].second) == first) {
            drop[order[i].second] = 1;
            any = true;
          }
      }
      run = end;
    }
    if (!any) return;

    Polygons kept;
    std::vector<int> kept_origin;
    for (int f = 0; f < faces_.size(); ++f) {
      if (drop[f]) {
        note(DefectKind::DuplicateFace, face_origin_[f]);
        continue;
      }
      kept.push_back(std::as_const(faces_)[f]);
      kept_origin.push_back(face_origin_[f]);
    }
    defect(DefectKind::DuplicateFace).action = "dropped";
    faces_ = std::move(kept);
    face_origin_ = std::move(kept_origin);
  }

  // The corners of both faces at both ends of an edge, in pairs that belong to the same vertex. Holds
  // whichever way the faces run.
  template <class Join>
  void pair_corners(int c, int d, Join&& join) const {
    const int c_next = next_corner(faces_, edges_.face_of_corner[c], c);
    const int d_next = next_corner(faces_, edges_.face_of_corner[d], d);
    const bool same_direction = faces_.indices()[c] == faces_.indices()[d];
    join(c, same_direction ? d : d_next);
    join(c_next, same_direction ? d_next : d);
  }

  // Edges with more than two faces are cut; vertices whose faces hang together only there are named.
  void find_non_manifold() {
    cut_.assign(static_cast<size_t>(edges_.size()), 0);
    DisjointSets fans(static_cast<int>(faces_.indices().size()));
    for (int e = 0; e < edges_.size(); ++e) {
      for (int k = 1; k < edges_.corner_count(e); ++k)
        pair_corners(edges_.corner(e, 0), edges_.corner(e, k), [&](int i, int j) { fans.join(i, j); });
      if (edges_.corner_count(e) <= 2) continue;
      cut_[e] = 1;
      list_edge(DefectKind::NonManifoldEdge, e);
      Defect& d = defect(DefectKind::NonManifoldEdge);
      ++d.count;
      d.action = "faces detached";
      health_.repaired = true;
    }

    std::vector<int> fan_count(static_cast<size_t>(positions_.rows()), 0);
    for (int c = 0; c < static_cast<int>(faces_.indices().size()); ++c)
      if (fans.find(c) == c) ++fan_count[faces_.indices()[c]];
    int copies = 0;
    for (int v = 0; v < static_cast<int>(fan_count.size()); ++v) {
      if (fan_count[v] < 2) continue;
      note(DefectKind::NonManifoldVertex, v);
      copies += fan_count[v];
    }
    if (copies > 0)
      defect(DefectKind::NonManifoldVertex).action = "split into " + std::to_string(copies) + " vertices";
  }

  // Gives the faces of each component one orientation: that of its majority, or of its first face. The search
  // goes through edges where the file agrees with itself first, so that only what disagrees is turned round,
  // and a one-sided component is cut where the file's own orientation breaks, if it breaks.
  void orient() {
    const int face_count = faces_.size();
    std::vector<signed char> turned(static_cast<size_t>(face_count), -1);  // -1: not reached
    std::vector<int> agreeing, disagreeing;  // faces whose such edges are to be crossed
    std::vector<int> component;
    auto cross_edges = [&](int f, bool same_direction) {
      for (int c = faces_.offsets()[f]; c < faces_.offsets()[f + 1]; ++c) {
        const int e = edges_.edge_of_corner[c];
        if (cut_[e] || edges_.corner_count(e) != 2) continue;
        const int d = edges_.corner(e, edges_.corner(e, 0) == c ? 1 : 0);
        if ((faces_.indices()[c] == faces_.indices()[d]) != same_direction) continue;
        const int g = edges_.face_of_corner[d];
        if (turned[g] >= 0) continue;
        turned[g] = static_cast<signed char>(same_direction ? 1 - turned[f] : turned[f]);
        component.push_back(g);
        agreeing.push_back(g);
        disagreeing.push_back(g);
      }
    };
    int one_sided = 0, seam = 0;
    for (int seed = 0; seed < face_count; ++seed) {
      if (turned[seed] >= 0) continue;
      turned[seed] = 0;
      component.assign(1, seed);
      agreeing.assign(1, seed);
      disagreeing.assign(1, seed);
      size_t next_agreeing = 0, next_disagreeing = 0;
      while (true) {
        if (next_agreeing < agreeing.size())
          cross_edges(agreeing[next_agreeing++], false);
        else if (next_disagreeing < disagreeing.size())
          cross_edges(disagreeing[next_disagreeing++], true);
        else
          break;
      }

      const auto turned_count =
          std::count_if(component.begin(), component.end(), [&](int f) { return turned[f]; });
      if (2 * turned_count > static_cast<std::ptrdiff_t>(component.size()))
        for (int f : component) turned[f] = static_cast<signed char>(1 - turned[f]);
      const int component_seam = cut_contradictions(component, turned);
      seam += component_seam;
      if (component_seam > 0) ++one_sided;
    }

    for (int f = 0; f < face_count; ++f)
      if (turned[f] == 1) note(DefectKind::InconsistentOrientation, face_origin_[f]);
    if (Defect* d = find(DefectKind::InconsistentOrientation)) d->action = "turned round";
    if (one_sided > 0) {
      Defect& d = defect(DefectKind::OneSided);
      d.count = one_sided;
      d.action = "cut open along " + counted(seam, "edge", "edges");
      health_.repaired = true;
    }
    turn_round(turned);
  }

  // Cuts the edges that two faces of the component still run through in the same direction; returns their
  // number.
  int cut_contradictions(const std::vector<int>& component, const std::vector<signed char>& turned) {
    int seam = 0;
    for (int f : component)
      for (int c = faces_.offsets()[f]; c < faces_.offsets()[f + 1]; ++c) {
        const int e = edges_.edge_of_corner[c];
        if (cut_[e] || edges_.corner_count(e) != 2 || edges_.corner(e, 0) != c) continue;
        const int d = edges_.corner(e, 1);
        const bool same_direction = faces_.indices()[c] == faces_.indices()[d];
        if (same_direction != (turned[f] != turned[edges_.face_of_corner[d]])) {
          cut_[e] = 1;
          ++seam;
          list_edge(DefectKind::OneSided, e);
        }
      }
    return seam;
  }

  // Reverses the marked faces, keeping their first corner, and their part of the edge table with them.
  void turn_round(const std::vector<signed char>& turned) {
    bool any = false;
    for (int f = 0; f < faces_.size(); ++f) {
      if (turned[f] != 1) continue;
      any = true;
      const std::span<int> corners = faces_[f];
      std::reverse(corners.begin() + 1, corners.end());
    }
    if (!any) return;
    // The edges' own numbers may change with the order of the corners, so the cuts are carried over by
    // corner.
    std::vector<char> cut_corner(faces_.indices().size());
    for (int c = 0; c < static_cast<int>(cut_corner.size()); ++c)
      cut_corner[c] = cut_[edges_.edge_of_corner[c]];
    for (int f = 0; f < faces_.size(); ++f)
      if (turned[f] == 1)  // the edge after corner k of n is now the one after corner n - 1 - k
        std::reverse(cut_corner.begin() + faces_.offsets()[f], cut_corner.begin() + faces_.offsets()[f + 1]);
    edges_ = build_edge_table(faces_, health_.vertices);
    cut_.assign(static_cast<size_t>(edges_.size()), 0);
    for (int c = 0; c < static_cast<int>(cut_corner.size()); ++c)
      cut_[edges_.edge_of_corner[c]] = cut_corner[c];
  }

  // Gives each fan of faces round a vertex a vertex of its own; the first fan keeps the file's. Fans are
  // chains of consistently oriented faces that end at the border and at cuts. So an edge that was cut ends up
  // with at most two faces, in opposite directions: in a chain it can only be the first edge and the last.
  void split_vertices() {
    const int corner_count = static_cast<int>(faces_.indices().size());
    DisjointSets fans(corner_count);
    for (int e = 0; e < edges_.size(); ++e)
      if (!cut_[e] && edges_.corner_count(e) == 2)
        pair_corners(edges_.corner(e, 0), edges_.corner(e, 1), [&](int i, int j) { fans.join(i, j); });

    vertex_origin_.resize(static_cast<size_t>(positions_.rows()));
    std::iota(vertex_origin_.begin(), vertex_origin_.end(), 0);
    std::vector<char> taken(static_cast<size_t>(positions_.rows()), 0);
    std::vector<int> vertex_of_fan(static_cast<size_t>(corner_count), -1);  // by the fan's first corner
    for (int f = 0; f < faces_.size(); ++f) {
      const int first = faces_.offsets()[f];
      for (int k = 0; k < faces_.valence(f); ++k) {
        int& v = faces_[f][k];
        int& vertex = vertex_of_fan[fans.find(first + k)];
        if (vertex < 0) {
          vertex = taken[v] ? static_cast<int>(vertex_origin_.size()) : v;
          if (taken[v]) vertex_origin_.push_back(v);
          taken[v] = 1;
        }
        v = vertex;
      }
    }
    health_.repaired |= vertex_origin_.size() > static_cast<size_t>(positions_.rows());
  }

  Points split_positions() const {
    Points result(static_cast<Eigen::Index>(vertex_origin_.size()), 3);
    for (size_t v = 0; v < vertex_origin_.size(); ++v)
      result.row(static_cast<Eigen::Index>(v)) = positions_.row(vertex_origin_[v]);
    return result;
  }

  // Components, border and faces of no area, of the repaired faces.
  void measure() {
    const int vertex_count = static_cast<int>(vertex_origin_.size());
    edges_ = build_edge_table(faces_, vertex_count);

    DisjointSets components(vertex_count);
    std::vector<char> used(static_cast<size_t>(vertex_count), 0);
    for (int f = 0; f < faces_.size(); ++f)
      for (int v : faces_[f]) {
        components.join(v, faces_[f][0]);
        used[v] = 1;
      }
    for (int v = 0; v < vertex_count; ++v)
      if (used[v] && components.find(v) == v) ++health_.components;

    std::vector<int> border_next(static_cast<size_t>(vertex_count), -1);
    double length_sum = 0.0;
    for (int e = 0; e < edges_.size(); ++e) {
      const int c = edges_.corner(e, 0);
      const int a = faces_.indices()[c];
      const int b = faces_.indices()[next_corner(faces_, edges_.face_of_corner[c], c)];
      length_sum += (positions_.row(vertex_origin_[a]) - positions_.row(vertex_origin_[b])).norm();
      if (edges_.corner_count(e) != 1) continue;
      ++health_.border_edges;
      border_next[a] = b;
    }
    for (int v = 0; v < vertex_count; ++v) {
      if (border_next[v] < 0) continue;
      ++health_.border_loops;
      for (int w = v; border_next[w] >= 0;) w = std::exchange(border_next[w], -1);
    }

    const double mean_edge = length_sum / std::max(1, edges_.size());
    int flat = 0;
    std::vector<int> corners;
    for (int f = 0; f < faces_.size(); ++f) {
      corners.clear();
      for (int v : faces_[f]) corners.push_back(vertex_origin_[v]);
      if (0.5 * newell_vector(positions_, corners).norm() > kLeastArea * mean_edge * mean_edge) continue;
      ++flat;
      note(DefectKind::DegenerateFace, face_origin_[f], false);
    }
    if (flat == 0) return;
    Defect& d = defect(DefectKind::DegenerateFace);
    const int dropped = d.count - flat;
    d.action =
        dropped == 0 ? "kept" : std::to_string(dropped) + " dropped, " + std::to_string(flat) + " kept";
  }

  void find_duplicate_and_isolated_vertices() {
    PointIndex index;
    std::vector<char> used(static_cast<size_t>(positions_.rows()), 0);
    for (int v : faces_.indices()) used[vertex_origin_[v]] = 1;
    for (int v = 0; v < static_cast<int>(positions_.rows()); ++v) {
      const auto before = index.points().size();
      index.insert(positions_(v, 0), positions_(v, 1), positions_(v, 2));
      if (index.points().size() == before) note(DefectKind::DuplicateVertex, v, false);
      if (!used[v]) note(DefectKind::IsolatedVertex, v, false);
    }
    for (DefectKind kind : {DefectKind::DuplicateVertex, DefectKind::IsolatedVertex})
      if (Defect* d = find(kind)) d->action = "kept";
  }

  Defect* find(DefectKind kind) { return const_cast<Defect*>(health_.find(kind)); }

  const Points& positions_;
  const Polygons& file_faces_;
  Polygons faces_;
  std::vector<int> face_origin_, vertex_origin_;
  EdgeTable edges_;        // of faces_
  std::vector<char> cut_;  // per edge: its faces are not neighbours
  HealthReport health_;
};

}  // namespace

const char* name(DefectKind kind) {
  return kNames[static_cast<size_t>(kind)].one;
}

const Defect* HealthReport::find(DefectKind kind) const {
  for (const Defect& d : defects)
    if (d.kind == kind) return &d;
  return nullptr;
}

std::string HealthReport::summary() const {
  if (healthy()) return "healthy";
  std::string text;
  for (const Defect& d : defects) {
    const KindName& names = kNames[static_cast<size_t>(d.kind)];
    text += (text.empty() ? "" : ", ") + counted(d.count, names.one, names.many) + " (" + d.action + ")";
  }
  return text;
}

Result<CheckedMesh> check_and_repair(const Points& positions, const Polygons& faces) {
  return Repair(positions, faces).run();
}

}  // namespace planewright
