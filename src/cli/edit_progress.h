// Progress of rating and applying edits on stderr, and Ctrl-C as a stop request: looked for by a thread of
// its own, because the solves between two edits tell nobody of their steps.
#pragma once

#include <thread>

#include "cli/progress.h"
#include "core/advise/improve.h"

namespace planewright::cli {

class EditProgress final : public ImproveObserver {
 public:
  explicit EditProgress(bool quiet);
  ~EditProgress() override;
  std::stop_token stop_token() const { return interrupt_.stop_token(); }
  // round: 0 where there are none.
  void on_rated(int round, int rated, int of) override;
  void on_round(int round, const ImproveReport::Round& result, const DesignMeasure& now) override;

 private:
  void finish_line();

  Progress interrupt_;
  bool quiet_, terminal_, line_open_ = false;
  std::jthread watcher_;  // last: it uses interrupt_
};

}  // namespace planewright::cli
