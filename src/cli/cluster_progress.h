// Progress of a clustering on stderr, and Ctrl-C as a stop request.
#pragma once

#include "cli/interrupt_watch.h"
#include "core/cluster/clustering.h"

namespace planewright::cli {

class ClusterProgressLine final : public ClusterObserver {
 public:
  explicit ClusterProgressLine(bool quiet);
  ~ClusterProgressLine() override;
  std::stop_token stop_token() const { return interrupt_.stop_token(); }
  void on_iteration(const ClusterProgress& progress) override;

 private:
  InterruptWatch interrupt_;
  bool quiet_, terminal_;
  double last_printed_ = -1e9;  // seconds
  bool line_open_ = false;
};

}  // namespace planewright::cli
