#include "cli/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <string>

namespace planewright::cli {
namespace {

constexpr int kBarWidth = 24;
constexpr double kSecondsBetweenLines = 2.0, kSecondsBetweenUpdates = 0.05;

// Written by the signal handler, which may do nothing else. A second Ctrl-C ends the program at once.
volatile std::sig_atomic_t interrupted = 0;

void on_interrupt(int) {
  interrupted = 1;
  std::signal(SIGINT, SIG_DFL);
}

}  // namespace

Progress::Progress(bool quiet, double tolerance)
    : quiet_(quiet), terminal_(::isatty(STDERR_FILENO) != 0), tolerance_(tolerance) {
  interrupted = 0;
  std::signal(SIGINT, on_interrupt);
}

Progress::~Progress() {
  finish();
  std::signal(SIGINT, SIG_DFL);
}

void Progress::on_iteration(const Iteration& iteration, const State*) {
  poll();
  if (quiet_) return;
  worst_ = std::max({worst_, iteration.first_order, iteration.infeasibility});
  const double pause = terminal_ ? kSecondsBetweenUpdates : kSecondsBetweenLines;
  if (iteration.seconds - last_printed_ < pause) return;
  last_printed_ = iteration.seconds;

  // The way from the worst residual so far to the tolerance, in orders of magnitude.
  const double now = std::max({iteration.first_order, iteration.infeasibility, tolerance_});
  const double whole = std::log(std::max(worst_, 10.0 * tolerance_) / tolerance_);
  const double share = std::clamp(1.0 - std::log(now / tolerance_) / whole, 0.0, 1.0);
  const int filled = iteration.number == 0 ? 0 : static_cast<int>(std::lround(share * kBarWidth));
  const std::string bar = std::string(filled, '#') + std::string(kBarWidth - filled, '.');
  std::fprintf(stderr, "%s[%s] iteration %d  energy %.6g  off plane %.1e  slope %.1e  %.1f s%s%s",
               terminal_ ? "\r" : "", bar.c_str(), iteration.number, iteration.objective,
               iteration.infeasibility, iteration.first_order, iteration.seconds,
               iteration.restoration ? "  (restoring feasibility)" : "", terminal_ ? "\033[K" : "\n");
  std::fflush(stderr);
  line_open_ = terminal_;
}

void Progress::poll() {
  if (interrupted) stop_.request_stop();
}

void Progress::finish() {
  if (line_open_) std::fputc('\n', stderr);
  line_open_ = false;
}

}  // namespace planewright::cli
