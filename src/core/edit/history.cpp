#include "core/edit/history.h"

#include <algorithm>
#include <utility>

namespace planewright {

void History::begin(Moment opened) {
  opened.number = next_number_++;
  moments_.clear();
  moments_.push_back(std::move(opened));
  done_ = 0;
  merging_ = false;
}

void History::step(Moment next) {
  next.number = next_number_++;
  const bool merges = merging_ && !next.merge_key.empty() && done_ > 0 && done_ + 1 == moments_.size() &&
                      present().merge_key == next.merge_key;
  if (!merges) {
    merging_ = !next.merge_key.empty();
    moments_.resize(done_ + 1);
    moments_.push_back(std::move(next));
    ++done_;
    return;
  }
  const Moment& before = moments_[done_ - 1];
  if (next.design == before.design && next.mesh == before.mesh && next.clusters == before.clusters &&
      next.contract == before.contract) {  // dragged back
    moments_.pop_back();
    --done_;
    merging_ = false;
    return;
  }
  next.what = present().what;
  moments_.back() = std::move(next);
}

void History::set_clusters(SharedClusters clusters) {
  moments_[done_].clusters = std::move(clusters);
  moments_[done_].number = next_number_++;
}

void History::go_to(int done) {
  done_ = static_cast<std::size_t>(std::clamp(done, 0, steps()));
  merging_ = false;
}

}  // namespace planewright
