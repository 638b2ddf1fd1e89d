#include "child_process.h"

#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>
#include <vector>

#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace planewright::bench {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point begun) {
  return std::chrono::duration<double>(Clock::now() - begun).count();
}

// What the first byte through the pipe says of the rest.
constexpr char kValue = 'v', kError = 'e';

void write_all(int to, const void* data, size_t size) {
  const char* at = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = ::write(to, at, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return;  // the parent is gone
    at += written;
    size -= static_cast<size_t>(written);
  }
}

void set_limits(const ChildLimits& limits) {
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // whoever ends the table ends its measurement
#endif
  if (limits.memory_gb > 0.0) {
    const auto bytes = static_cast<rlim_t>(limits.memory_gb * (1 << 30));
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_AS, &limit);
  }
}

[[noreturn]] void be_the_child(const std::function<void(void*)>& work, size_t size, const ChildLimits& limits,
                               int to) {
  set_limits(limits);
  std::vector<char> message(1 + size, kValue);
  std::string error;
  try {
    std::vector<std::max_align_t> value(size / sizeof(std::max_align_t) + 1);
    work(value.data());
    std::memcpy(message.data() + 1, value.data(), size);
  } catch (const std::bad_alloc&) {
    error = "out of memory";
  } catch (const std::exception& exception) {
    error = exception.what();
  }
  if (!error.empty()) {
    message.assign(1, kError);
    message.insert(message.end(), error.begin(), error.end());
  }
  write_all(to, message.data(), message.size());
  ::_exit(0);  // the parent's streams and objects are the parent's
}

// Everything until the other end closes; false: the time was over before.
bool read_until_closed(int from, const ChildLimits& limits, Clock::time_point begun, std::string& message) {
  while (true) {
    int wait = -1;
    if (limits.seconds > 0.0) {
      const double left = limits.seconds - since(begun);
      if (left <= 0.0) return false;
      wait = static_cast<int>(1000.0 * left) + 1;
    }
    pollfd ready{from, POLLIN, 0};
    const int polled = ::poll(&ready, 1, wait);
    if (polled < 0 && errno == EINTR) continue;
    if (polled == 0) return false;
    char buffer[4096];
    const ssize_t got = ::read(from, buffer, sizeof buffer);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return true;
    message.append(buffer, static_cast<size_t>(got));
  }
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

ChildEnd run_in_child(const std::function<void(void* out)>& work, void* out, size_t size,
                      const ChildLimits& limits, std::string& why, ChildUsage& usage) {
  int ends[2];
  if (::pipe(ends) != 0) throw std::runtime_error("no pipe: " + std::string(std::strerror(errno)));
  std::fflush(nullptr);
  const auto begun = Clock::now();
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no fork: " + std::string(std::strerror(errno)));
  if (child == 0) {
    ::close(ends[0]);
    be_the_child(work, size, limits, ends[1]);
  }
  ::close(ends[1]);
  std::string message;
  const bool in_time = read_until_closed(ends[0], limits, begun, message);
  ::close(ends[0]);
  if (!in_time) ::kill(child, SIGKILL);
  int status = 0;
  rusage used{};
  while (::wait4(child, &status, 0, &used) < 0 && errno == EINTR) {
  }
  usage = {since(begun), seconds_of(used.ru_utime) + seconds_of(used.ru_stime),
           static_cast<double>(used.ru_maxrss) / 1024.0};  // Linux counts kilobytes

  char text[96];
  if (!in_time) {
    std::snprintf(text, sizeof text, "cut off after %.0f s", limits.seconds);
    why = text;
    return ChildEnd::CutOff;
  }
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    why = "ended by signal " + std::to_string(signal) + " (" + ::strsignal(signal) + ")" +
          (signal == SIGKILL ? ": out of memory?" : "");
    return ChildEnd::Crashed;
  }
  if (message.size() == 1 + size && message[0] == kValue) {
    std::memcpy(out, message.data() + 1, size);
    return ChildEnd::Finished;
  }
  why = message.size() > 1 && message[0] == kError ? message.substr(1) : "it ended without a word";
  return ChildEnd::Failed;
}

}  // namespace planewright::bench
