#include "core/solve/tangent_pattern.h"

#include <algorithm>
#include <limits>

namespace planewright {
namespace {

std::uint64_t key(int later, int earlier) {
  return static_cast<std::uint64_t>(later) << 32 | static_cast<std::uint32_t>(earlier);
}

constexpr int kNowhere = std::numeric_limits<int>::min();  // of kept_index_: outside

void sort_unique(std::vector<std::uint64_t>& keys) {
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
}

}  // namespace

TangentPattern::TangentPattern(const Problem& problem, EnergyCoupling coupling)
    : coupling_(coupling), layout_(problem.layout()), points_(layout_.points), planes_(layout_.planes) {
  read_rows(energies_, problem.residual_pattern(), problem.residuals(), {0, 0});
  read_rows(constraints_, problem.jacobian_pattern(), problem.rows(), problem.unit_normal_rows());
  choose_eliminated();
  find_couplings();
  find_kept_blocks();
  assign_pairs();
}

bool TangentPattern::fits(const Problem& problem, EnergyCoupling coupling) const {
  const auto same = [](const SparsePattern& a, const SparsePattern& b) {
    return a.columns == b.columns && a.rows == b.rows;
  };
  return (coupling == coupling_ || !energies_couple_) && points_ == problem.layout().points &&
         planes_ == problem.layout().planes && layout_.outside == problem.layout().outside &&
         same(energies_.pattern, problem.residual_pattern()) &&
         same(constraints_.pattern, problem.jacobian_pattern());
}

void TangentPattern::read_rows(RowSet& set, const SparsePattern& pattern, int rows,
                               std::pair<int, int> skipped) {
  set.pattern = pattern;
  set.rows = rows;
  set.place.resize(static_cast<size_t>(pattern.size()));
  set.first_slot.reserve(static_cast<size_t>(rows) + 1);
  std::vector<int> nodes;
  for (int row = 0, slot = 0; row < rows; ++row) {
    const int begin = slot;
    set.first_slot.push_back(begin);
    nodes.clear();
    while (slot < pattern.size() && pattern.rows[slot] == row) {
      const int node = node_of(pattern.columns[slot++]);
      if (nodes.empty() || nodes.back() != node) nodes.push_back(node);
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    // Unit length is kept by the way normals are moved: such a row has no nodes, and its slots go nowhere.
    const bool skip = row >= skipped.first && row < skipped.second;
    if (skip) nodes.clear();
    const int first = static_cast<int>(set.nodes.indices().size());
    set.nodes.push_back(nodes);
    for (int s = begin; s < slot; ++s) {
      const auto found = std::lower_bound(nodes.begin(), nodes.end(), node_of(pattern.columns[s]));
      set.place[static_cast<size_t>(s)] = skip ? -1 : first + static_cast<int>(found - nodes.begin());
    }
  }
  set.first_slot.push_back(pattern.size());
}

template <class Visit>
void TangentPattern::for_each_pair(Visit visit) const {
  for (const RowSet* set : {&energies_, &constraints_})
    for (int row = 0; row < set->rows; ++row) {
      const auto nodes = set->nodes[row];
      for (size_t a = 0; a < nodes.size(); ++a) {
        if (layout_.is_outside(nodes[a])) continue;
        for (size_t b = 0; b <= a; ++b)
          if (!layout_.is_outside(nodes[b])) visit(*set, nodes[a], nodes[b]);
      }
    }
}

void TangentPattern::choose_eliminated() {
  std::vector<char> keep(static_cast<size_t>(nodes()), 0);
  std::fill(keep.begin() + points_, keep.end(), 1);
  std::vector<int> met(static_cast<size_t>(points_), 0);  // rows with a plane: at least its neighbours
  for_each_pair([&](const RowSet& set, int later, int earlier) {
    if (later == earlier) return;
    energies_couple_ = energies_couple_ || couples_points(set, later, earlier);
    if (drops(set, later, earlier)) return;
    if (later < points_) {
      keep[static_cast<size_t>(later)] = keep[static_cast<size_t>(earlier)] = 1;
    } else if (earlier < points_) {
      ++met[static_cast<size_t>(earlier)];
    }
  });
  // Several rows may couple the same two; count precisely only where it could matter.
  std::vector<std::uint64_t> many;
  for_each_pair([&](const RowSet&, int later, int earlier) {
    if (later >= points_ && earlier < points_ && met[static_cast<size_t>(earlier)] > kMostCouplings)
      many.push_back(key(earlier, later));
  });
  sort_unique(many);
  for (size_t begin = 0; begin < many.size();) {
    size_t end = begin;
    while (end < many.size() && many[end] >> 32 == many[begin] >> 32) ++end;
    if (end - begin > kMostCouplings) keep[many[begin] >> 32] = 1;
    begin = end;
  }
  kept_index_.resize(keep.size());
  for (int node = 0; node < nodes(); ++node) {
    if (layout_.is_outside(node)) {
      kept_index_[static_cast<size_t>(node)] = kNowhere;
      continue;
    }
    std::vector<int>& list = keep[static_cast<size_t>(node)] ? kept_nodes_ : eliminated_points_;
    const int place = static_cast<int>(list.size());
    kept_index_[static_cast<size_t>(node)] = keep[static_cast<size_t>(node)] ? place : -1 - place;
    list.push_back(node);
  }
}

void TangentPattern::find_couplings() {
  std::vector<std::uint64_t> pairs;
  for_each_pair([&](const RowSet& set, int later, int earlier) {
    const int e = kept_index_[static_cast<size_t>(earlier)], k = kept_index_[static_cast<size_t>(later)];
    if (e < 0 && k >= 0 && !drops(set, later, earlier)) pairs.push_back(key(-1 - e, k));
  });
  sort_unique(pairs);
  first_coupling_.assign(static_cast<size_t>(eliminated()) + 1, 0);
  coupled_kept_.reserve(pairs.size());
  for (const std::uint64_t pair : pairs) {
    ++first_coupling_[(pair >> 32) + 1];
    coupled_kept_.push_back(static_cast<int>(pair & 0xffffffffu));
  }
  for (size_t e = 1; e < first_coupling_.size(); ++e) first_coupling_[e] += first_coupling_[e - 1];
}

void TangentPattern::find_kept_blocks() {
  for (int k = 0; k < kept(); ++k) kept_keys_.push_back(key(k, k));
  for_each_pair([&](const RowSet& set, int later, int earlier) {
    const int a = kept_index_[static_cast<size_t>(later)], b = kept_index_[static_cast<size_t>(earlier)];
    if (a >= 0 && b >= 0 && a != b && !drops(set, later, earlier)) kept_keys_.push_back(key(a, b));
  });
  for (int e = 0; e < eliminated(); ++e)
    for (int a = first_coupling(e); a < first_coupling(e + 1); ++a)
      for (int b = first_coupling(e); b < a; ++b) kept_keys_.push_back(key(coupled_kept(a), coupled_kept(b)));
  sort_unique(kept_keys_);
  kept_keys_.shrink_to_fit();
  for (int e = 0; e < eliminated(); ++e)
    for (int a = first_coupling(e); a < first_coupling(e + 1); ++a)
      for (int b = first_coupling(e); b <= a; ++b)
        fill_.push_back(kept_block(coupled_kept(a), coupled_kept(b)));
}

int TangentPattern::kept_block(int later, int earlier) const {
  const auto found = std::lower_bound(kept_keys_.begin(), kept_keys_.end(), key(later, earlier));
  return found != kept_keys_.end() && *found == key(later, earlier)
             ? static_cast<int>(found - kept_keys_.begin())
             : -1;
}

int TangentPattern::coupling_of(int e, int kept_node) const {
  const auto begin = coupled_kept_.begin() + first_coupling(e),
             end = coupled_kept_.begin() + first_coupling(e + 1);
  const auto found = std::lower_bound(begin, end, kept_node);
  return found != end && *found == kept_node ? static_cast<int>(found - coupled_kept_.begin()) : -1;
}

int TangentPattern::find_block(int a, int b, bool& transposed) const {
  transposed = a < b;
  const int later = kept_index_[static_cast<size_t>(std::max(a, b))];
  const int earlier = kept_index_[static_cast<size_t>(std::min(a, b))];
  if (later == kNowhere || earlier == kNowhere) return -1;
  if (a == b) return earlier >= 0 ? kept_block(later, earlier) : kept_blocks() + (-1 - earlier);
  if (later >= 0 && earlier >= 0) return kept_block(later, earlier);
  if (later < 0) return -1;  // eliminated points couple with no other point
  const int c = coupling_of(-1 - earlier, later);
  return c < 0 ? -1 : coupling_block(c);
}

void TangentPattern::assign_pairs() {
  for (RowSet* set : {&energies_, &constraints_}) {
    set->first_pair.reserve(static_cast<size_t>(set->rows) + 1);
    for (int row = 0; row < set->rows; ++row) {
      set->first_pair.push_back(set->pair_block.size());
      const auto nodes = set->nodes[row];
      for (size_t a = 0; a < nodes.size(); ++a)
        for (size_t b = 0; b <= a; ++b) {
          bool transposed;
          set->pair_block.push_back(
              drops(*set, nodes[a], nodes[b]) ? -1 : find_block(nodes[a], nodes[b], transposed));
        }
    }
    set->first_pair.push_back(set->pair_block.size());
  }
  for (int node = 0; node < nodes(); ++node) {
    bool transposed;
    diagonal_block_.push_back(find_block(node, node, transposed));
  }
}

}  // namespace planewright
