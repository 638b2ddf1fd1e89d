// OpenBLAS starts its threads when it is loaded, and again in a forked child that sets their number: for a
// tenth of a second they spin, which would be charged to every measurement.
#pragma once

namespace planewright::bench {

// Begins this program anew with one BLAS thread, unless it already has one. To be called first of all. Where
// that is not possible it returns, and short times are a little too long.
void restart_with_one_blas_thread(char** argv);

}  // namespace planewright::bench
