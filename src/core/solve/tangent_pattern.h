// TangentPattern: which 3 x 3 blocks the linear system of a tangent step has, and which of its points are
// eliminated before the sparse factorisation (design notes, vtpi.md section 7). Depends on stencils alone:
// made once per topology and kept between solves. Internal to solve/.
//
// Nodes: points 0..X-1, then planes X..X+P-1, three unknowns each. A point that no row couples with another
// point is eliminated in closed form (a 3 x 3 block of its own), which leaves a system on the planes; other
// points, and points with more than kMostCouplings neighbours, whose elimination would fill the matrix, stay
// in it as kept nodes. Nodes outside a local problem's patch (Layout::outside) have no blocks.
//
// Block storage, in this order: kept blocks (pairs of kept nodes, sorted, the reduced matrix), the eliminated
// points' own blocks, couplings of an eliminated point with a kept node (rows: the kept node's). Every block
// is row-major; "later" nodes are rows. Threads: plain data, immutable once made.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/geometry.h"
#include "core/problem/problem.h"

namespace planewright {

// What becomes of the coupling of points by energies (fairing, lengths, directions).
enum class EnergyCoupling {
  Exact,    // its blocks are part of the matrix
  Dropped,  // left out, so that these points can be eliminated too: a preconditioner, or a projection's
            // matrix
};

class TangentPattern {
 public:
  TangentPattern(const Problem& problem, EnergyCoupling coupling);

  // Whether it is the pattern of this problem too. Where no energy couples points, both couplings are the
  // same.
  bool fits(const Problem& problem, EnergyCoupling coupling) const;
  // Whether energies couple points and those couplings are missing.
  bool incomplete() const { return coupling_ == EnergyCoupling::Dropped && energies_couple_; }

  // The rows of one kind (residuals or constraints): which nodes each touches.
  struct RowSet {
    SparsePattern pattern;  // of its Jacobian, as the problem has it
    int rows = 0;
    std::vector<int> first_slot;     // #rows + 1, into the pattern
    Polygons nodes;                  // #rows lists of nodes, ascending; none for unit-normal rows
    std::vector<int> place;          // per pattern slot: index of its node within all lists, or -1
    std::vector<size_t> first_pair;  // #rows + 1, into pair_block
    std::vector<int> pair_block;     // per pair of nodes (later, earlier or same) of a row: its block, or -1
  };
  const RowSet& energies() const { return energies_; }
  const RowSet& constraints() const { return constraints_; }

  int points() const { return points_; }
  int planes() const { return planes_; }
  int nodes() const { return points_ + planes_; }
  int node_of(int variable) const { return layout_.node_of(variable); }

  int kept() const { return static_cast<int>(kept_nodes_.size()); }
  int eliminated() const { return static_cast<int>(eliminated_points_.size()); }
  int kept_blocks() const { return static_cast<int>(kept_keys_.size()); }
  int blocks() const { return kept_blocks() + eliminated() + couplings(); }
  int couplings() const { return static_cast<int>(coupled_kept_.size()); }

  const std::vector<int>& kept_nodes() const { return kept_nodes_; }                // node of each
  const std::vector<int>& eliminated_points() const { return eliminated_points_; }  // node of each
  const std::vector<int>& diagonal_block() const { return diagonal_block_; }        // #nodes; -1: outside
  int first_coupling(int e) const { return first_coupling_[static_cast<size_t>(e)]; }
  int coupled_kept(int coupling) const { return coupled_kept_[static_cast<size_t>(coupling)]; }
  int coupling_block(int coupling) const { return kept_blocks() + eliminated() + coupling; }
  // Kept blocks that the elimination of a point changes: its couplings' pairs (a, b <= a), points in order.
  const std::vector<int>& fill() const { return fill_; }
  // Row and column (kept nodes) of a kept block.
  std::pair<int, int> kept_pair(int block) const {
    const std::uint64_t key = kept_keys_[static_cast<size_t>(block)];
    return {static_cast<int>(key >> 32), static_cast<int>(key & 0xffffffffu)};
  }
  // The block of two nodes, or -1; transposed tells whether `a` stands for its columns.
  int find_block(int a, int b, bool& transposed) const;

  // Points with more neighbours than this are not eliminated.
  static constexpr int kMostCouplings = 12;

 private:
  void read_rows(RowSet& set, const SparsePattern& pattern, int rows, std::pair<int, int> skipped);
  void choose_eliminated();
  void find_couplings();
  void find_kept_blocks();
  void assign_pairs();
  int kept_block(int later, int earlier) const;
  int coupling_of(int point, int kept) const;  // -1: none
  // Calls visit(set, later node, earlier node) for every pair of nodes of every row.
  template <class Visit>
  void for_each_pair(Visit visit) const;
  bool couples_points(const RowSet& set, int later, int earlier) const {
    return &set == &energies_ && later < points_ && later != earlier;
  }
  bool drops(const RowSet& set, int later, int earlier) const {
    return coupling_ == EnergyCoupling::Dropped && couples_points(set, later, earlier);
  }

  EnergyCoupling coupling_;
  Layout layout_;
  int points_, planes_;
  bool energies_couple_ = false;  // points
  RowSet energies_, constraints_;
  std::vector<int>
      kept_index_;  // #nodes: place among kept nodes, -1 - place among eliminated ones, or kNowhere
  std::vector<int> kept_nodes_, eliminated_points_;
  std::vector<int> first_coupling_, coupled_kept_;
  std::vector<std::uint64_t> kept_keys_;
  std::vector<int> diagonal_block_, fill_;
};

}  // namespace planewright
