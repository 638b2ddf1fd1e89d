// What writers of 3D files have in common: a model as parts, each with a name. Internal to writers/.
// Threads: pure.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/pattern/thick_panel.h"
#include "core/workshop/workshop_model.h"

namespace planewright {

struct SolidPart {
  int panel;
  std::string name;  // clean text
  Points points;     // mm, relative to the model's origin
  Polygons faces;    // into points
};

// One part per panel, with its own corners only.
std::vector<SolidPart> panel_parts(const WorkshopModel& model);
// One part per thick panel that is not empty.
std::vector<SolidPart> solid_parts(const WorkshopModel& model, const ThickPanels& solids);

// Refused, naming the panel: a coordinate that is not finite, a face of fewer than three corners or of ones
// that do not exist; a name or number of a panel that the model does not have.
Result<void> check_solid_sources(const WorkshopModel& model);
Result<void> check_solid_sources(const WorkshopModel& model, const ThickPanels& solids);

// Faces cut into triangles over the corners that are there already, so that what is closed stays closed.
std::vector<std::array<int, 3>> triangles_of(const Points& points, const Polygons& faces);

// About the middle of the part, absolute, mm: what files of single precision lay a part's numbers round, so
// that few digits are lost. On a grid of 125 mm (an eighth of a metre), coarser from 1 km on, so that single
// precision holds it in either unit, and lib3mf, which writes six digits of it, too.
Vector3d part_place(const Points& points, const Vector3d& origin);

// Formats, each for both: `surface` says that the parts are panels of one surface with shared corners.
struct SolidScene {
  const WorkshopModel* model;
  std::vector<SolidPart> parts;
  bool surface = false;
};
std::string format_obj(const SolidScene& scene);
std::string format_ply(const SolidScene& scene);
std::string format_stl(const SolidScene& scene);
Result<std::string> format_3mf(const SolidScene& scene);   // no surfaces
Result<std::string> format_gltf(const SolidScene& scene);  // binary

}  // namespace planewright
