// AppState's projects: opening one with the panels that it holds, and saving what there is.
#include <algorithm>

#include "core/design/design.h"
#include "core/design/reference_file.h"
#include "core/edit/project_file.h"
#include "core/mesh/closest_point.h"
#include "ui/app_state.h"

namespace planewright::ui {
namespace {

Result<std::shared_ptr<const TangentComplex>> complex_of(const PolygonMesh& mesh,
                                                         const LayerSettings& settings,
                                                         const SharedClusters& clusters) {
  return build_complex(mesh, settings, clusters ? &clusters->regions : nullptr);
}

// A state is one of the panels that mesh and settings mean now, point for point and plane for plane.
bool fits(const TangentComplex& panels, const Iterate& iterate) {
  return iterate.complex->kind == panels.kind && iterate.complex->plane_origin == panels.plane_origin &&
         iterate.complex->point_count() == panels.point_count();
}

}  // namespace

Result<AppState::Loaded> AppState::load_project_file(const std::filesystem::path& path) {
  auto read = planewright::load_project(path);
  if (!read) return tl::unexpected(read.error());
  Loaded loaded;
  loaded.name = path.filename().string();
  loaded.project = std::make_shared<ReadProject>(std::move(*read));
  loaded.path = path;
  const Project& project = loaded.project->project;
  if (!project.design.reference.empty())
    loaded.reference = load_reference(project.design.reference, project.mesh);
  return loaded;
}

// The solved panels are shown as they were saved; only layers without are solved.
void AppState::adopt_project(Loaded loaded) {
  Project project = std::move(loaded.project->project);
  std::vector<std::optional<State>> solved = std::move(project.solved);
  const std::string name = project.name.empty() ? loaded.name : project.name;
  project.name = name;
  document_.open_project(std::move(project));
  project_path_ = loaded.path;
  begin_design();
  if (loaded.reference) set_reference(document_.design().reference, std::move(*loaded.reference));

  const std::vector<Layer>& layers = document_.design().layers;
  bool all_there = true;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const bool there =
        i < solved.size() && solved[i] && show_saved(runs_[i], layers[i], std::move(*solved[i]));
    all_there = all_there && there;
  }
  for (int i = 0; i < layer_count(); ++i) {
    LayerRun& of = runs_[static_cast<std::size_t>(i)];
    if (!of.newest) continue;
    of.started = inputs_of(i);
    submit(of);
  }
  refresh_stale();
  solve_wanted_ = active_run().stale;
  background_wanted_ = !all_there;
  if (std::any_of(runs_.begin(), runs_.end(), [](const LayerRun& of) { return of.newest != nullptr; }))
    remember_results();
  for (const std::string& warning : loaded.project->warnings)
    post(Message::Kind::Warning, warning, loaded.path.filename().string());
}

bool AppState::show_saved(LayerRun& of, const Layer& layer, State state) {
  const auto built = complex_of(*document_.mesh(), layer.settings, document_.clusters());
  if (!built) return false;  // the solve will say why
  auto iterate = std::make_shared<Iterate>();
  iterate->complex = *built;
  iterate->state = std::move(state);
  of.ids = of.newest_ids = of.finished_ids = document_.ids();
  of.newest = of.finished = std::move(iterate);
  of.newest_final = true;
  of.saved = true;
  of.made_with = SolverKind::Tangent;
  return true;
}

void AppState::save_project(const std::filesystem::path& path) {
  if (document_.empty() || saver_.running()) return;
  Project project = document_.to_project();
  std::vector<std::shared_ptr<const Iterate>> shown;
  for (int i = 0; i < layer_count(); ++i) {
    const LayerRun& of = run(i);
    // What is being solved, or has to be, is solved when it is opened again; a polish only confirms.
    const bool due = outcome_due_ && solving_run_ == of.id && of.asked != SolverKind::Auto;
    shown.push_back(of.failed || of.stale || due ? nullptr : finished(i, document_.ids()));
  }
  saving_state_ = document_state();
  saving_design_ = opened_count_;
  saver_.start(
      [path, project = std::move(project), shown = std::move(shown),
       clusters = document_.clusters()]() mutable -> Result<std::filesystem::path> {
        project.solved.assign(shown.size(), std::nullopt);
        for (std::size_t i = 0; i < shown.size(); ++i) {
          if (!shown[i]) continue;
          const auto panels = complex_of(project.mesh, project.design.layers[i].settings, clusters);
          if (panels && fits(**panels, *shown[i])) project.solved[i] = shown[i]->state;
        }
        return planewright::save_project(path, project).map([&] { return path; });
      },
      wake_);
}

bool AppState::update_saving() {
  auto saved = saver_.take();
  if (!saved) return false;
  if (*saved) {
    post(Message::Kind::Info, "Saved " + (*saved)->filename().string());
    if (saving_design_ != opened_count_) return true;  // another design has been opened meanwhile
    project_path_ = **saved;
    saved_state_ = saving_state_;
  } else {
    post(saved->error());
  }
  return true;
}

AppState::DocumentState AppState::document_state() const {
  return {document_.moment(), names_given_};
}

bool AppState::modified() const {
  return !document_.empty() && saved_state_ != document_state();
}

std::string AppState::title() const {
  if (document_.empty()) return {};
  return project_path_.empty() ? document_.name() : project_path_.filename().string();
}

}  // namespace planewright::ui
