#include "cli/interrupt_watch.h"

#include <chrono>

namespace planewright::cli {
namespace {

constexpr std::chrono::milliseconds kBetweenLooks{20};

}  // namespace

InterruptWatch::InterruptWatch() : interrupt_(true, 1.0) {
  watcher_ = std::jthread([this](const std::stop_token& ended) {
    while (!ended.stop_requested()) {
      interrupt_.poll();
      std::this_thread::sleep_for(kBetweenLooks);
    }
  });
}

}  // namespace planewright::cli
