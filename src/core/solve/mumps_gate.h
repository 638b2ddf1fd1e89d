// The one gate to MUMPS: its instances share state inside the library in the releases that Debian ships, so a
// factorisation, by Ipopt or by ours, is done by one thread of the process at a time.
//
// A holder keeps the lock for a whole solve. The window never enters: it only talks to SolveSession.
#pragma once

#include <mutex>

namespace planewright {

// Waits for the gate. Also pins BLAS to one thread, so that results do not depend on the number of cores.
[[nodiscard]] std::unique_lock<std::recursive_mutex> enter_mumps_gate();

}  // namespace planewright
