#include "core/solve/tangent_pattern.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "support/problems.h"

namespace planewright {
namespace {

using namespace test;

constexpr Freedom kFreedoms[] = {Freedom::Fixed, Freedom::Normals, Freedom::NormalsAndOffsets};

// Energies that couple no points, and some that do.
const std::map<std::string, double> kAlone{{"position", 1.0}, {"normal-smoothness", 0.5}, {"offset", 0.2}};
const std::map<std::string, double> kCoupled{{"position", 1.0}, {"fairing", 0.3}, {"edge-length", 0.1}};

// The same answers from sets of pairs: slow and obvious.
struct Expected {
  std::vector<std::set<int>> neighbours;     // #nodes
  std::set<int> eliminated;                  // nodes
  std::set<std::pair<int, int>> kept_pairs;  // nodes, the later one first

  Expected(const Problem& problem, const TangentPattern& pattern, EnergyCoupling coupling)
      : neighbours(static_cast<size_t>(pattern.nodes())) {
    const int points = pattern.points();
    const auto [first_unit, last_unit] = problem.unit_normal_rows();
    const auto read = [&](const SparsePattern& rows, bool energies) {
      std::map<int, std::set<int>> nodes_of_row;
      for (int k = 0; k < rows.size(); ++k)
        if (energies || rows.rows[k] < first_unit || rows.rows[k] >= last_unit)
          nodes_of_row[rows.rows[k]].insert(pattern.node_of(rows.columns[k]));
      for (const auto& [row, nodes] : nodes_of_row)
        for (const int a : nodes)
          for (const int b : nodes) {
            if (a == b || (energies && coupling == EnergyCoupling::Dropped && a < points && b < points))
              continue;
            neighbours[static_cast<size_t>(a)].insert(b);
          }
    };
    read(problem.residual_pattern(), true);
    read(problem.jacobian_pattern(), false);
    for (int j = 0; j < points; ++j) {
      const std::set<int>& met = neighbours[static_cast<size_t>(j)];
      const bool alone = met.empty() || *met.begin() >= points;
      if (alone && static_cast<int>(met.size()) <= TangentPattern::kMostCouplings) eliminated.insert(j);
    }
    for (int a = 0; a < pattern.nodes(); ++a) {
      if (eliminated.contains(a)) continue;
      kept_pairs.insert({a, a});
      for (const int b : neighbours[static_cast<size_t>(a)])
        if (b < a && !eliminated.contains(b)) kept_pairs.insert({a, b});
    }
    for (const int e : eliminated)
      for (const int a : neighbours[static_cast<size_t>(e)])
        for (const int b : neighbours[static_cast<size_t>(e)])
          if (b < a) kept_pairs.insert({a, b});
  }
};

void expect_right(const Problem& problem, EnergyCoupling coupling, const std::string& what) {
  SCOPED_TRACE(what);
  const TangentPattern pattern(problem, coupling);
  const Expected expected(problem, pattern, coupling);
  ASSERT_EQ(pattern.nodes(), problem.layout().points + problem.layout().planes);
  ASSERT_EQ(pattern.kept() + pattern.eliminated(), pattern.nodes());
  EXPECT_TRUE(std::ranges::equal(pattern.eliminated_points(), expected.eliminated));
  EXPECT_TRUE(std::ranges::is_sorted(pattern.kept_nodes()));

  std::set<std::pair<int, int>> kept_pairs;
  for (int b = 0; b < pattern.kept_blocks(); ++b) {
    const auto [later, earlier] = pattern.kept_pair(b);
    kept_pairs.insert({pattern.kept_nodes()[static_cast<size_t>(later)],
                       pattern.kept_nodes()[static_cast<size_t>(earlier)]});
  }
  EXPECT_EQ(kept_pairs, expected.kept_pairs);
  EXPECT_EQ(static_cast<int>(kept_pairs.size()), pattern.kept_blocks());  // none twice

  size_t fill = 0;
  for (int e = 0; e < pattern.eliminated(); ++e) {
    std::vector<int> coupled;
    for (int c = pattern.first_coupling(e); c < pattern.first_coupling(e + 1); ++c)
      coupled.push_back(pattern.kept_nodes()[static_cast<size_t>(pattern.coupled_kept(c))]);
    const int node = pattern.eliminated_points()[static_cast<size_t>(e)];
    EXPECT_TRUE(std::ranges::equal(coupled, expected.neighbours[static_cast<size_t>(node)]))
        << "point " << node;
    for (size_t a = 0; a < coupled.size(); ++a)
      for (size_t b = 0; b <= a; ++b, ++fill) {
        ASSERT_LT(fill, pattern.fill().size());
        bool transposed;
        EXPECT_EQ(pattern.fill()[fill], pattern.find_block(coupled[a], coupled[b], transposed));
      }
  }
  EXPECT_EQ(fill, pattern.fill().size());

  // Every block is of one pair of nodes, and found from either side.
  std::set<int> found;
  for (int a = 0; a < pattern.nodes(); ++a)
    for (int b = 0; b <= a; ++b) {
      const bool is_kept = expected.kept_pairs.contains({a, b});
      const bool is_own = a == b;
      const bool is_coupling =
          expected.eliminated.contains(b) && expected.neighbours[static_cast<size_t>(b)].contains(a);
      bool transposed;
      const int block = pattern.find_block(a, b, transposed);
      EXPECT_FALSE(transposed);
      ASSERT_EQ(block >= 0, is_kept || is_own || is_coupling) << a << " and " << b;
      EXPECT_EQ(pattern.find_block(b, a, transposed), block);
      EXPECT_EQ(transposed, a != b);
      if (block < 0) continue;
      EXPECT_TRUE(found.insert(block).second) << "block " << block << " twice";
      EXPECT_EQ(block < pattern.kept_blocks(), is_kept);
      if (is_own) {
        EXPECT_EQ(pattern.diagonal_block()[static_cast<size_t>(a)], block);
      }
    }
  EXPECT_EQ(static_cast<int>(found.size()), pattern.blocks());
  EXPECT_TRUE(found.empty() || *found.rbegin() == pattern.blocks() - 1);

  // Normals are kept unit by the way they are moved: those rows touch nothing.
  const auto [first_unit, last_unit] = problem.unit_normal_rows();
  for (int row = 0; row < problem.rows(); ++row)
    EXPECT_EQ(pattern.constraints().nodes[row].empty(), row >= first_unit && row < last_unit) << row;

  // What the rows' pairs and slots point at.
  for (const auto* set : {&pattern.energies(), &pattern.constraints()}) {
    size_t pair = 0;
    ASSERT_EQ(static_cast<int>(set->first_slot.size()), set->rows + 1);
    for (int row = 0; row < set->rows; ++row) {
      EXPECT_EQ(set->first_pair[static_cast<size_t>(row)], pair);
      const auto nodes = set->nodes[row];
      const int first = set->nodes.offsets()[static_cast<size_t>(row)];
      for (int s = set->first_slot[static_cast<size_t>(row)];
           s < set->first_slot[static_cast<size_t>(row) + 1]; ++s) {
        EXPECT_EQ(set->pattern.rows[static_cast<size_t>(s)], row);
        const int place = set->place[static_cast<size_t>(s)];
        if (nodes.empty()) {
          EXPECT_EQ(place, -1);
        } else {
          EXPECT_EQ(nodes[static_cast<size_t>(place - first)],
                    pattern.node_of(set->pattern.columns[static_cast<size_t>(s)]));
        }
      }
      for (size_t a = 0; a < nodes.size(); ++a)
        for (size_t b = 0; b <= a; ++b, ++pair) {
          const bool dropped = set == &pattern.energies() && coupling == EnergyCoupling::Dropped && a != b &&
                               nodes[a] < pattern.points();
          bool transposed;
          const int block = pattern.find_block(nodes[a], nodes[b], transposed);
          EXPECT_EQ(set->pair_block[pair], dropped ? -1 : block);
          if (!dropped) {
            EXPECT_GE(block, 0);
          }
        }
    }
    EXPECT_EQ(set->first_pair.back(), pair);
    EXPECT_EQ(set->pair_block.size(), pair);
  }
}

TEST(TangentPattern, IsThatOfTheRowsOfEveryFreedomAndComplex) {
  int fixed = 0;
  for (const auto& [label, complex] : small_complexes())
    for (const Freedom freedom : kFreedoms)
      for (const auto& weights : {kAlone, kCoupled}) {
        const auto problem = Problem::create(complex, {freedom, weights});
        if (!problem) continue;  // planes without a common point cannot be fixed
        fixed += freedom == Freedom::Fixed;
        for (const EnergyCoupling coupling : {EnergyCoupling::Exact, EnergyCoupling::Dropped})
          expect_right(**problem, coupling,
                       label + ", freedom " + std::to_string(static_cast<int>(freedom)) +
                           (weights == kAlone ? ", alone" : ", coupled") +
                           (coupling == EnergyCoupling::Exact ? ", exact" : ", dropped"));
      }
  EXPECT_GT(fixed, 4);
}

TEST(TangentPattern, IsThatOfDemandsWhichCouplePoints) {
  ProblemSettings settings{Freedom::NormalsAndOffsets, kAlone};
  settings.demands.list = {{"vertex"}, {"face"}, {"edge"}};
  expect_right(*Problem::create(dual_of(domed_triangle_grid(4, 3).mesh(), {0.2}), settings).value(),
               EnergyCoupling::Dropped, "in front");
  settings.demands.list = {{"star"}, {"uncrossed"}};
  expect_right(*Problem::create(planarize_of(twisted_grid(3, 2).mesh()), settings).value(),
               EnergyCoupling::Dropped, "shapes");
}

TEST(TangentPattern, EliminatesPointsThatNoRowCouples) {
  const SharedComplex complex = dual_of(domed_triangle_grid(4, 3).mesh());
  const int points = complex->point_count(), planes = complex->plane_count();
  for (const Freedom freedom : {Freedom::Normals, Freedom::NormalsAndOffsets}) {
    const TangentPattern alone(*problem_of(complex, {{"position", 1.0}}, freedom), EnergyCoupling::Exact);
    EXPECT_EQ(alone.eliminated(), points);
    EXPECT_EQ(alone.kept(), planes);
    EXPECT_EQ(alone.couplings(), complex->incidence_count());
    EXPECT_FALSE(alone.incomplete());

    const auto fair = problem_of(complex, {{"position", 1.0}, {"fairing", 1.0}}, freedom);
    const TangentPattern exact(*fair, EnergyCoupling::Exact), dropped(*fair, EnergyCoupling::Dropped);
    EXPECT_EQ(exact.eliminated(), 0);
    EXPECT_EQ(exact.kept(), points + planes);
    EXPECT_FALSE(exact.incomplete());
    EXPECT_EQ(dropped.eliminated(), points);
    EXPECT_EQ(dropped.kept_blocks(), alone.kept_blocks());
    EXPECT_TRUE(dropped.incomplete());
  }
  const SharedComplex fixable = dual_of(domed_triangle_grid(6, 5).mesh());
  const TangentPattern fixed(*problem_of(fixable, {{"position", 1.0}}, Freedom::Fixed),
                             EnergyCoupling::Exact);
  EXPECT_EQ(fixed.eliminated(), fixable->point_count());
  EXPECT_EQ(fixed.couplings(), 0);
  EXPECT_EQ(fixed.kept_blocks(), fixable->plane_count());  // their own blocks alone
}

TEST(TangentPattern, KeepsPointsOfVeryHighValence) {
  for (const int valence : {2, 3, TangentPattern::kMostCouplings, TangentPattern::kMostCouplings + 1, 30}) {
    // Two triangles at the hub are an open fan.
    const Shape shape = valence == 2 ? fan(3, true) : fan(valence);
    const auto problem = problem_of(planarize_of(shape.mesh()), {{"position", 1.0}});
    const TangentPattern pattern(*problem, EnergyCoupling::Exact);
    const bool keeps_hub = valence > TangentPattern::kMostCouplings;
    EXPECT_EQ(pattern.eliminated(), problem->layout().points - (keeps_hub ? 1 : 0)) << valence;
    EXPECT_EQ(pattern.kept_nodes().front() == 0, keeps_hub) << valence;
    if (!keeps_hub) {
      EXPECT_EQ(pattern.first_coupling(1), valence);
      EXPECT_EQ(pattern.kept_blocks(), valence * (valence + 1) / 2);
    }
    expect_right(*problem, EnergyCoupling::Exact, "valence " + std::to_string(valence));
  }
}

TEST(TangentPattern, PinsAddRowsWithoutBlocks) {
  const SharedComplex complex = planarize_of(twisted_grid(3, 2).mesh());
  ProblemSettings settings;
  const TangentPattern without(*Problem::create(complex, settings).value(), EnergyCoupling::Exact);
  settings.demands.pins = {{{PointKind::Vertex, 5}, {1.0, {}, 0.2}}};
  settings.demands.plane_pins = {{3, {}}};
  const auto problem = Problem::create(complex, settings).value();
  expect_right(*problem, EnergyCoupling::Exact, "pinned");
  const TangentPattern pinned(*problem, EnergyCoupling::Exact);
  EXPECT_EQ(pinned.blocks(), without.blocks());
  EXPECT_EQ(pinned.eliminated(), without.eliminated());
  int of_point = 0, of_plane = 0;
  for (int row = 0; row < problem->rows(); ++row) {
    if (problem->row_name(row) != "pin" && problem->row_name(row) != "plane pin") continue;
    const auto nodes = pinned.constraints().nodes[row];
    ASSERT_EQ(nodes.size(), 1u);
    of_point += nodes[0] == 5;
    of_plane += nodes[0] == pinned.points() + 3;
  }
  EXPECT_EQ(of_point, 2);
  EXPECT_EQ(of_plane, 3);
}

TEST(TangentPattern, SeparateComponentsShareNoBlock) {
  const Shape one = twisted_grid(2, 2);
  Shape two = one;
  const auto count = static_cast<int>(one.positions.rows());
  two.positions.conservativeResize(2 * count, 3);
  two.positions.bottomRows(count) = one.positions.rowwise() + Eigen::RowVector3d(10, 0, 0);
  for (int f = 0; f < one.faces.size(); ++f) {
    std::vector<int> face(one.faces[f].begin(), one.faces[f].end());
    for (int& v : face) v += count;
    two.faces.push_back(face);
  }
  for (const EnergyCoupling coupling : {EnergyCoupling::Exact, EnergyCoupling::Dropped}) {
    const auto single = problem_of(planarize_of(one.mesh()), kCoupled);
    const auto both = problem_of(planarize_of(two.mesh()), kCoupled);
    expect_right(*both, coupling, "two components");
    const TangentPattern pattern(*both, coupling);
    EXPECT_EQ(pattern.blocks(), 2 * TangentPattern(*single, coupling).blocks());
    const auto component = [&](int node) {
      return node < pattern.points() ? node / count : (node - pattern.points()) / one.faces.size();
    };
    for (int a = 0; a < pattern.nodes(); ++a)
      for (int b = 0; b < pattern.nodes(); ++b) {
        bool transposed;
        if (component(a) != component(b)) {
          EXPECT_EQ(pattern.find_block(a, b, transposed), -1);
        }
      }
  }
}

TEST(TangentPattern, KnowsTheNodeOfEveryVariable) {
  const auto problem = problem_of(dual_of(fan(6, true).mesh()), {{"position", 1.0}});
  const TangentPattern pattern(*problem, EnergyCoupling::Exact);
  const Layout& layout = problem->layout();
  for (int axis = 0; axis < 3; ++axis) {
    for (int j = 0; j < layout.points; ++j) EXPECT_EQ(pattern.node_of(layout.x(j, axis)), j);
    for (int i = 0; i < layout.planes; ++i) EXPECT_EQ(pattern.node_of(layout.n(i, axis)), layout.points + i);
  }
  for (int i = 0; i < layout.planes; ++i) EXPECT_EQ(pattern.node_of(layout.h(i)), layout.points + i);
}

TEST(TangentPattern, FitsProblemsOfTheSameRowsAlone) {
  const auto problem = problem_of(planarize_of(grid(3, 3).mesh()), kCoupled);
  const TangentPattern pattern(*problem, EnergyCoupling::Exact);
  EXPECT_TRUE(pattern.fits(*problem, EnergyCoupling::Exact));
  EXPECT_FALSE(pattern.fits(*problem, EnergyCoupling::Dropped));
  // Other places and weights do not matter.
  auto weights = kCoupled;
  weights["fairing"] = 7.0;
  EXPECT_TRUE(
      pattern.fits(*problem_of(planarize_of(twisted_grid(3, 3).mesh()), weights), EnergyCoupling::Exact));
  // One energy less, one demand more, another mesh of the same numbers do.
  EXPECT_FALSE(pattern.fits(*problem_of(planarize_of(grid(3, 3).mesh()), kAlone), EnergyCoupling::Exact));
  ProblemSettings pinned{Freedom::NormalsAndOffsets, kCoupled};
  pinned.demands.pins = {{{PointKind::Vertex, 5}, {1.0, {}, {}}}};
  EXPECT_FALSE(
      pattern.fits(*Problem::create(planarize_of(grid(3, 3).mesh()), pinned).value(), EnergyCoupling::Exact));
  Shape renumbered = grid(3, 3);
  renumbered.faces = {};
  const Shape original = grid(3, 3);
  for (int f = original.faces.size(); f-- > 0;) renumbered.faces.push_back(original.faces[f]);
  EXPECT_FALSE(pattern.fits(*problem_of(planarize_of(renumbered.mesh()), kCoupled), EnergyCoupling::Exact));
}

}  // namespace
}  // namespace planewright
