#include "core/edit/project.h"

#include <utility>

namespace planewright {

Project new_project(std::string name, PolygonMesh mesh, Design design) {
  Project project;
  project.name = std::move(name);
  project.names = names_of_opened(mesh);
  project.mesh = std::move(mesh);
  project.design = std::move(design);
  return project;
}

}  // namespace planewright
