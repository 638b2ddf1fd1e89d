// Ctrl-C as a stop request while something works that tells nobody of its steps: a thread of its own looks
// for it. A second Ctrl-C ends the program.
#pragma once

#include <thread>

#include "cli/progress.h"

namespace planewright::cli {

class InterruptWatch {
 public:
  InterruptWatch();
  std::stop_token stop_token() const { return interrupt_.stop_token(); }

 private:
  Progress interrupt_;
  std::jthread watcher_;  // last: it uses interrupt_
};

}  // namespace planewright::cli
