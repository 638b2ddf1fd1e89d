#include <algorithm>

#include "core/problem/demands/demand_context.h"

namespace planewright {
namespace {

bool contains(const std::vector<int>& ascending, int value) {
  return std::binary_search(ascending.begin(), ascending.end(), value);
}

bool point_named(const TangentComplex& complex, const Selection& selection, int point) {
  const PointOrigin& origin = complex.point_origin[static_cast<size_t>(point)];
  switch (origin.kind) {
    case PointKind::Face:
      return contains(selection.faces, origin.element);
    case PointKind::BorderEdge:
      return contains(selection.edges, origin.element);
    case PointKind::Corner:
      return false;  // a vertex means its panel, and with it this corner
    case PointKind::Vertex:
      return contains(selection.vertices, origin.element);
  }
  return false;
}

// Planarize, cluster: the vertices at the ends of the named edges, ascending.
std::vector<int> ends_of_edges(const TangentComplex& complex, const std::vector<int>& edges) {
  std::vector<int> vertices;
  for (int e : edges)
    if (e >= 0 && e < static_cast<int>(complex.input.edges.size()))
      for (int v : complex.input.edges[static_cast<size_t>(e)]) vertices.push_back(v);
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

// Cluster: the regions all of whose faces are named, ascending. None for other kinds.
std::vector<int> regions_of_faces(const TangentComplex& complex, const std::vector<int>& faces) {
  std::vector<int> regions, missing(static_cast<size_t>(complex.plane_count()), 0);
  if (complex.kind != ComplexKind::Cluster || faces.empty()) return regions;
  for (size_t f = 0; f < complex.region_of_face.size(); ++f)
    if (!contains(faces, static_cast<int>(f))) ++missing[static_cast<size_t>(complex.region_of_face[f])];
  for (int r = 0; r < complex.plane_count(); ++r)
    if (missing[static_cast<size_t>(r)] == 0) regions.push_back(r);
  return regions;
}

}  // namespace

SelectedElements selected_elements(const TangentComplex& complex, const Selection* selection) {
  const auto points = static_cast<size_t>(complex.point_count()),
             panels = static_cast<size_t>(complex.plane_count());
  if (!selection) return {std::vector<char>(points, 1), std::vector<char>(panels, 1)};
  SelectedElements out{std::vector<char>(points, 0), std::vector<char>(panels, 0)};
  for (size_t j = 0; j < points; ++j) out.points[j] = point_named(complex, *selection, static_cast<int>(j));
  if (complex.kind != ComplexKind::Dual) {
    const std::vector<int> ends = ends_of_edges(complex, selection->edges);
    for (size_t j = 0; j < points; ++j)
      if (contains(ends, complex.point_origin[j].element)) out.points[j] = 1;
  }
  const std::vector<int> regions = regions_of_faces(complex, selection->faces);
  const auto& named_panels = complex.kind == ComplexKind::Dual        ? selection->vertices
                             : complex.kind == ComplexKind::Planarize ? selection->faces
                                                                      : regions;
  for (size_t i = 0; i < panels; ++i) {
    const auto corners = complex.panels[static_cast<int>(i)];
    out.panels[i] = contains(named_panels, complex.plane_origin[i]) ||
                    (!corners.empty() && std::all_of(corners.begin(), corners.end(), [&](int j) {
                      return out.points[static_cast<size_t>(j)] != 0;
                    }));
  }
  for (size_t i = 0; i < panels; ++i)
    if (out.panels[i])
      for (int j : complex.panels[static_cast<int>(i)]) out.points[static_cast<size_t>(j)] = 1;
  return out;
}

}  // namespace planewright
