// RowFamily: a list of scalar functions r_0(z), r_1(z), ... of the unknowns, each touching a few of them.
// Energies are sums of their squares, constraints keep them between bounds; so a new energy or constraint is
// one small file that says which unknowns a row touches (its stencil) and how to evaluate it there.
// Scattering into the solver's sparse matrices happens in one place (problem.cpp).
//
// Contract. rows(), stencil() and curvature() never change after construction and name every entry that can
// become non-zero; zeros stay in. evaluate() is pure and may be called from any thread. A row that cannot be
// evaluated returns a number that is not finite: the solver then shortens its step. Units: normalised
// (layout.h). Indices: variables of the Layout, 0-based, no variable twice in one stencil.
#pragma once

#include <span>

#include "core/base/geometry.h"

namespace planewright {

// A pair of positions in a stencil, second <= first: an entry of the lower triangle of the row's own Hessian,
// whatever the order of the variables in the whole problem.
struct StencilPair {
  int first, second;
};

class RowFamily {
 public:
  virtual ~RowFamily() = default;

  virtual int rows() const = 0;
  virtual std::span<const int> stencil(int row) const = 0;
  // Where the row's Hessian can be non-zero; empty for a linear row.
  virtual std::span<const StencilPair> curvature(int row) const;

  // Value of a row. local: the stencil's variables, in its order. gradient (one entry per stencil variable)
  // and curvature (one per pair of curvature(row)) are filled completely where not null.
  virtual double evaluate(int row, const double* local, double* gradient, double* curvature) const = 0;
};

inline std::span<const StencilPair> RowFamily::curvature(int) const {
  return {};
}

}  // namespace planewright
