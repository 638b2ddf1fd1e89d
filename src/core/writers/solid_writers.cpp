#include "core/writers/solid_writers.h"

#include "core/writers/solid_parts.h"

namespace planewright {
namespace {

Result<std::string> format(const SolidScene& scene, SolidFormat format) {
  switch (format) {
    case SolidFormat::Obj:
      return format_obj(scene);
    case SolidFormat::Ply:
      return format_ply(scene);
    case SolidFormat::Stl:
      return format_stl(scene);
    case SolidFormat::ThreeMf:
      return format_3mf(scene);
    case SolidFormat::Gltf:
      break;
  }
  return format_gltf(scene);
}

}  // namespace

Result<std::string> format_panels(const WorkshopModel& model, SolidFormat format_wanted) {
  if (format_wanted == SolidFormat::ThreeMf)
    return fail(ErrorCode::Usage, "3MF holds solids only, and panels without thickness are none", "3mf",
                "Give the panels a thickness");
  if (auto checked = check_solid_sources(model); !checked) return tl::unexpected(checked.error());
  return format({&model, panel_parts(model), true}, format_wanted);
}

Result<std::string> format_solids(const WorkshopModel& model, const ThickPanels& solids,
                                  SolidFormat format_wanted) {
  if (auto checked = check_solid_sources(model, solids); !checked) return tl::unexpected(checked.error());
  return format({&model, solid_parts(model, solids), false}, format_wanted);
}

}  // namespace planewright
