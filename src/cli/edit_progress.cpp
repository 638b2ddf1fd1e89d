#include "cli/edit_progress.h"

#include <unistd.h>

#include <cstdio>

namespace planewright::cli {

EditProgress::EditProgress(bool quiet) : quiet_(quiet), terminal_(::isatty(STDERR_FILENO) != 0) {}

EditProgress::~EditProgress() {
  finish_line();
}

void EditProgress::on_rated(int round, int rated, int of) {
  if (quiet_ || !terminal_) return;  // a log is told of rounds alone
  const std::string heading = round > 0 ? "round " + std::to_string(round) + ": " : "";
  std::fprintf(stderr, "\r%srating edits, %d of %d\033[K", heading.c_str(), rated, of);
  std::fflush(stderr);
  line_open_ = true;
}

void EditProgress::on_round(int round, const ImproveReport::Round& result, const DesignMeasure& now) {
  if (quiet_) return;
  finish_line();
  std::fprintf(stderr,
               "round %d: %d edits of %d rated, score %.2f (gained %.2f), %d places not to be built\n", round,
               result.edits, result.rated, total(now.score), result.gained, now.unbuildable());
}

void EditProgress::finish_line() {
  if (line_open_) std::fputs("\r\033[K", stderr);
  line_open_ = false;
}

}  // namespace planewright::cli
