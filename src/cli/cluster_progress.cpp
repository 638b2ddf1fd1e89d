#include "cli/cluster_progress.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace planewright::cli {
namespace {

constexpr double kSecondsBetweenLines = 2.0, kSecondsBetweenUpdates = 0.05;

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

ClusterProgressLine::ClusterProgressLine(bool quiet)
    : quiet_(quiet), terminal_(::isatty(STDERR_FILENO) != 0) {}

ClusterProgressLine::~ClusterProgressLine() {
  if (line_open_) std::fputs("\r\033[K", stderr);
}

void ClusterProgressLine::on_iteration(const ClusterProgress& progress) {
  if (quiet_) return;
  const double now = seconds_now();
  if (now - last_printed_ < (terminal_ ? kSecondsBetweenUpdates : kSecondsBetweenLines)) return;
  last_printed_ = now;
  std::fprintf(stderr, "%sclustering: %zu regions, iteration %d, error %.6g%s", terminal_ ? "\r" : "",
               progress.proxies.size(), progress.iteration, progress.error, terminal_ ? "\033[K" : "\n");
  std::fflush(stderr);
  line_open_ = terminal_;
}

}  // namespace planewright::cli
