#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/certify/check_text.h"
#include "core/certify/mesh_checks.h"
#include "core/certify/solid_shape.h"

namespace planewright {
namespace {

Points corners_of(const WorkshopModel& model, int panel) {
  Points picked(model.panels.valence(panel), 3);
  for (int k = 0; k < model.panels.valence(panel); ++k)
    picked.row(k) = model.points.row(model.panels[panel][static_cast<size_t>(k)]);
  return picked;
}

// The farthest corner of two polygons, whichever corner the file begins with.
double cyclic_distance(const Points& points, std::span<const int> face, const Points& wanted) {
  const auto n = static_cast<Eigen::Index>(face.size());
  double best = std::numeric_limits<double>::infinity();
  if (n != wanted.rows()) return best;
  for (Eigen::Index shift = 0; shift < n; ++shift) {
    double worst = 0.0;
    for (Eigen::Index k = 0; k < n && worst < best; ++k)
      worst =
          std::max(worst, (points.row(face[static_cast<size_t>((k + shift) % n)]) - wanted.row(k)).norm());
    best = std::min(best, worst);
  }
  return best;
}

Vector3d vector_area(const Points& points, const Polygons& faces, const std::vector<int>& chosen) {
  Vector3d sum = Vector3d::Zero();
  for (const int f : chosen) sum += 0.5 * newell_vector(points, faces[f]);
  return sum;
}

// Edges that faces share by their indices, each way once.
int shared_edges(const Polygons& faces) {
  std::vector<std::pair<int, int>> edges;
  for (int f = 0; f < faces.size(); ++f)
    for (int k = 0; k < faces.valence(f); ++k)
      edges.emplace_back(faces[f][static_cast<size_t>(k)],
                         faces[f][static_cast<size_t>((k + 1) % faces.valence(f))]);
  std::sort(edges.begin(), edges.end());
  int shared = 0;
  for (const auto& [a, b] : edges)
    if (a < b && std::binary_search(edges.begin(), edges.end(), std::pair(b, a))) ++shared;
  return shared;
}

double deviation_from_plane(const Points& points, std::span<const int> face, const Vector3d& normal,
                            double offset) {
  double worst = 0.0;
  for (const int c : face) worst = std::max(worst, std::abs(points.row(c).dot(normal.transpose()) - offset));
  return worst;
}

// STL: triangles of all panels, of none in particular.
void loose_checks(const ReadMesh& mesh, const Points& points, double limit, const ExportContent& content,
                  std::vector<Check>& checks) {
  const WorkshopModel& model = *content.model;
  long long triangles = 0;
  double area = 0.0, perimeter = 0.0, found = 0.0;
  for (int p = 0; p < model.panel_count(); ++p) {
    triangles += model.panels.valence(p) - 2;
    area += 0.5 * newell_vector(model.points, model.panels[p]).norm();
    perimeter += (*content.passports)[static_cast<size_t>(p)].perimeter;
  }
  for (int f = 0; f < mesh.faces.size(); ++f) found += 0.5 * newell_vector(points, mesh.faces[f]).norm();
  checks.push_back({"number of panels", mesh.faces.size() == triangles,
                    counted(mesh.faces.size()) + " triangles, the panels have " + counted(triangles) +
                        "; STL knows no parts and no names"});
  Points used = points_of(model.points, model.panels, all_of(model.panels));
  const double far = set_distance(points, used);
  checks.push_back({"corners", far <= limit, against_limit(far, limit, "mm") + ", single precision"});
  // Triangles of a panel that is not planar have a little more area than the panel.
  double bent = 0.0;
  for (const PanelPassport& p : *content.passports) bent += p.planarity * p.perimeter;
  const double area_limit = limit * perimeter + bent + 1e-9 * area;
  checks.push_back({"area", std::abs(found - area) <= area_limit,
                    against_limit(std::abs(found - area), area_limit, "mm²")});
}

}  // namespace

std::vector<Check> check_panel_mesh(const ReadMesh& mesh, MeshFileFormat format,
                                    const ExportContent& content) {
  const WorkshopModel& model = *content.model;
  const Points points = in_model_frame(mesh, format, model);
  const double limit = coordinate_limit(mesh, format);
  const Points used = points_of(model.points, model.panels, all_of(model.panels));
  std::vector<Check> checks{scale_check(mesh, format, points, used)};
  if (format == MeshFileFormat::Stl) {
    loose_checks(mesh, points, limit, content, checks);
    return checks;
  }
  std::vector<int> every(static_cast<size_t>(model.panel_count()));
  std::iota(every.begin(), every.end(), 0);
  MeshObjects objects = objects_by_name(mesh, every, model);
  checks.push_back(objects.check);

  const bool polygons = format == MeshFileFormat::Obj || format == MeshFileFormat::Ply;
  double far = 0.0, planarity = 0.0, planarity_off = 0.0, area_off = 0.0;
  std::vector<std::string> wrong, turned, cut;
  for (const int p : every) {
    const std::vector<int>& faces = objects.faces_of_panel[static_cast<size_t>(p)];
    if (faces.empty()) continue;  // its name is missing, which is told
    const std::string& name = model.names[static_cast<size_t>(p)];
    const PanelPassport& passport = (*content.passports)[static_cast<size_t>(p)];
    const Points wanted = corners_of(model, p);
    if (static_cast<int>(faces.size()) != (polygons ? 1 : model.panels.valence(p) - 2)) cut.push_back(name);
    const Vector3d wanted_area = 0.5 * newell_vector(model.points, model.panels[p]);
    const Vector3d area = vector_area(points, mesh.faces, faces);
    // The other way round is told as that, not as corners in the wrong order as well.
    const bool backwards = area.dot(wanted_area) < 0.0;
    const double off = polygons && faces.size() == 1 && !backwards
                           ? cyclic_distance(points, mesh.faces[faces[0]], wanted)
                           : set_distance(points_of(points, mesh.faces, faces), wanted);
    far = std::max(far, off);
    if (off > limit) wrong.push_back(name);
    const double loss =
        (area - wanted_area).norm() / (limit * std::max(passport.perimeter, 1.0) + 1e-9 * passport.area);
    if (backwards)
      turned.push_back(name);
    else
      area_off = std::max(area_off, loss);
    if (polygons) {
      const double measured =
          deviation_from_plane(points, mesh.faces[faces[0]], model.normals.row(p), model.plane_offsets[p]);
      planarity = std::max(planarity, measured);
      planarity_off = std::max(planarity_off, std::abs(measured - passport.planarity));
    }
  }
  checks.push_back({"number of panels", cut.empty(),
                    counted(mesh.faces.size()) + (polygons ? " polygons" : " triangles") +
                        (cut.empty() ? "" : "; wrong: " + listed(cut))});
  checks.push_back({"corners", wrong.empty(),
                    against_limit(far, limit, "mm") + (mesh.single_precision ? ", single precision" : "") +
                        (wrong.empty() ? "" : "; wrong: " + listed(wrong))});
  checks.push_back({"outside", turned.empty() && area_off <= 1.0,
                    turned.empty() ? "areas and normals as in the model" : "turned over: " + listed(turned)});
  if (!polygons) return checks;
  if (!mesh.single_precision)
    checks.push_back({"planarity", planarity_off <= limit,
                      "largest " + brief(planarity) +
                          " mm, passports agree: " + against_limit(planarity_off, limit, "mm")});
  const int shared = shared_edges(mesh.faces), wanted_shared = shared_edges(model.panels);
  checks.push_back({"shared edges", shared == wanted_shared,
                    counted(shared) + " of " + counted(wanted_shared) + " by the same corners"});
  return checks;
}

}  // namespace planewright
