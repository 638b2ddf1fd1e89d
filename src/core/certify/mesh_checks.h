// What files of panels and of thick panels have to hold. Internal to certify/. Threads: pure.
#pragma once

#include <vector>

#include "core/certify/certificate.h"
#include "core/certify/mesh_frame.h"

namespace planewright {

std::vector<Check> check_panel_mesh(const ReadMesh& mesh, MeshFileFormat format,
                                    const ExportContent& content);
// content.solids is there.
std::vector<Check> check_solid_mesh(const ReadMesh& mesh, MeshFileFormat format,
                                    const ExportContent& content);

}  // namespace planewright
