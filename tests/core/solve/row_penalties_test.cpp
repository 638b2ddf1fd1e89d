#include "core/solve/row_penalties.h"

#include <gtest/gtest.h>

#include "support/demands.h"

namespace planewright {
namespace {

using namespace test;

// Equations, lower and upper bounds, bands and alternatives of quads.
ProblemSettings every_kind_of_row() {
  ProblemSettings settings = demanding(
      {demand("uncrossed"), demand("height-band", {-0.4, 0.3}), demand("offset-band", {-kUnbounded, 0.2})});
  settings.demands.pins = {{{PointKind::Vertex, 5}, {1.0, {}, 0.2}}};
  return settings;
}

class RowPenaltiesTest : public testing::Test {
 protected:
  void SetUp() override {
    rows.choose_alternatives(z);
    rows.multipliers = multipliers;
  }

  SharedComplex complex = planarize_of(twisted_grid(4, 3, 0.15).mesh());
  SharedProblem problem = Problem::create(complex, every_kind_of_row()).value();
  Vector z = problem->from_state(perturbed(*complex, 0.2));
  Vector values = constraint_values(*problem, z);
  Vector multipliers = Vector::NullaryExpr(
      problem->rows(), [](Eigen::Index r) { return 2.0 * std::sin(2.3 * static_cast<double>(r)); });
  RowPenalties rows{*problem};
};

// The formula of the header for one row, by hand.
double term(const Bounds& bounds, double c, double y, double rho) {
  const double t = c + y / rho;
  const double miss = t < bounds.low ? bounds.low - t : t > bounds.high ? t - bounds.high : 0.0;
  return 0.5 * rho * miss * miss;
}

TEST_F(RowPenaltiesTest, ValueIsTheSumOverTheRowsThatCount) {
  const auto [first, last] = problem->unit_normal_rows();
  const std::vector<char> waived = problem->waived_at(z.data());
  for (const double rho : {3.0, 200.0}) {
    double expected = 0.0;
    int counted = 0, resting = 0;
    for (int r = 0; r < problem->rows(); ++r) {
      const bool counts = !(r >= first && r < last) && !waived[static_cast<size_t>(r)];
      EXPECT_EQ(rows.counts(r), counts) << r;
      if (!counts) continue;
      const double one = term(problem->bounds(r), values[r], multipliers[r], rho);
      ++counted;
      resting += one == 0.0;
      expected += one;
    }
    EXPECT_GT(resting, 10);
    EXPECT_GT(counted, resting + 40);
    EXPECT_NEAR(rows.value(values, multipliers, rho), expected, 1e-12 * expected);
  }
}

// y c + rho/2 c^2, up to a constant.
TEST_F(RowPenaltiesTest, AnEquationGetsItsMultiplierAndItsSquare) {
  const double rho = 7.0;
  const Vector none = Vector::Zero(problem->rows());
  double linear = 0.0, squares = 0.0, constant = 0.0;
  for (int r = 0; r < problem->planarity_rows(); ++r) {
    ASSERT_TRUE(rows.is_equation(r));
    linear += multipliers[r] * values[r];
    squares += 0.5 * rho * values[r] * values[r];
    constant += 0.5 * multipliers[r] * multipliers[r] / rho;
  }
  const auto plain = problem_of(complex, {{"position", 1.0}});
  const RowPenalties equations(*plain);
  const auto head = [&](const Vector& v) { return Vector(v.head(plain->rows())); };
  EXPECT_NEAR(equations.value(head(values), head(none), rho), squares, 1e-12);
  EXPECT_NEAR(equations.value(head(values), head(multipliers), rho), linear + squares + constant, 1e-11);
}

TEST_F(RowPenaltiesTest, SlopesAreThoseOfTheValue) {
  const double rho = 20.0, step = 1e-6;
  std::vector<double> slopes;
  rows.slopes(values, multipliers, rho, slopes);
  ASSERT_EQ(static_cast<int>(slopes.size()), problem->rows());
  int pulling = 0;
  for (int r = 0; r < problem->rows(); ++r) {
    const Vector d = step * Vector::Unit(problem->rows(), r);
    const double difference =
        (rows.value(values + d, multipliers, rho) - rows.value(values - d, multipliers, rho)) / (2.0 * step);
    EXPECT_NEAR(slopes[static_cast<size_t>(r)], difference, 1e-6) << r;
    pulling += slopes[static_cast<size_t>(r)] != 0.0;
  }
  EXPECT_GT(pulling, 50);
  EXPECT_LT(pulling, problem->rows() - 10);
}

// Equations and inequalities with penalties of their own, against differences of each kind's value.
TEST_F(RowPenaltiesTest, LinearisesWithItsOwnPenaltiesAndMultipliers) {
  rows.equations = 50.0;
  rows.inequalities = 8.0;
  std::vector<double> weights, slopes;
  rows.linearise(values, weights, slopes);
  const double step = 1e-5;
  int of_equations = 0, of_inequalities = 0, at_rest = 0;
  for (int r = 0; r < problem->rows(); ++r) {
    const double rho = rows.penalty(r);
    EXPECT_EQ(rho, rows.is_equation(r) ? 50.0 : 8.0);
    const Vector d = step * Vector::Unit(problem->rows(), r);
    std::vector<double> up, down, here;
    rows.slopes(values, multipliers, rho, here);
    rows.slopes(values + d, multipliers, rho, up);
    rows.slopes(values - d, multipliers, rho, down);
    const auto k = static_cast<size_t>(r);
    EXPECT_NEAR(slopes[k], here[k], 1e-12) << r;
    EXPECT_NEAR(weights[k], (up[k] - down[k]) / (2.0 * step), 1e-6) << r;
    of_equations += weights[k] == 50.0;
    of_inequalities += weights[k] == 8.0;
    at_rest += rows.counts(r) && weights[k] == 0.0;
  }
  EXPECT_GT(of_equations, 40);
  EXPECT_GT(of_inequalities, 5);
  EXPECT_GT(at_rest, 10);
}

// An equation that is met exactly still belongs to the matrix; an inequality in the middle of its band not.
TEST_F(RowPenaltiesTest, AnEquationThatIsMetKeepsItsWeight) {
  rows.multipliers.setZero();
  std::vector<double> weights, slopes;
  Vector met(problem->rows());
  for (int r = 0; r < met.size(); ++r) met[r] = rows.nearest(r, values[r]);
  rows.linearise(met, weights, slopes);
  EXPECT_EQ(rows.violation(met), 0.0);
  for (int r = 0; r < problem->rows(); ++r) {
    EXPECT_EQ(weights[static_cast<size_t>(r)] > 0.0, rows.counts(r) && rows.is_equation(r)) << r;
    EXPECT_EQ(slopes[static_cast<size_t>(r)], 0.0);
  }
}

TEST_F(RowPenaltiesTest, AMultiplierHoldsAnInequalityBeyondItsBound) {
  const int row = rows_of(*problem, "height-band").front();
  const Bounds bounds = problem->bounds(row);
  ASSERT_LT(bounds.low, bounds.high);
  const auto slope_of = [&](double c, double y) {
    Vector at = values, multiplier = Vector::Zero(problem->rows());
    at[row] = c;
    multiplier[row] = y;
    std::vector<double> slopes;
    rows.slopes(at, multiplier, 10.0, slopes);
    return slopes[static_cast<size_t>(row)];
  };
  const double middle = 0.5 * (bounds.low + bounds.high);
  EXPECT_EQ(slope_of(middle, 0.0), 0.0);
  EXPECT_NEAR(slope_of(bounds.low, -2.0), -2.0, 1e-12);  // pushes up from the lower bound
  EXPECT_NEAR(slope_of(bounds.high, 2.0), 2.0, 1e-12);   // and down from the upper one
  EXPECT_NEAR(slope_of(bounds.low - 0.1, -2.0), -3.0, 1e-12);
  EXPECT_NEAR(slope_of(bounds.low + 0.1, -2.0), -1.0, 1e-12);
  EXPECT_EQ(slope_of(bounds.low + 0.2001, -2.0), 0.0);  // lets go where there is room to spare
}

TEST_F(RowPenaltiesTest, ViolationIsTheLargestOfTheRowsThatCount) {
  double worst = 0.0;
  for (const auto& violated : problem->violated_rows(z.data(), 0.0))
    if (problem->row_name(violated.row) != "unit normal") worst = std::max(worst, violated.amount);
  ASSERT_GT(worst, 0.1);
  EXPECT_NEAR(rows.violation(values), worst, 1e-15);
  // Whatever a row that does not count says.
  Vector wild = values;
  int not_counted = 0;
  for (int r = 0; r < problem->rows(); ++r)
    if (!rows.counts(r)) {
      wild[r] = -50.0;
      ++not_counted;
    }
  EXPECT_GT(not_counted, complex->plane_count());
  EXPECT_NEAR(rows.violation(wild), worst, 1e-15);
  EXPECT_EQ(rows.value(wild, multipliers, 5.0), rows.value(values, multipliers, 5.0));
}

TEST_F(RowPenaltiesTest, AlternativesFollowTheState) {
  const std::vector<int> corners = rows_of(*problem, "uncrossed");
  const auto counted = [&] {
    std::vector<bool> out;
    for (const int r : corners) out.push_back(rows.counts(r));
    return out;
  };
  const auto before = counted();
  EXPECT_GT(std::count(before.begin(), before.end(), false), 0);
  for (const int r : corners) {
    EXPECT_EQ(rows.counts(r), problem->waived_at(z.data())[static_cast<size_t>(r)] == 0);
  }
  // Another state chooses other diagonals: rows come back, without the multipliers of before.
  const Vector other = problem->from_state(perturbed(*complex, 0.6, 9));
  rows.choose_alternatives(other);
  const auto after = counted();
  ASSERT_NE(before, after);
  for (size_t k = 0; k < corners.size(); ++k) {
    EXPECT_EQ(after[k], problem->waived_at(other.data())[static_cast<size_t>(corners[k])] == 0);
    const double y = rows.multipliers[corners[k]];
    EXPECT_EQ(y, after[k] ? multipliers[corners[k]] : 0.0);
  }
  const auto [first, last] = problem->unit_normal_rows();
  for (int r = first; r < last; ++r) EXPECT_EQ(rows.multipliers[r], 0.0);
}

// Rows that a designer gave up keep their place and pull at nothing.
TEST(RowPenalties, WaivedRowsAddNothing) {
  const SharedComplex complex = planarize_of(twisted_grid(4, 3, 0.15).mesh());
  ProblemSettings settings = demanding({demand("height-band", {0.3, 0.4})});
  const auto strict = Problem::create(complex, settings).value();
  const ElementRef point{ElementKind::Point, 7};
  settings.demands.waived = {{"height-band", point}};
  const auto relaxed = Problem::create(complex, settings).value();
  ASSERT_EQ(strict->rows(), relaxed->rows());
  const int row = rows_of(*relaxed, "height-band", point).front();
  const Vector z = strict->from_state(perturbed(*complex, 0.05));
  const Vector values = constraint_values(*strict, z), none = Vector::Zero(strict->rows());
  const RowPenalties all(*strict), but_one(*relaxed);
  const double miss = std::abs(values[row] - all.nearest(row, values[row]));
  ASSERT_GT(miss, 0.1);
  EXPECT_NEAR(all.value(values, none, 4.0) - but_one.value(values, none, 4.0), 2.0 * miss * miss, 1e-12);
  std::vector<double> weights, slopes;
  but_one.linearise(values, weights, slopes);
  EXPECT_EQ(weights[static_cast<size_t>(row)], 0.0);
  EXPECT_EQ(slopes[static_cast<size_t>(row)], 0.0);
  all.linearise(values, weights, slopes);
  EXPECT_EQ(weights[static_cast<size_t>(row)], all.inequalities);
  EXPECT_NEAR(slopes[static_cast<size_t>(row)], -all.inequalities * miss, 1e-10);
}

}  // namespace
}  // namespace planewright
