#include "ui/prepared_workshop.h"

#include "core/complex/state.h"

namespace planewright::ui {
namespace {

bool same_model(const WorkshopJob& a, const WorkshopJob& b) {
  return a.iterate == b.iterate && a.numbers == b.numbers && a.given_names == b.given_names &&
         a.title == b.title && a.contract.unit == b.contract.unit && a.contract.names == b.contract.names;
}

bool measures_distance(const WorkshopJob& job) {
  return job.thorough || job.contract.tolerances.distance.has_value();
}

bool same_passports(const WorkshopJob& a, const WorkshopJob& b) {
  return a.mesh == b.mesh && a.reference == b.reference && measures_distance(a) == measures_distance(b) &&
         a.contract.thickness == b.contract.thickness && a.contract.density == b.contract.density;
}

Result<std::shared_ptr<const WorkshopModel>> make_model(const WorkshopJob& job) {
  const Panels panels = panels_of(*job.iterate->complex, job.iterate->state);
  WorkshopOptions options;
  options.title = job.title;
  options.unit = job.contract.unit;
  options.names = job.contract.names;
  options.numbers = job.numbers;
  options.kept_names = job.given_names;
  return make_workshop_model(panels.points, panels.polygons, options);
}

Result<std::shared_ptr<const ReferenceSurface>> surface_of(const WorkshopJob& job,
                                                           const PreparedWorkshop* before) {
  if (!measures_distance(job)) return nullptr;
  if (job.reference) return job.reference;
  if (!job.mesh) return nullptr;
  if (before != nullptr && before->surface && !before->job.reference && before->job.mesh == job.mesh)
    return before->surface;
  return ReferenceSurface::create(job.mesh->positions(), job.mesh->faces(), job.title);
}

// Mitred edges make no difference to a sheet without thickness.
CongruenceOptions congruence_of(const WorkshopContract& contract) {
  CongruenceOptions options;
  options.bevels = contract.thickness > 0.0;
  return options;
}

}  // namespace

Result<PreparedWorkshop> prepare_workshop(const WorkshopJob& job, const PreparedWorkshop* before) {
  PreparedWorkshop made;
  made.job = job;
  const bool keep_model = before != nullptr && same_model(before->job, job);
  const bool keep_passports = keep_model && same_passports(before->job, job);
  if (keep_model) {
    made.model = before->model;
  } else {
    auto model = make_model(job);
    if (!model) return tl::unexpected(model.error());
    made.model = std::move(*model);
  }
  if (keep_passports) {
    made.surface = before->surface;
    made.passports = before->passports;
  } else {
    auto surface = surface_of(job, before);
    if (!surface) return tl::unexpected(surface.error());
    made.surface = std::move(*surface);
    PassportOptions options;
    options.thickness = job.contract.thickness;
    options.density = job.contract.density;
    options.reference = made.surface.get();
    made.passports = make_passports(*made.model, options);
  }
  if (keep_passports && !before->classes.empty()) {
    made.classes = before->classes;
    made.class_of_panel = before->class_of_panel;
  } else if (job.thorough) {
    made.classes = congruence_classes(*made.model, made.passports, congruence_of(job.contract));
    made.class_of_panel.assign(made.passports.size(), -1);
    for (std::size_t c = 0; c < made.classes.size(); ++c)
      for (const CongruenceMember& member : made.classes[c].members)
        made.class_of_panel[static_cast<std::size_t>(member.panel)] = static_cast<int>(c);
  }
  made.verdicts = check_tolerances(*made.model, made.passports, job.contract.tolerances);
  return made;
}

}  // namespace planewright::ui
