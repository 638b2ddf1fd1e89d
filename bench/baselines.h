// The frozen baselines: how Ipopt is run without this project's tuning, so that later work is measured
// against the same. Do not change these, nor the torus's grid (main.cpp, models.cpp): compare against them.
#pragma once

#include <memory>

#include "core/complex/tangent_complex.h"
#include "core/solve/ipopt_solver.h"

namespace planewright::bench {

// A copy of the complex whose unit is the model unit, not the mean edge: "raw coordinates".
std::shared_ptr<const TangentComplex> raw_coordinates(const TangentComplex& complex);

// Ipopt 3.11's default options: gradient-based scaling, tol 1e-8, MUMPS' matching and scaling on, exact
// Hessian.
IpoptOverrides default_options();

// The options of the first prototype (design notes, section 6): mean edge 1, tol 1e-2 with constr_viol_tol
// 1e-7, MUMPS' matching and scaling off, exact Hessian.
IpoptOverrides prototype_options();

}  // namespace planewright::bench
