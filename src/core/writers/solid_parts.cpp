#include "core/writers/solid_parts.h"

#include <cmath>

#include "core/mesh/triangulate.h"
#include "core/writers/clean_text.h"

namespace planewright {
namespace {

Result<void> check_faces(const Points& points, const Polygons& faces, const std::string& where) {
  for (int f = 0; f < faces.size(); ++f) {
    if (faces.valence(f) < 3)
      return fail(ErrorCode::Refused, "a face has fewer than 3 corners", where, "Leave the panel out");
    for (const int corner : faces[f]) {
      if (corner < 0 || corner >= points.rows())
        return fail(ErrorCode::Refused,
                    "a face names corner " + std::to_string(corner) + ", which is not there", where,
                    "Leave the panel out");
      if (!points.row(corner).allFinite())
        return fail(ErrorCode::Refused, "a coordinate is not a finite number", where,
                    "A file could not hold it");
    }
  }
  return {};
}

}  // namespace

std::vector<SolidPart> panel_parts(const WorkshopModel& model) {
  std::vector<SolidPart> parts;
  parts.reserve(static_cast<size_t>(model.panel_count()));
  for (int p = 0; p < model.panel_count(); ++p) {
    const auto panel = model.panels[p];
    SolidPart part{p, clean_text(model.names[p]), Points(static_cast<Eigen::Index>(panel.size()), 3), {}};
    std::vector<int> face(panel.size());
    for (size_t k = 0; k < panel.size(); ++k) {
      part.points.row(static_cast<Eigen::Index>(k)) = model.points.row(panel[k]);
      face[k] = static_cast<int>(k);
    }
    part.faces.push_back(face);
    parts.push_back(std::move(part));
  }
  return parts;
}

std::vector<SolidPart> solid_parts(const WorkshopModel& model, const ThickPanels& solids) {
  std::vector<SolidPart> parts;
  parts.reserve(solids.panels.size());
  for (const ThickPanel& solid : solids.panels)
    if (!solid.empty())
      parts.push_back({solid.panel, clean_text(model.names[solid.panel]), solid.points, solid.faces});
  return parts;
}

Result<void> check_solid_sources(const WorkshopModel& model) {
  if (static_cast<int>(model.names.size()) != model.panel_count())
    return fail(ErrorCode::Refused, "there are " + std::to_string(model.names.size()) + " names for " +
                                        std::to_string(model.panel_count()) + " panels");
  if (!model.origin.allFinite())
    return fail(ErrorCode::Refused, "the origin is not finite", model.title, "A file could not hold it");
  for (int p = 0; p < model.panel_count(); ++p) {
    Polygons face;
    face.push_back(model.panels[p]);
    if (auto checked = check_faces(model.points, face, "panel " + model.names[p]); !checked) return checked;
  }
  return {};
}

Result<void> check_solid_sources(const WorkshopModel& model, const ThickPanels& solids) {
  if (static_cast<int>(model.names.size()) != model.panel_count() || !model.origin.allFinite())
    return check_solid_sources(model);
  for (const ThickPanel& solid : solids.panels) {
    if (solid.empty()) continue;
    if (solid.panel < 0 || solid.panel >= model.panel_count())
      return fail(ErrorCode::Refused,
                  "a solid belongs to panel " + std::to_string(solid.panel) + ", which is not there");
    const std::string where = "solid of panel " + model.names[solid.panel];
    if (auto checked = check_faces(solid.points, solid.faces, where); !checked) return checked;
  }
  return {};
}

std::vector<std::array<int, 3>> triangles_of(const Points& points, const Polygons& faces) {
  std::vector<std::array<int, 3>> triangles;
  for (int f = 0; f < faces.size(); ++f) {
    const auto cut = triangulate(points, faces[f]);
    triangles.insert(triangles.end(), cut.begin(), cut.end());
  }
  return triangles;
}

Vector3d part_place(const Points& points, const Vector3d& origin) {
  Vector3d place = (points.colwise().minCoeff() + points.colwise().maxCoeff()).transpose() / 2.0 + origin;
  for (double& value : place) {
    const double grid = std::abs(value) < 0.9e6 ? 125.0 : std::abs(value) < 0.9e7 ? 250.0 : 1000.0;
    value = std::round(value / grid) * grid;
  }
  return place;
}

}  // namespace planewright
