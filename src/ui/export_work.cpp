#include "ui/export_work.h"

#include <utility>

namespace planewright::ui {

void ExportWork::Gauge::set(std::string_view stage, double fraction) {
  const std::lock_guard lock(mutex_);
  stage_.name = stage;
  stage_.fraction = fraction;
}

ExportStage ExportWork::Gauge::read() const {
  const std::lock_guard lock(mutex_);
  return stage_;
}

ExportWork::ExportWork(std::function<void()> wake) : wake_(std::move(wake)) {}

ExportWork::~ExportWork() {
  prepare_stop_.request_stop();
  write_stop_.request_stop();
}

void ExportWork::prepare(const ExportJob& job) {
  if (wish_) return;  // what waits to be written is what was asked for
  if (wanted_ != job) {
    wanted_ = job;
    refusal_.reset();
  }
  if (running_ && running_ != wanted_) prepare_stop_.request_stop();
  start_preparing();
}

void ExportWork::rest() {
  if (wish_) return;
  wanted_.reset();
  if (running_) prepare_stop_.request_stop();
}

bool ExportWork::preparing() const {
  return wanted_ && !ready() && !refusal_;
}

void ExportWork::start_preparing() {
  if (!preparing() || prepare_task_.running()) return;
  running_ = wanted_;
  prepare_stop_ = {};
  preparing_gauge_ = std::make_shared<Gauge>();
  prepare_task_.start(
      [number = next_number_++, job = *wanted_, gauge = preparing_gauge_,
       stop = prepare_stop_.get_token()]() -> Made {
        // No formats, no title block: neither makes a difference to what there is to write.
        ExportChoice choice;
        choice.layout = job.layout;
        const ExportSettings settings = export_settings(choice, job.contract, {}, {}, false);
        auto made = prepare_export(
            job.model, settings, job.surface.get(),
            [&](std::string_view stage, double fraction) { gauge->set(stage, fraction); }, stop);
        if (!made) return tl::unexpected(made.error());
        return std::make_shared<const PreparedExport>(PreparedExport{number, job, std::move(*made)});
      },
      wake_);
}

void ExportWork::write(ExportSettings settings, std::filesystem::path folder) {
  wish_ = Wish{std::move(settings), std::move(folder)};
  stop_asked_ = false;
  end_.reset();
  if (ready()) start_writing();
}

void ExportWork::start_writing() {
  write_stop_ = {};
  writing_gauge_ = std::make_shared<Gauge>();
  written_model_ = prepared_->job.model;
  write_task_.start(
      [prepared = prepared_, wish = std::move(*wish_), gauge = writing_gauge_,
       stop = write_stop_.get_token()] {
        return write_export(
            prepared->job.model, prepared->made, wish.settings, wish.folder,
            [&](std::string_view stage, double fraction) { gauge->set(stage, fraction); }, stop);
      },
      wake_);
  wish_.reset();
}

void ExportWork::end(Result<ExportOutcome> outcome, std::shared_ptr<const WorkshopModel> model) {
  const bool stopped = stop_asked_ && !outcome;
  end_ = ExportEnd{std::move(model), std::move(outcome), stopped};
  stop_asked_ = false;
}

void ExportWork::stop() {
  if (!writing()) return;
  stop_asked_ = true;
  write_stop_.request_stop();
  if (!wish_) return;
  wish_.reset();
  end(fail(ErrorCode::Usage, "stopped before anything was written"), nullptr);
}

ExportStage ExportWork::stage() const {
  if (write_task_.running()) return writing_gauge_->read();
  return prepare_task_.running() ? preparing_gauge_->read() : ExportStage();
}

bool ExportWork::update() {
  bool changed = false;
  if (auto made = prepare_task_.take()) {
    changed = true;
    const bool of_the_newest = running_ == wanted_;
    running_.reset();
    if (of_the_newest && *made) {
      prepared_ = std::move(**made);
    } else if (of_the_newest && !prepare_stop_.stop_requested()) {
      refusal_ = made->error();
    }
  }
  if (auto outcome = write_task_.take()) {
    changed = true;
    end(std::move(*outcome), std::exchange(written_model_, nullptr));
  }
  start_preparing();
  if (wish_ && ready()) {
    start_writing();
    changed = true;
  } else if (wish_ && refusal_) {
    wish_.reset();
    end(tl::unexpected(*refusal_), nullptr);
    changed = true;
  }
  return changed;
}

std::optional<ExportEnd> ExportWork::take_end() {
  return std::exchange(end_, std::nullopt);
}

}  // namespace planewright::ui
