#include "ui/workshop_watch.h"

#include <utility>

namespace planewright::ui {

void WorkshopWatch::ask(WorkshopKey key, WorkshopJob job) {
  asked_ = std::move(key);
  forgotten_ = false;
  task_.start([job = std::move(job), before = before_] { return prepare_workshop(job, before.get()); },
              wake_);
}

bool WorkshopWatch::update() {
  auto made = task_.take();
  if (!made || std::exchange(forgotten_, false)) return false;
  if (*made) {
    newest_ = before_ = std::make_shared<const PreparedWorkshop>(std::move(**made));
    newest_key_ = asked_;
    error_.reset();
  } else {
    newest_.reset();
    error_ = made->error();
  }
  return true;
}

void WorkshopWatch::forget() {
  forgotten_ = busy();
  asked_.reset();
  newest_key_.reset();
  newest_.reset();
  before_.reset();
  error_.reset();
}

}  // namespace planewright::ui
