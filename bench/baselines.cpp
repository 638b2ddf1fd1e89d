#include "baselines.h"

namespace planewright::bench {
namespace {

// What both share: exact Hessian from the first step, and Ipopt's own termination instead of ours.
IpoptOverrides plain() {
  IpoptOverrides overrides;
  overrides.own_termination = false;
  overrides.gauss_newton_iterations = 0;
  overrides.strings["nlp_scaling_method"] = "gradient-based";
  overrides.integers["mumps_pivot_order"] = 7;
  overrides.integers["mumps_permuting_scaling"] = 7;
  overrides.integers["mumps_scaling"] = 77;
  overrides.integers["mumps_mem_percent"] = 1000;
  overrides.integers["acceptable_iter"] = 15;
  overrides.integers["max_iter"] = 3000;
  overrides.numbers["mumps_pivtol"] = 1e-6;
  overrides.numbers["constr_mult_init_max"] = 1000.0;
  overrides.numbers["tol"] = 1e-8;
  overrides.numbers["constr_viol_tol"] = 1e-4;
  overrides.numbers["dual_inf_tol"] = 1.0;
  return overrides;
}

}  // namespace

std::shared_ptr<const TangentComplex> raw_coordinates(const TangentComplex& complex) {
  auto raw = std::make_shared<TangentComplex>(complex);
  raw->mean_edge = 1.0;
  return raw;
}

IpoptOverrides default_options() {
  return plain();
}

IpoptOverrides prototype_options() {
  IpoptOverrides overrides = plain();
  overrides.strings["nlp_scaling_method"] = "none";
  overrides.integers["mumps_permuting_scaling"] = 0;
  overrides.integers["mumps_scaling"] = 0;
  overrides.numbers["tol"] = 1e-2;
  overrides.numbers["constr_viol_tol"] = 1e-7;
  return overrides;
}

}  // namespace planewright::bench
