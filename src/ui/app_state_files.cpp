// AppState's files: opening meshes, samples and projects, and saving panels as a mesh. Projects:
// app_state_project.cpp.
#include "core/design/design.h"
#include "core/edit/project_file.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/sample_shapes.h"
#include "core/problem/energies/energy_catalogue.h"
#include "ui/app_state.h"

namespace planewright::ui {
namespace {

LayerSettings default_settings(const PolygonMesh& mesh) {
  LayerSettings settings;
  settings.mode = suggested_mode(mesh);
  settings.weights.clear();
  for (const EnergyInfo& energy : energy_catalogue()) settings.weights[energy.name] = energy.default_weight;
  return settings;
}

}  // namespace

void AppState::open_file(const std::filesystem::path& path) {
  begin_load(path.filename().string(), [path]() -> Result<Loaded> {
    if (is_project_file(path)) return load_project_file(path);
    return load_mesh(path).map([&](CheckedMesh&& mesh) {
      Loaded loaded;
      loaded.mesh = std::move(mesh);
      loaded.name = path.filename().string();
      return loaded;
    });
  });
}

void AppState::open_sample(std::string sample, int panels) {
  begin_load(sample, [sample, panels]() -> Result<Loaded> {
    return make_sample(sample, panels).and_then([&](PolygonMesh&& mesh) -> Result<Loaded> {
      // Through the same check as a file, so that the report tells of borders and components too.
      return check_and_repair(mesh.positions(), mesh.faces()).map([&](CheckedMesh&& checked) {
        Loaded loaded;
        loaded.mesh = std::move(checked);
        loaded.name = sample;
        return loaded;
      });
    });
  });
}

void AppState::begin_load(std::string name, std::function<Result<Loaded>()> load) {
  if (loader_.running()) {
    load_next_ = [this, name = std::move(name), load = std::move(load)] { begin_load(name, load); };
    return;
  }
  loading_name_ = std::move(name);
  loading_state_ = document_state();
  loader_.start(std::move(load), wake_);
}

void AppState::adopt(Loaded loaded) {
  // Whoever asked for it may have gone on working meanwhile, and nobody has asked about that.
  if (modified() && loading_state_ != document_state()) {
    post(Message::Kind::Warning, loaded.name + " was not opened, because the design was changed meanwhile",
         {}, "Open it again.");
    return;
  }
  if (loaded.project) {
    adopt_project(std::move(loaded));
  } else {
    adopt_mesh(std::move(loaded));
  }
  saved_state_ = document_state();
  const HealthReport& health = document_.health();
  if (!health.healthy()) {
    post(Message::Kind::Warning, "the mesh has defects: " + health.summary(), document_.name(),
         "See Report on the right for every place.");
  }
}

void AppState::adopt_mesh(Loaded loaded) {
  LayerSettings settings = default_settings(loaded.mesh->mesh);
  // The designer's weights and policies outlive the model, and so does what the workshop asks for; mode and
  // offset belong to it.
  WorkshopContract contract = document_.contract();
  if (document_.empty()) {
    contract.unit = default_unit;
  } else {
    settings.weights = document_.settings().weights;
    settings.border = document_.settings().border;
    settings.freedom = document_.settings().freedom;
  }
  document_.open(std::move(*loaded.mesh), std::move(loaded.name), std::move(settings), std::move(contract));
  project_path_.clear();
  begin_design();
  start_afresh_ = true;
  background_wanted_ = true;
  refresh_stale();
  solve_wanted_ = true;
}

// Nothing of the design before stays, and nothing is known of the new one.
void AppState::begin_design() {
  ++opened_count_;
  runs_.clear();
  match_runs();
  end_advice();
  known_advice_.clear();
  drop_cluster_wishes();
  region_view_.reset();
  measured_.reset();
  workshop_watch_.forget();
  current_failure_.reset();
  next_failure_ = 0;
  if (changes_regions(tool)) tool = Tool::Look;
  ghost_.reset();
  reference_.reset();
  reference_path_.clear();
  reference_error_.reset();
  clear_selection();
  walked_.reset();
  next_row_ = 0;
  selection_ids_ = document_.ids();
  planarity_range_ = displacement_range_ = 0.0;
  iterates_before_end_ = 0;
  last_fingerprint_ = 0;
  merging_ = false;
  solve_is_step_ = false;
  start_afresh_ = false;
  solve_wanted_ = false;
  solving_run_ = 0;  // what the session still delivers is nobody's
  outcome_due_ = false;
  background_wanted_ = false;
  session_.stop();

  const Points& positions = document_.mesh()->positions();
  scene_origin_ = 0.5 * (positions.colwise().minCoeff() + positions.colwise().maxCoeff()).transpose();
  refresh_mesh_view();
}

bool AppState::can_export() const {
  return shown() != nullptr && !exporter_.running();
}

void AppState::export_panels(const std::filesystem::path& path) {
  if (!shown()) {
    post(Message::Kind::Warning, "there are no panels to export yet", {}, "Solve first.");
    return;
  }
  if (exporter_.running()) {
    post(Message::Kind::Warning, "another export is still being written", {}, "Try again when it is done.");
    return;
  }
  exporter_.start(
      [iterate = shown()->iterate, path]() -> Result<std::string> {
        const Panels panels = panels_of(*iterate->complex, iterate->state);
        return save_mesh(path, panels.points, panels.polygons).map([&] { return path.string(); });
      },
      wake_);
}

}  // namespace planewright::ui
