// Runs one measurement in a process of its own (fork), so that its CPU time and peak memory are its own, and
// a crash, a lack of memory or a solve without end is a row of the table, not the end of the program.
//
// Threads: to be called while this process has only one.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>

namespace planewright::bench {

struct ChildLimits {
  double seconds = 900.0;   // wall; 0: none
  double memory_gb = 12.0;  // of address space; 0: none
};

enum class ChildEnd {
  Finished,
  CutOff,   // by ChildLimits::seconds
  Failed,   // it said why
  Crashed,  // by a signal, an out-of-memory kill included
};

// What the system tells of the whole child, loading of its model included.
struct ChildUsage {
  double wall = 0.0, cpu = 0.0;  // seconds; cpu: user and system
  double peak_mb = 0.0;          // resident
};

template <class T>
struct ChildOutcome {
  ChildEnd end = ChildEnd::Failed;
  std::string why;  // not Finished: one line
  ChildUsage usage;
  T value{};  // Finished
};

// work: fills `size` bytes at `out`; an exception's text becomes `why`.
ChildEnd run_in_child(const std::function<void(void* out)>& work, void* out, size_t size,
                      const ChildLimits& limits, std::string& why, ChildUsage& usage);

// T goes through a pipe byte by byte.
template <class T>
ChildOutcome<T> run_in_child(const std::function<T()>& work, const ChildLimits& limits) {
  static_assert(std::is_trivially_copyable_v<T>);
  ChildOutcome<T> outcome;
  outcome.end = run_in_child([&](void* out) { *static_cast<T*>(out) = work(); }, &outcome.value, sizeof(T),
                             limits, outcome.why, outcome.usage);
  return outcome;
}

}  // namespace planewright::bench
