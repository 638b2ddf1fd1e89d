#include "core/solve/mumps_gate.h"

#include <dlfcn.h>
#include <malloc.h>

#include <cstdlib>

namespace planewright {
namespace {

// MUMPS orders with Scotch, which breaks ties by whichever of its threads comes first, so that two runs would
// differ in their last bits. Set before main(), while no other thread can be reading the environment.
[[maybe_unused]] const int scotch_is_single_threaded = ::setenv("SCOTCH_PTHREAD_NUMBER", "1", 1);

// OpenBLAS reads its environment when it is loaded, before main(); afterwards only its own function sets the
// number of threads. Another BLAS has no such function and is single-threaded in Debian.
void pin_blas_to_one_thread() {
  using SetThreads = void (*)(int);
  if (auto set = reinterpret_cast<SetThreads>(::dlsym(RTLD_DEFAULT, "openblas_set_num_threads"))) set(1);
}

// Scotch goes on with one sequence of random numbers through the whole life of the process; begun anew, an
// ordering depends on its matrix alone, and the second solve gives the same bits as the first.
void restart_scotch_random_numbers() {
  using Reset = void (*)();
  static const auto reset = reinterpret_cast<Reset>(::dlsym(RTLD_DEFAULT, "SCOTCH_randomReset"));
  if (reset) reset();
}

// MUMPS allocates and frees its whole workspace at every factorisation; glibc would map and zero those pages
// anew each time (measured: a seventh of a solve). Keeping up to a gigabyte of freed memory costs less.
void keep_freed_memory() {
#ifdef __GLIBC__
  ::mallopt(M_MMAP_MAX, 0);
  ::mallopt(M_TRIM_THRESHOLD, 1 << 30);
#endif
}

}  // namespace

std::unique_lock<std::recursive_mutex> enter_mumps_gate() {
  // The library's shared state is process-wide, so its lock has to be.
  static std::recursive_mutex gate;
  static const bool pinned = (pin_blas_to_one_thread(), keep_freed_memory(), true);
  (void)pinned;
  std::unique_lock lock(gate);
  restart_scotch_random_numbers();
  return lock;
}

}  // namespace planewright
