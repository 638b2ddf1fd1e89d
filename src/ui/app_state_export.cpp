// AppState's export for the workshop: what is prepared and written, of the panels that are shown.
#include "ui/app_state.h"
#include "ui/export_text.h"

namespace planewright::ui {

std::optional<Error> AppState::why_no_export() const {
  const auto no = [](const char* what, const char* remedy) {
    return Error{ErrorCode::Refused, what, {}, remedy};
  };
  if (document_.empty()) return no("There is no design yet", "Open a mesh, or one of the samples.");
  if (!shown())
    return solving() ? no("The panels are being solved", "They can be exported as soon as there are some.")
                     : no("There are no panels yet", "Solve first (Space).");
  if (workshop_error()) return workshop_error();
  if (solving_layer() == active_layer() && !polishing())
    return no("The panels are being solved", "They can be exported as soon as that comes to a result.");
  if (!up_to_date() || run(active_layer()).failed)
    return no("The panels are older than the design", "Solve first (Space).");
  if (!shown()->final) return no("The newest solve came to no result", "Solve again (Space).");
  return std::nullopt;
}

std::optional<ExportJob> AppState::export_job(const ExportChoice& choice) const {
  if (why_no_export() || !workshop_fits()) return std::nullopt;
  const PreparedWorkshop& known = *workshop();
  if (!known.job.thorough) return std::nullopt;
  ExportJob job{known.model, known.surface, document_.contract(), choice.layout};
  // Names that were kept leave the model as it was.
  if (export_iterate_ == known.job.iterate && export_model_ && export_model_->names == job.model->names &&
      export_model_->model_unit == job.model->model_unit && export_model_->title == job.model->title)
    job.model = export_model_;
  return job;
}

bool AppState::export_preparing() const {
  return wanted_export && !why_no_export() && (export_work_.preparing() || !export_job(*wanted_export)) &&
         !export_work_.refusal();
}

const PreparedExport* AppState::export_preparation() const {
  const PreparedExport* prepared = export_work_.prepared().get();
  const bool fits = prepared != nullptr && shown() && export_iterate_ == shown()->iterate &&
                    prepared->job.model == export_model_;
  return fits ? prepared : nullptr;
}

bool AppState::export_panels_to_workshop(const ExportChoice& choice, const std::filesystem::path& folder,
                                         bool overwrite) {
  if (export_work_.writing()) return false;
  const auto job = export_job(choice);
  if (!job) return false;
  export_outcome_.reset();
  export_error_.reset();
  export_stopped_ = false;
  prepare(*job);
  export_target_ = folder;
  export_layer_ = run(active_layer()).id;
  export_series_ = panel_series(document_.settings());
  export_work_.write(export_settings(choice, job->contract, job->model->title, today(), overwrite), folder);
  return true;
}

void AppState::prepare(const ExportJob& job) {
  export_model_ = job.model;
  export_iterate_ = workshop()->job.iterate;
  export_work_.prepare(job);
}

void AppState::forget_export_outcome() {
  export_outcome_.reset();
  export_error_.reset();
  export_stopped_ = false;
}

bool AppState::update_export() {
  bool changed = export_work_.update();
  if (auto end = export_work_.take_end()) {
    take_export(std::move(*end));
    changed = true;
  }
  if (!wanted_export) {
    export_work_.rest();
  } else if (const auto job = export_job(*wanted_export)) {
    prepare(*job);
  }
  return changed;
}

void AppState::take_export(ExportEnd end) {
  export_stopped_ = end.stopped;
  if (!end.outcome) {
    if (!end.stopped) export_error_ = readable(std::move(end.outcome.error()));
    if (!wanted_export && export_error_) post(*export_error_);
    return;
  }
  export_outcome_ = std::move(*end.outcome);
  // The layer can be gone by now, or have become another kind of panels.
  for (int i = 0; i < layer_count(); ++i) {
    const auto index = static_cast<std::size_t>(i);
    if (runs_[index].id != export_layer_ ||
        panel_series(document_.design().layers[index].settings) != export_series_)
      continue;
    keep_names(*end.model, i);
  }
  if (wanted_export) return;
  const bool pass = export_outcome_->certificate.pass();
  post(pass ? Message::Kind::Info : Message::Kind::Error, outcome_line(*export_outcome_),
       export_outcome_->folder.string(), pass ? "" : "See certificate.html there.");
}

}  // namespace planewright::ui
