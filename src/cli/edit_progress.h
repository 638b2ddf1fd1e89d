// Progress of rating and applying edits on stderr, and Ctrl-C as a stop request.
#pragma once

#include "cli/interrupt_watch.h"
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

  InterruptWatch interrupt_;
  bool quiet_, terminal_, line_open_ = false;
};

}  // namespace planewright::cli
