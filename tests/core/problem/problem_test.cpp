#include "core/problem/problem.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <limits>
#include <set>

#include "core/problem/energies/energy_catalogue.h"
#include "support/problems.h"

namespace planewright {
namespace {

using namespace test;

TEST(Layout, GivesEveryUnknownItsOwnPlace) {
  const Layout layout{5, 3, Freedom::NormalsAndOffsets};
  EXPECT_EQ(layout.size(), 27);
  std::set<int> seen;
  for (int j = 0; j < 5; ++j)
    for (int c = 0; c < 3; ++c) EXPECT_TRUE(seen.insert(layout.x(j, c)).second);
  for (int i = 0; i < 3; ++i) {
    for (int c = 0; c < 3; ++c) EXPECT_TRUE(seen.insert(layout.n(i, c)).second);
    EXPECT_TRUE(seen.insert(layout.h(i)).second);
  }
  EXPECT_EQ(static_cast<int>(seen.size()), layout.size());
  EXPECT_EQ(*seen.begin(), 0);
  EXPECT_EQ(*seen.rbegin(), layout.size() - 1);
}

TEST(Layout, FreedomSaysWhatMoves) {
  for (const auto& [freedom, normals, offsets] :
       {std::tuple{Freedom::Fixed, false, false}, std::tuple{Freedom::Normals, true, false},
        std::tuple{Freedom::NormalsAndOffsets, true, true}}) {
    const Layout layout{2, 2, freedom};
    EXPECT_TRUE(layout.is_free(layout.x(1, 2)));
    EXPECT_EQ(layout.is_free(layout.n(0, 0)), normals);
    EXPECT_EQ(layout.is_free(layout.n(1, 2)), normals);
    EXPECT_EQ(layout.is_free(layout.h(0)), offsets);
  }
}

TEST(Problem, RefusesUnknownEnergiesAndNamesTheKnownOnes) {
  const auto problem = Problem::create(planarize_of(cube().mesh()), {Freedom::Normals, {{"beauty", 1.0}}});
  ASSERT_FALSE(problem);
  EXPECT_EQ(problem.error().code, ErrorCode::Usage);
  EXPECT_NE(problem.error().what.find("beauty"), std::string::npos);
  for (const EnergyInfo& info : energy_catalogue())
    EXPECT_NE(problem.error().text().find(info.name), std::string::npos);
}

TEST(Problem, RefusesWeightsThatAreNoWeights) {
  for (const double weight :
       {-1.0, -1e-300, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const auto problem =
        Problem::create(planarize_of(cube().mesh()), {Freedom::Normals, {{"position", weight}}});
    ASSERT_FALSE(problem) << weight;
    EXPECT_EQ(problem.error().code, ErrorCode::Usage);
    EXPECT_NE(problem.error().text().find("position"), std::string::npos);
  }
}

TEST(EnergyCatalogue, MakesEnergiesThatBearTheirNames) {
  const auto problem = problem_of(planarize_of(cube().mesh()), {});
  const FootPoints feet{Points::Zero(8, 3), Points::Zero(8, 3)};
  std::set<std::string> names;
  for (const EnergyInfo& info : energy_catalogue()) {
    EXPECT_TRUE(names.insert(info.name).second);
    EXPECT_EQ(find_energy(info.name).value(), &info);
    const auto energy = info.make({problem->normalised(), problem->layout(), &feet});
    EXPECT_EQ(energy->name(), info.name);
    EXPECT_GT(energy->terms(), 0);
    EXPECT_GE(energy->rows(), energy->terms());
    EXPECT_FALSE(info.label.empty());
    EXPECT_FALSE(info.description.empty());
    EXPECT_GE(info.default_weight, 0.0);
  }
  EXPECT_TRUE(names.contains("position"));
  EXPECT_TRUE(names.contains("fairing"));
}

TEST(Problem, WithoutWeightsHasNoObjective) {
  const auto problem = problem_of(planarize_of(twisted_grid(2, 2).mesh()), {{"position", 0.0}});
  const Vector z = problem->from_state(perturbed(problem->complex(), 0.3));
  EXPECT_EQ(problem->objective(z.data()), 0.0);
  EXPECT_EQ(gradient(*problem, z).norm(), 0.0);
  EXPECT_TRUE(problem->energy_shares(z.data()).empty());
}

// w (X / N) sum r^2, in mean edges.
TEST(Problem, WeighsEnergiesAsStated) {
  Shape shape = grid(2, 2);
  shape.positions *= 4.0;  // mean edge 4
  const auto problem = problem_of(planarize_of(shape.mesh()), {{"position", 3.0}, {"fairing", 0.5}});
  State state = initial_state(problem->complex());
  state.x.row(4) += Eigen::RowVector3d(2, 4, 4);  // the middle: 1.5 edges away
  const Vector z = problem->from_state(state);
  const auto shares = problem->energy_shares(z.data());
  ASSERT_EQ(shares.size(), 2u);
  EXPECT_EQ(shares[0].name, "position");
  EXPECT_EQ(shares[0].weight, 3.0);
  EXPECT_DOUBLE_EQ(shares[0].value, 3.0 * 2.25);
  // Fairing: the middle is 1.5 from the mean of its neighbours, each corner half a diagonal (0.5) from its
  // own.
  EXPECT_EQ(shares[1].name, "fairing");
  EXPECT_DOUBLE_EQ(shares[1].value, 0.5 * (2.25 + 4 * 0.5));
  EXPECT_DOUBLE_EQ(problem->objective(z.data()), shares[0].value + shares[1].value);
}

// A point on no panel has no fairing term: N = 4, X = 5.
TEST(Problem, DividesByTheNumberOfTermsNotOfPoints) {
  TangentComplex complex = build_planarize(grid(1, 1).mesh()).value();
  complex.preferred.conservativeResize(5, 3);
  complex.preferred.row(4).setZero();
  complex.point_origin.push_back({PointKind::Vertex, 9});
  complex.planes_of_point.push_back(std::vector{0});
  finish(complex);
  const auto problem = problem_of(std::make_shared<const TangentComplex>(complex), {{"fairing", 2.0}});
  // Each corner of the square is half a diagonal from the middle of its two neighbours.
  EXPECT_DOUBLE_EQ(objective(*problem, initial_state(complex)), 2.0 * (5.0 / 4.0) * 4 * 0.5);
}

TEST(Problem, WeightsScaleTheirEnergyAlone) {
  const SharedComplex complex = planarize_of(twisted_grid(3, 2).mesh());
  const State state = perturbed(*complex, 0.2);
  const double position = objective(*problem_of(complex, {{"position", 1.0}}), state);
  const double fairing = objective(*problem_of(complex, {{"fairing", 1.0}}), state);
  EXPECT_GT(position, 0.0);
  EXPECT_GT(fairing, 0.0);
  EXPECT_NEAR(objective(*problem_of(complex, {{"position", 5.0}, {"fairing", 0.25}}), state),
              5.0 * position + 0.25 * fairing, 1e-12);
}

// Weight 1 means the same at every resolution: the sum over X points, not the mean, of an even displacement.
TEST(Problem, PositionEnergyOfAnEvenShiftIsItsSquareTimesThePoints) {
  for (const int n : {2, 5}) {
    const SharedComplex complex = planarize_of(grid(n, n).mesh());
    State state = initial_state(*complex);
    state.x.col(2).array() += 0.5;
    EXPECT_NEAR(objective(*problem_of(complex, {{"position", 1.0}}), state), 0.25 * complex->point_count(),
                1e-12);
  }
}

TEST(Problem, StateGoesThereAndBack) {
  Shape shape = twisted_grid(3, 2);
  shape.positions *= 37.0;
  shape.positions.rowwise() += Eigen::RowVector3d(500, 600, -700);
  const auto problem = problem_of(planarize_of(shape.mesh()), {{"position", 1.0}});
  const State state = perturbed(problem->complex(), 0.3);
  const Vector z = problem->from_state(state);
  ASSERT_EQ(z.size(), problem->variables());
  const State back = problem->to_state({z.data(), static_cast<size_t>(z.size())});
  EXPECT_LE((back.x - state.x).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_TRUE(same_bits(back.n, state.n));
  EXPECT_LE((back.h - state.h).cwiseAbs().maxCoeff(), 1e-14 * 37);
}

TEST(Problem, UnitsAreMeanEdgesAboutTheCentroid) {
  Shape shape = grid(2, 2);
  shape.positions *= 8.0;
  shape.positions.rowwise() += Eigen::RowVector3d(100, 0, 0);
  const auto problem = problem_of(planarize_of(shape.mesh(), {2.0}), {});
  const Vector z = problem->from_state(initial_state(problem->complex()));
  const Layout& layout = problem->layout();
  EXPECT_NEAR((z.segment<3>(layout.x(0)) - Vector3d(-1, -1, 0)).norm(), 0.0, 1e-14);
  EXPECT_NEAR((z.segment<3>(layout.x(4)) - Vector3d(0, 0, 0)).norm(), 0.0, 1e-14);
  EXPECT_EQ(z.segment<3>(layout.n(2)), Vector3d(0, 0, 1));
  EXPECT_DOUBLE_EQ(z[layout.h(1)], 0.25);
  EXPECT_NEAR(problem->normalised().preferred.colwise().mean().norm(), 0.0, 1e-14);
  EXPECT_DOUBLE_EQ(problem->normalised().mean_edge, 1.0);
}

// Rows are incidences, points in order and planes ascending, then unit normals; all equations.
TEST(Problem, RowsAreTheIncidencesThenTheNormals) {
  const SharedComplex complex = dual_of(domed_triangle_grid(3, 2).mesh());
  const auto problem = problem_of(complex, {{"position", 1.0}});
  ASSERT_EQ(problem->rows(), complex->incidence_count() + complex->plane_count());
  State state = perturbed(*complex, 0.2);
  state.n.row(3) *= 2.0;
  const Vector c = constraint_values(*problem, problem->from_state(state));
  const Vector residuals = incidence_residuals(*complex, state) / complex->mean_edge;
  EXPECT_NEAR((c.head(residuals.size()) - residuals).norm(), 0.0, 1e-13);
  for (int i = 0; i < complex->plane_count(); ++i)
    EXPECT_NEAR(c[residuals.size() + i], i == 3 ? 1.5 : 0.0, 1e-14);  // (|n|^2 - 1) / 2
  for (int r = 0; r < problem->rows(); ++r) {
    EXPECT_EQ(problem->bounds(r).low, 0.0);
    EXPECT_EQ(problem->bounds(r).high, 0.0);
  }
}

TEST(Problem, ViolationsAreMeasuredPerFamily) {
  const SharedComplex complex = planarize_of(grid(2, 1).mesh());
  const auto problem = problem_of(complex, {{"position", 1.0}});
  State state = initial_state(*complex);
  state.x(1, 2) -= 0.25;  // the lower middle: on two planes
  state.x(0, 2) += 1e-6;
  state.n.row(1) *= 3.0;  // (9 - 1) / 2; and its other points lie at z = 0 still
  const Vector z = problem->from_state(state);
  const auto violations = problem->violations(z.data(), 1e-3);
  ASSERT_EQ(violations.size(), 2u);
  EXPECT_EQ(violations[0].name, "incidence");
  EXPECT_EQ(violations[0].unit, "edges");
  EXPECT_DOUBLE_EQ(violations[0].max_violation, 0.75);
  EXPECT_EQ(violations[0].violated, 2);
  EXPECT_EQ(violations[1].name, "unit normal");
  EXPECT_DOUBLE_EQ(violations[1].max_violation, 4.0);
  EXPECT_EQ(violations[1].violated, 1);
  EXPECT_EQ(problem->violations(z.data(), 1e-7)[0].violated, 3);
}

// Moving, scaling or turning a model changes nothing but the units of the answer.
TEST(Problem, ObjectiveAndResidualsDoNotDependOnPlaceAndScale) {
  const Shape shape = twisted_grid(4, 3);
  const SharedComplex complex = planarize_of(shape.mesh());
  const std::map<std::string, double> weights{{"position", 1.0}, {"fairing", 0.3}};
  const auto problem = problem_of(complex, weights);
  const State state = perturbed(*complex, 0.2);
  const double f = objective(*problem, state);
  const Vector c = constraint_values(*problem, problem->from_state(state));
  EXPECT_GT(f, 0.01);
  for (const double scale : {1e-6, 1e3}) {
    Shape moved = shape;
    moved.positions *= scale;
    moved.positions.rowwise() += scale * Eigen::RowVector3d(5000, -7000, 3000);
    const auto same = problem_of(planarize_of(moved.mesh()), weights);
    State scaled = state;
    scaled.x *= scale;
    scaled.h *= scale;
    EXPECT_NEAR(objective(*same, scaled), f, 1e-9 * f);
    EXPECT_NEAR((constraint_values(*same, same->from_state(scaled)) - c).norm(), 0.0, 1e-9);
  }
  const Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  Shape turned = shape;
  turned.positions = shape.positions * turn.transpose();
  const SharedComplex turned_complex = planarize_of(turned.mesh());
  const auto same = problem_of(turned_complex, weights);
  State turned_state = state;
  // The frame's origin is the middle of the bounding box, which does not turn along.
  turned_state.x = ((state.x.rowwise() + complex->origin.transpose()) * turn.transpose()).rowwise() -
                   turned_complex->origin.transpose();
  turned_state.n = state.n * turn.transpose();
  EXPECT_NEAR(objective(*same, turned_state), f, 1e-11 * f);
  EXPECT_NEAR((constraint_values(*same, same->from_state(turned_state)) - c).norm(), 0.0, 1e-11);
}

// The energies as one sum of squares: f = |r|^2, grad f = 2 J^T r, and 2 J^T J is the Hessian without the
// residuals' own curvature.
TEST(Problem, ResidualsAgreeWithObjectiveGradientAndHessian) {
  std::map<std::string, double> weights;
  double weight = 0.3;
  for (const EnergyInfo& info : energy_catalogue()) weights[info.name] = weight += 0.7;
  for (const auto& [label, complex] : small_complexes()) {
    const auto problem = problem_of(complex, weights);
    const Vector z = problem->from_state(perturbed(*complex, 0.3));
    const SparsePattern& pattern = problem->residual_pattern();
    Vector residuals = Vector::Constant(problem->residuals(), 1e9);
    Vector slots = Vector::Constant(pattern.size(), 1e9);
    problem->residual_values(z.data(), residuals.data());
    problem->residual_jacobian(z.data(), slots.data());
    Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(problem->residuals(), problem->variables());
    for (int k = 0; k < pattern.size(); ++k) slopes(pattern.rows[k], pattern.columns[k]) += slots[k];

    const double f = problem->objective(z.data());
    EXPECT_GT(f, 0.1) << label;
    EXPECT_NEAR(residuals.squaredNorm(), f, 1e-12 * f) << label;
    const Vector slope = gradient(*problem, z);
    EXPECT_NEAR((2.0 * slopes.transpose() * residuals - slope).norm(), 0.0, 1e-12 * slope.norm()) << label;

    Vector values = Vector::Constant(problem->hessian_pattern().size(), 1e9);
    problem->hessian_values(z.data(), 1.0, nullptr, values.data(), Curvature::GaussNewton);
    Eigen::MatrixXd lower = 2.0 * slopes.transpose() * slopes;
    const double size = lower.norm();
    lower.triangularView<Eigen::StrictlyUpper>().setZero();
    for (int k = 0; k < values.size(); ++k)
      lower(problem->hessian_pattern().rows[k], problem->hessian_pattern().columns[k]) -= values[k];
    EXPECT_NEAR(lower.norm(), 0.0, 1e-12 * size) << label;

    // The Jacobian is that of the residuals themselves.
    for (int v = 0; v < problem->variables(); v += 7) {
      Vector up = z, down = z, r_up(problem->residuals()), r_down(problem->residuals());
      up[v] += 1e-5;
      down[v] -= 1e-5;
      problem->residual_values(up.data(), r_up.data());
      problem->residual_values(down.data(), r_down.data());
      EXPECT_NEAR(((r_up - r_down) / 2e-5 - slopes.col(v)).cwiseAbs().maxCoeff(), 0.0, 1e-7)
          << label << " " << v;
    }
  }
}

TEST(Problem, PatternsHaveNoEntryTwiceAndEveryDiagonal) {
  for (const auto& [label, complex] : small_complexes()) {
    const auto problem = problem_of(complex, {{"position", 1.0}, {"fairing", 1.0}});
    std::set<std::pair<int, int>> seen;
    const SparsePattern& hessian_pattern = problem->hessian_pattern();
    for (int k = 0; k < hessian_pattern.size(); ++k) {
      EXPECT_GE(hessian_pattern.rows[k], hessian_pattern.columns[k]);
      EXPECT_TRUE(seen.insert({hessian_pattern.rows[k], hessian_pattern.columns[k]}).second) << label;
    }
    ASSERT_EQ(static_cast<int>(problem->hessian_diagonal().size()), problem->variables());
    for (int v = 0; v < problem->variables(); ++v) {
      EXPECT_EQ(hessian_pattern.rows[problem->hessian_diagonal()[v]], v);
      EXPECT_EQ(hessian_pattern.columns[problem->hessian_diagonal()[v]], v);
    }
    seen.clear();
    const SparsePattern& jacobian_pattern = problem->jacobian_pattern();
    for (int k = 0; k < jacobian_pattern.size(); ++k)
      EXPECT_TRUE(seen.insert({jacobian_pattern.rows[k], jacobian_pattern.columns[k]}).second) << label;
  }
}

// The energies are sums of squares: their Hessian alone is positive semidefinite.
TEST(Problem, EnergyHessianIsPositiveSemidefinite) {
  const auto problem =
      problem_of(planarize_of(twisted_grid(2, 2).mesh()), {{"position", 0.1}, {"fairing", 1.0}});
  const Vector z = problem->from_state(perturbed(problem->complex(), 0.3));
  const Eigen::MatrixXd lower = hessian(*problem, z, 1.0, Vector::Zero(problem->rows()));
  const int points = 3 * problem->layout().points;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(lower.topLeftCorner(points, points));
  EXPECT_GE(solver.eigenvalues().minCoeff(), 0.2 - 1e-12);  // 2 w of the position energy
  EXPECT_EQ(lower.bottomRows(problem->variables() - points).norm(), 0.0);
}

TEST(Problem, HessianIsLinearInFactorAndMultipliers) {
  const auto problem = problem_of(dual_of(fan(5).mesh()), {{"position", 1.0}, {"fairing", 1.0}});
  const Vector z = problem->from_state(perturbed(problem->complex(), 0.3));
  Vector multipliers(problem->rows());
  for (int r = 0; r < problem->rows(); ++r) multipliers[r] = std::cos(3.0 * r);
  const Vector none = Vector::Zero(problem->rows());
  const Eigen::MatrixXd both = hessian(*problem, z, 2.0, -3.0 * multipliers);
  const Eigen::MatrixXd sum =
      2.0 * hessian(*problem, z, 1.0, none) - 3.0 * hessian(*problem, z, 0.0, multipliers);
  EXPECT_NEAR((both - sum).norm(), 0.0, 1e-12);
}

TEST(Problem, FirstOrderResidualIsTheLargestFreeSlope) {
  const SharedComplex complex = planarize_of(grid(2, 1).mesh());
  for (const Freedom freedom : {Freedom::NormalsAndOffsets, Freedom::Normals}) {
    const auto problem = problem_of(complex, {{"position", 1.0}}, freedom);
    State state = initial_state(*complex);
    state.x(0, 0) += 0.125;
    const Vector z = problem->from_state(state);
    Vector multipliers = Vector::Zero(problem->rows());
    EXPECT_DOUBLE_EQ(problem->first_order_residual(z.data(), multipliers.data()), 0.25);
    // A multiplier on the first incidence pushes h_0 by -m, x_0 by m n, n_0 by m (x - v).
    multipliers[0] = 10.0;
    EXPECT_DOUBLE_EQ(problem->first_order_residual(z.data(), multipliers.data()), 10.0);
    const Vector slope = gradient(*problem, z) + jacobian(*problem, z).transpose() * multipliers;
    double largest = 0.0;
    for (int v = 0; v < problem->variables(); ++v)
      if (problem->layout().is_free(v)) largest = std::max(largest, std::abs(slope[v]));
    EXPECT_DOUBLE_EQ(problem->first_order_residual(z.data(), multipliers.data()), largest);
  }
}

TEST(Problem, IsIndependentOfTheCallersComplexPointer) {
  SharedComplex complex = planarize_of(twisted_grid(2, 2).mesh());
  const auto problem = problem_of(complex, {{"position", 1.0}, {"fairing", 1.0}});
  const State state = perturbed(*complex, 0.2);
  const double before = objective(*problem, state);
  complex.reset();
  EXPECT_EQ(objective(*problem, state), before);
}

}  // namespace
}  // namespace planewright
