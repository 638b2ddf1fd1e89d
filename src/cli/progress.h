// Progress of a solve on stderr: one line rewritten in place on a terminal, a line now and then otherwise.
// Also turns Ctrl-C into a stop request, so that an impatient user still gets the best state.
#pragma once

#include <stop_token>

#include "core/solve/iteration.h"

namespace planewright::cli {

class Progress final : public SolveObserver {
 public:
  // quiet: prints nothing, still watches for Ctrl-C. tolerance: of the first-order residual, what the bar
  // runs to.
  Progress(bool quiet, double tolerance);
  ~Progress() override;
  void on_iteration(const Iteration& iteration, const State* state) override;
  bool wants_states() const override { return false; }
  std::stop_token stop_token() const { return stop_.get_token(); }
  void finish();  // ends the line
  void poll();    // asks for a stop if Ctrl-C was pressed

 private:
  std::stop_source stop_;
  bool quiet_, terminal_;
  double tolerance_;
  double worst_ = 0.0;  // the largest first-order residual so far: where the bar begins
  double last_printed_ = -1e9;
  bool line_open_ = false;
};

}  // namespace planewright::cli
