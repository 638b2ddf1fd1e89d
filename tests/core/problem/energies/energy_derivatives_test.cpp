// Every energy of the catalogue alone: derivatives against differences over small and real designs and
// degenerate ones, and what scale and place of a model do to its value.
#include <gtest/gtest.h>

#include "core/problem/derivative_check.h"
#include "core/problem/energies/energy_catalogue.h"
#include "energy_rows.h"

namespace planewright {
namespace {

using namespace test;

SharedComplex edited(const SharedComplex& complex, void (*edit)(TangentComplex&)) {
  TangentComplex copy = *complex;
  edit(copy);
  return std::make_shared<const TangentComplex>(std::move(copy));
}

std::vector<NamedComplex> designs() {
  std::vector<NamedComplex> all = small_complexes();
  all.push_back({"mixed_polygons", planarize_of(mixed_polygons().mesh())});
  all.push_back({"mixed_polygons_offset", planarize_of(mixed_polygons().mesh(), {0.3})});
  all.push_back({"mixed_polygons_dual", dual_of(mixed_polygons().mesh(), {-0.2})});
  all.push_back({"wave_roof_dual", dual_of(make_sample("wave-roof", 30).value(), {0.5})});
  all.push_back({"alpine_hut_dual", dual_of(make_sample("alpine-hut", 30).value())});
  Shape slivers = twisted_grid(3, 2);
  slivers.positions.col(1) *= 1e-5;
  all.push_back({"slivers", planarize_of(slivers.mesh())});
  all.push_back({"coincident_points", edited(planarize_of(twisted_grid(2, 2).mesh()), [](TangentComplex& c) {
                   c.preferred.row(4) = c.preferred.row(3);  // ends of an edge
                   c.preferred.row(8) = c.preferred.row(4);  // and of a diagonal
                 })});
  all.push_back({"one_point", edited(planarize_of(cube().mesh()), [](TangentComplex& c) {
                   c.preferred.rowwise() = Eigen::RowVector3d(0.1, 0.2, 0.3);
                 })});
  return all;
}

enum class Place { Start, Perturbed, Far, OnePoint, ZeroLengthEdge, LongNormals };
constexpr Place kPlaces[] = {Place::Start,    Place::Perturbed,      Place::Far,
                             Place::OnePoint, Place::ZeroLengthEdge, Place::LongNormals};

State at(Place place, const TangentComplex& complex) {
  State state = initial_state(complex);
  switch (place) {
    case Place::Start:
      break;
    case Place::Perturbed:
      return perturbed(complex, 0.2);
    case Place::Far:
      return perturbed(complex, 5.0);
    case Place::OnePoint:
      state.x.rowwise() = Eigen::RowVector3d(state.x.row(0));
      break;
    case Place::ZeroLengthEdge:
      state = perturbed(complex, 0.1);
      state.x.row(complex.panel_edges[0].a) = state.x.row(complex.panel_edges[0].b);
      break;
    case Place::LongNormals:
      state = perturbed(complex, 0.1);
      state.n *= 3.0;
      break;
  }
  return state;
}

class EnergyDerivatives : public testing::TestWithParam<size_t> {};

TEST_P(EnergyDerivatives, AgreeWithDifferences) {
  const std::string name = energy_catalogue()[GetParam()].name;
  int with_slope = 0;
  for (const auto& [label, complex] : designs()) {
    const auto problem = problem_of(complex, {{name, 1.3}});
    if (problem->residuals() == 0) continue;  // no diagonals, no edge with a direction
    double shortest = 1.0;
    for (const PanelEdge& edge : complex->panel_edges)
      shortest = std::min(shortest, (complex->preferred.row(edge.a) - complex->preferred.row(edge.b)).norm() /
                                        complex->mean_edge);
    for (const Place place : kPlaces) {
      SCOPED_TRACE(label + " " + std::to_string(static_cast<int>(place)));
      const Vector z = problem->from_state(at(place, *complex));
      // Where the wanted length is next to nothing, fourth derivatives reach 1e6, and so do values:
      // differences need a smaller step there and have larger rounding.
      const DerivativeCheck check = check_derivatives(*problem, z, shortest < 0.01 ? 1e-6 : 1e-5);
      const double f = problem->objective(z.data());
      EXPECT_LT(check.gradient_error, 1e-6 * std::max(1.0, 1e-3 * f)) << check.worst;
      EXPECT_LT(check.hessian_error, 2e-6 * std::max(1.0, 1e-2 * check.gradient_norm)) << check.worst;
      EXPECT_GT(check.hessian_norm, 0.1);
      // Where all corners are blunt and no edge is short, there is nothing to do.
      if (name == "corner-angle" && f == 0.0) continue;
      if (place == Place::Perturbed) {
        EXPECT_GT(check.gradient_norm, 1e-3);
        ++with_slope;
      }
    }
  }
  EXPECT_GE(with_slope, name == "corner-angle" ? 6 : 12);
}

// Without the constraints' curvature, which check_derivatives() includes: what the energy alone says.
TEST_P(EnergyDerivatives, AreNotZero) {
  const EnergyInfo& info = energy_catalogue()[GetParam()];
  const SharedComplex complex = dual_of(make_sample("wave-roof", 30).value(), {0.5});
  const auto problem = problem_of(complex, {{info.name, 1.0}});
  const Vector z = problem->from_state(perturbed(*complex, 0.2));
  EXPECT_GT(gradient(*problem, z).norm(), 0.1);
  EXPECT_GT(hessian(*problem, z, 1.0, Vector::Zero(problem->rows())).norm(), 0.1);
}

TEST_P(EnergyDerivatives, DoNotDependOnScaleAndPlace) {
  const std::string name = energy_catalogue()[GetParam()].name;
  const auto scaled = [](Shape shape, double scale, const Vector3d& shift) {
    shape.positions = (scale * shape.positions).rowwise() + shift.transpose();
    return shape;
  };
  const Shape quads = mixed_polygons(), triangles = shape_of(make_sample("wave-roof", 30).value());
  for (const bool dual : {false, true}) {
    const auto build = [&](double scale, const Vector3d& shift) {
      return dual ? dual_of(scaled(triangles, scale, shift).mesh(), {0.3 * scale})
                  : planarize_of(scaled(quads, scale, shift).mesh(), {-0.2 * scale});
    };
    const SharedComplex complex = build(1.0, {0, 0, 0});
    const State state = perturbed(*complex, 0.3);
    const double expected = objective(*problem_of(complex, {{name, 0.7}}), state);
    EXPECT_GT(expected, 1e-3);
    for (const auto& [scale, shift] : {std::pair{1000.0, Vector3d(0, 0, 0)},
                                       {1000.0, Vector3d(3e5, -7e5, 2e5)},
                                       {1e-3, Vector3d(0.5, 0.1, -0.3)},
                                       {1.0, Vector3d(1e4, 0, 0)}}) {
      const SharedComplex same = build(scale, shift);
      State moved = state;
      moved.x *= scale;
      moved.h *= scale;
      EXPECT_NEAR(objective(*problem_of(same, {{name, 0.7}}), moved), expected, 1e-8 * expected)
          << dual << " " << scale;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EnergyDerivatives, testing::Range(size_t{0}, energy_catalogue().size()),
                         [](const auto& energy) {
                           std::string name = energy_catalogue()[energy.param].name;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace planewright
