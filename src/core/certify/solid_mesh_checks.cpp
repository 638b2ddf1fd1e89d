#include <algorithm>
#include <cmath>

#include "core/certify/check_text.h"
#include "core/certify/exact_signs.h"
#include "core/certify/mesh_checks.h"
#include "core/certify/solid_shape.h"

namespace planewright {
namespace {

struct Wanted {
  std::vector<int> panels;  // that have a solid
  std::vector<SolidMeasure> measures;
  double surface = 0.0, volume = 0.0;
  long long triangles = 0;
  Points points;
};
Wanted wanted_of(const ThickPanels& solids) {
  Wanted wanted;
  Eigen::Index rows = 0;
  for (const ThickPanel& s : solids.panels) rows += s.empty() ? 0 : s.points.rows();
  wanted.points.resize(rows, 3);
  rows = 0;
  for (size_t p = 0; p < solids.panels.size(); ++p) {
    const ThickPanel& s = solids.panels[p];
    if (s.empty()) continue;
    const auto triangles = fans(s.faces, all_of(s.faces));
    wanted.panels.push_back(static_cast<int>(p));
    wanted.measures.push_back(measure(s.points, triangles));
    wanted.surface += wanted.measures.back().surface;
    wanted.volume += wanted.measures.back().volume;
    wanted.triangles += static_cast<long long>(triangles.size());
    wanted.points.middleRows(rows, s.points.rows()) = s.points;
    rows += s.points.rows();
  }
  return wanted;
}

// A volume moves by no more than its surface times what its corners and its faces' bends move.
double volume_limit(const SolidMeasure& wanted, double limit, double planarity) {
  return wanted.surface * (limit + planarity) + 1e-9 * std::abs(wanted.volume);
}

void loose_checks(const ReadMesh& mesh, const Points& points, double limit, const Wanted& wanted,
                  const ExportContent& content, std::vector<Check>& checks) {
  const std::vector<int> all = all_of(mesh.faces);
  checks.push_back({"number of solids", mesh.faces.size() == wanted.triangles,
                    counted(mesh.faces.size()) + " triangles, the solids have " + counted(wanted.triangles) +
                        "; STL knows no parts and no names"});
  checks.push_back({"closed", is_balanced(mesh.faces, all, welded(mesh.points)),
                    "every edge as often one way as the other, over all solids"});
  const auto triangles = fans(mesh.faces, all);
  checks.push_back(
      {"positive volume", volume_sign(mesh.points, triangles) > 0, "of all together, exact sign"});
  double bent = 0.0;
  for (const PanelPassport& p : *content.passports) bent = std::max(bent, p.planarity);
  const double difference = std::abs(measure(points, triangles).volume - wanted.volume);
  const double allowed = volume_limit({wanted.volume, wanted.surface}, limit, bent);
  checks.push_back(
      {"volume", difference <= allowed, "of all together, " + against_limit(difference, allowed, "mm³")});
  const double far = set_distance(points, wanted.points);
  checks.push_back({"corners", far <= limit, against_limit(far, limit, "mm") + ", single precision"});
}

}  // namespace

std::vector<Check> check_solid_mesh(const ReadMesh& mesh, MeshFileFormat format,
                                    const ExportContent& content) {
  const WorkshopModel& model = *content.model;
  const Wanted wanted = wanted_of(*content.solids);
  const Points points = in_model_frame(mesh, format, model);
  const double limit = coordinate_limit(mesh, format);
  std::vector<Check> checks{scale_check(mesh, format, points, wanted.points)};
  if (format == MeshFileFormat::Stl) {
    loose_checks(mesh, points, limit, wanted, content, checks);
    return checks;
  }
  const MeshObjects objects = objects_by_name(mesh, wanted.panels, model);
  checks.push_back(objects.check);
  const std::vector<int> weld = welded(mesh.points);
  std::vector<std::string> open, inside_out, other, moved;
  double far = 0.0, worst = 0.0;
  for (size_t i = 0; i < wanted.panels.size(); ++i) {
    const int p = wanted.panels[i];
    const std::vector<int>& faces = objects.faces_of_panel[static_cast<size_t>(p)];
    if (faces.empty()) continue;
    const std::string& name = model.names[static_cast<size_t>(p)];
    const auto triangles = fans(mesh.faces, faces);
    if (!is_closed(mesh.faces, faces, weld)) open.push_back(name);
    if (volume_sign(mesh.points, triangles) <= 0) inside_out.push_back(name);
    const double planarity = (*content.passports)[static_cast<size_t>(p)].planarity;
    const double allowed = volume_limit(wanted.measures[i], limit, planarity);
    const double difference = std::abs(measure(points, triangles).volume - wanted.measures[i].volume);
    worst = std::max(worst, difference / allowed);
    if (difference > allowed) other.push_back(name);
    const double off = set_distance(points_of(points, mesh.faces, faces),
                                    content.solids->panels[static_cast<size_t>(p)].points);
    far = std::max(far, off);
    if (off > limit) moved.push_back(name);
  }
  const std::string each = counted(static_cast<long long>(wanted.panels.size())) + " solids";
  checks.push_back(
      {"closed", open.empty(), open.empty() ? each + ", every edge once each way" : "open: " + listed(open)});
  checks.push_back({"positive volume", inside_out.empty(),
                    inside_out.empty() ? each + ", exact sign" : "inside out: " + listed(inside_out)});
  checks.push_back({"volume", other.empty(),
                    other.empty() ? each + ", at most " + brief(worst) + " of what the format's digits allow"
                                  : "different: " + listed(other)});
  checks.push_back({"corners", moved.empty(),
                    against_limit(far, limit, "mm") + (mesh.single_precision ? ", single precision" : "") +
                        (moved.empty() ? "" : "; wrong: " + listed(moved))});
  return checks;
}

}  // namespace planewright
