#include "core/cluster/region_repair.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "core/cluster/partition.h"
#include "core/cluster/region_shape.h"
#include "core/cluster/region_split.h"

namespace planewright {
namespace {

// A round repairs regions that are not beside each other. From some round on regions are split alone, which
// ends at the latest with one for each face.
constexpr int kRounds = 1000, kGentleRounds = 4;

// Corner vertices at both ends of a border between two regions, and the regions there.
struct Border {
  std::array<int, 2> ends;  // the lower first
  int left, right;
};

class Repairer {
 public:
  Repairer(const FaceGraph& graph, std::vector<int>& regions, int& count, const ClusterMetric& metric)
      : graph_(graph), regions_(regions), count_(count), metric_(metric), shapes_(graph, regions) {}

  Result<std::vector<RegionRepair>> run() {
    for (int round = 0; round < kRounds; ++round) {
      gentle_ = round < kGentleRounds;
      faces_ = faces_of_regions(regions_, count_);
      blocked_.assign(static_cast<size_t>(count_), 0);
      const bool rests = !repair_outlines() && !repair_corners() && !repair_shared_ends();
      close_gaps();
      if (stuck_ >= 0) break;
      if (rests) return std::move(repairs_);
    }
    return fail(ErrorCode::Refused, "the region cannot be made a panel with three corners",
                "region " + std::to_string(std::max(stuck_, 0)),
                "Ask for another number of panels, or subdivide the mesh there");
  }

 private:
  // Each of these repairs what it can in one round, and says whether there was anything.
  bool repair_outlines() {
    bool any = false;
    for (int r = 0; r < faces_.size(); ++r) {
      const RegionShape shape = shapes_.of(faces_[r]);
      if (shape.disk() && shape.touching < 0) continue;
      any = true;
      if (blocked_[r]) continue;
      if (!shape.disk())
        split_ring(r, shape);
      else
        part_touching(r, shape.touching);
    }
    return any;
  }

  bool repair_corners() {
    bool any = false;
    for (int r = 0; r < faces_.size(); ++r) {
      if (blocked_[r]) {  // by a repair of this round
        any = true;
        continue;
      }
      const RegionShape shape = shapes_.of(faces_[r]);
      if (shape.corners >= 3 || border_will_do(shape)) continue;
      any = true;
      split_few_corners(r, shape);
    }
    return any;
  }

  bool repair_shared_ends() {
    std::vector<Border> borders;
    for (int r = 0; r < faces_.size(); ++r) add_borders(r, borders);
    std::stable_sort(borders.begin(), borders.end(),
                     [](const Border& a, const Border& b) { return a.ends < b.ends; });
    bool any = false;
    for (size_t k = 0; k + 1 < borders.size(); ++k) {
      if (borders[k].ends != borders[k + 1].ends) continue;
      // The largest of the regions beside the two that can take it.
      int widest = -1;
      for (const Border& border : {borders[k], borders[k + 1]})
        for (const int r : {border.left, border.right})
          if (r >= 0 && faces_.valence(r) > 1 && (widest < 0 || faces_.valence(r) > faces_.valence(widest)))
            widest = r;
      if (widest < 0) continue;  // single faces all round: as fine as it gets
      any = true;
      if (blocked_[widest]) continue;
      split_between(widest, borders[k].ends, RepairKind::SplitSharedEnds);
    }
    return any;
  }

  // Where the outline of r runs from corner to corner; each border once.
  void add_borders(int r, std::vector<Border>& borders) {
    const RegionShape shape = shapes_.of(faces_[r]);
    for (const auto& loop : shape.loops) {
      std::vector<int> at;  // half-edges of the loop that leave a corner
      for (const int c : loop)
        if (shapes_.is_corner(graph_.tail(c))) at.push_back(c);
      for (size_t k = 0; k < at.size(); ++k) {
        const int a = graph_.tail(at[k]), b = graph_.tail(at[(k + 1) % at.size()]);
        const int right = graph_.beside[at[k]] < 0 ? -1 : regions_[graph_.beside[at[k]]];
        // The mesh's border gets corners of its own as it needs them.
        if (right >= 0 && r < right) borders.push_back({{std::min(a, b), std::max(a, b)}, r, right});
      }
    }
  }

  // Whether the outline's part along the border gives the corners that are missing: a vertex off the line
  // between the two that there are.
  bool border_will_do(const RegionShape& shape) const {
    std::vector<int> corners, free;
    for (const auto& loop : shape.loops)
      for (const int c : loop) {
        const int v = graph_.tail(c);
        if (shapes_.is_corner(v))
          corners.push_back(v);
        else if (graph_.on_border[v])
          free.push_back(v);
      }
    if (corners.size() + free.size() < 3) return false;
    if (corners.size() < 2) return !free.empty();
    const Vector3d a = graph_.vertices.row(corners[0]), b = graph_.vertices.row(corners[1]);
    const Vector3d along = b - a;
    for (const int v : free) {
      const Vector3d arm = graph_.vertices.row(v).transpose() - a;
      const double off = (arm - along * (arm.dot(along) / std::max(along.squaredNorm(), 1e-300))).norm();
      if (off > 1e-3 * std::max(arm.norm(), along.norm())) return true;
    }
    return false;
  }

  // Round a hole: seeds at equal distances along its loop. Where the hole has a corner or more, two sectors
  // do; where it has none, three give the region inside it its corners. Without a hole: in two, far apart.
  void split_ring(int r, const RegionShape& shape) {
    std::vector<std::vector<int>> sources;
    if (shape.loops.size() > 1) {
      const auto shortest =
          std::min_element(shape.loops.begin(), shape.loops.end(),
                           [](const auto& a, const auto& b) { return a.size() < b.size(); });
      const bool bare = std::none_of(shortest->begin(), shortest->end(),
                                     [&](int c) { return shapes_.is_corner(graph_.tail(c)); });
      const bool inner = graph_.beside[shortest->front()] >= 0;
      const size_t sectors = bare && inner ? 3 : 2;
      for (size_t k = 0; k < sectors; ++k) {
        const int f = graph_.face_of_corner[(*shortest)[k * shortest->size() / sectors]];
        if (std::none_of(sources.begin(), sources.end(), [&](const auto& s) { return s[0] == f; }))
          sources.push_back({f});
      }
    }
    if (sources.size() < 2) sources = far_apart(r);
    split(r, sources, RepairKind::SplitRing);
  }

  std::vector<std::vector<int>> far_apart(int r) const {
    const auto far = far_faces(graph_, regions_, faces_[r][0]);
    if (far[0] == far[1]) return {};
    return {{far[0]}, {far[1]}};
  }

  // The faces of each fan of r round v, and the regions beside the fan.
  struct Fan {
    std::vector<int> faces, beside;
  };
  std::vector<Fan> fans_of(int r, int v) const {
    std::vector<int> round;  // faces, counter-clockwise
    const int start = graph_.corner_of_vertex[v];
    for (int c = start; c >= 0 && (c != start || round.empty()); c = graph_.turn_left(c))
      round.push_back(graph_.face_of_corner[c]);
    const size_t n = round.size();
    const bool closed = !graph_.on_border[v];
    std::vector<Fan> fans;
    for (size_t k = 0; k < n; ++k) {
      if (regions_[round[k]] != r) continue;
      const bool first = k > 0 ? regions_[round[k - 1]] != r : !closed || regions_[round[n - 1]] != r;
      if (!first) continue;
      Fan fan;
      size_t j = k;
      for (; regions_[round[j % n]] == r && (closed || j < n) && fan.faces.size() < n; ++j)
        fan.faces.push_back(round[j % n]);
      if (closed || k > 0) fan.beside.push_back(regions_[round[(k + n - 1) % n]]);
      if (closed || j < n) fan.beside.push_back(regions_[round[j % n]]);
      fans.push_back(std::move(fan));
    }
    return fans;
  }

  // The smallest fan goes to a neighbour if that leaves two good regions; else the fans become regions.
  void part_touching(int r, int v) {
    std::vector<Fan> fans = fans_of(r, v);
    std::stable_sort(fans.begin(), fans.end(),
                     [](const Fan& a, const Fan& b) { return a.faces.size() < b.faces.size(); });
    if (gentle_)
      for (const Fan& fan : fans)
        for (const int to : fan.beside)
          if (!blocked_[to] && move_faces(r, fan.faces, to)) return;
    std::vector<std::vector<int>> sources;
    for (const Fan& fan : fans) sources.push_back(fan.faces);
    split(r, sources, RepairKind::SplitTouching);
  }

  bool move_faces(int from, const std::vector<int>& moved, int to) {
    std::vector<int> rest, more(faces_[to].begin(), faces_[to].end());
    for (const int f : faces_[from])
      if (std::find(moved.begin(), moved.end(), f) == moved.end()) rest.push_back(f);
    if (rest.empty()) return false;
    more.insert(more.end(), moved.begin(), moved.end());
    block(from);  // and what lies beside, as it is before
    block(to);
    for (const int f : moved) regions_[f] = to;
    const auto good = [&](const std::vector<int>& faces) {
      const RegionShape shape = shapes_.of(faces);
      return shape.disk() && shape.touching < 0;
    };
    // Vertices of the moved faces may have become corners, or none any more, of a third region: that is seen
    // to in the next round.
    if (good(rest) && good(more)) {
      repairs_.push_back({RepairKind::MovedFaces, from, to, static_cast<int>(moved.size())});
      return true;
    }
    for (const int f : moved) regions_[f] = from;
    return false;
  }

  void split_few_corners(int r, const RegionShape& shape) {
    std::vector<int> corners;
    for (const auto& loop : shape.loops)
      for (const int c : loop)
        if (shapes_.is_corner(graph_.tail(c))) corners.push_back(graph_.tail(c));
    if (faces_.valence(r) == 1)
      gentle_ ? merge(r) : split_beside(r);
    else if (corners.size() == 2)
      split_between(r, {corners[0], corners[1]}, RepairKind::SplitFewCorners);
    else
      split(r, far_apart(r), RepairKind::SplitFewCorners);
  }

  // At a vertex of a single face where only one other region is: in two there, so that a corner comes of it.
  void split_beside(int r) {
    for (const int v : graph_.faces[faces_[r][0]]) {
      if (graph_.on_border[v] || shapes_.fans_at(v) != 2) continue;
      const int start = graph_.corner_of_vertex[v];
      int other = -1;
      for (int c = start; other < 0; c = graph_.turn_left(c))
        if (regions_[graph_.face_of_corner[c]] != r) other = regions_[graph_.face_of_corner[c]];
      const std::vector<Fan> fans = fans_of(other, v);
      if (fans.size() != 1 || fans[0].faces.size() < 2) continue;
      if (blocked_[other]) return;  // in the next round
      split(other, {{fans[0].faces.front()}, {fans[0].faces.back()}}, RepairKind::SplitForNeighbour);
      return;
    }
    stuck_ = r;
  }

  // Across, so that the new border ends on both sides between the two vertices.
  void split_between(int r, const std::array<int, 2>& ends, RepairKind kind) {
    std::array<int, 2> at{-1, -1};
    for (const int f : faces_[r])
      for (const int v : graph_.faces[f])
        for (int k = 0; k < 2; ++k)
          if (v == ends[k] && at[k] < 0 && at[1 - k] != f) at[k] = f;
    if (at[0] < 0 || at[1] < 0 || at[0] == at[1])
      split(r, far_apart(r), kind);
    else
      split(r, {{at[0]}, {at[1]}}, kind);
  }

  void split(int r, const std::vector<std::vector<int>>& sources, RepairKind kind) {
    block(r);
    if (sources.size() < 2) {
      gentle_ ? merge(r) : split_beside(r);
      return;
    }
    split_by_distance(graph_, regions_, r, count_, sources);
    for (size_t k = 1; k < sources.size(); ++k) {
      const int part = count_++;
      const auto faces = std::count(regions_.begin(), regions_.end(), part);
      repairs_.push_back({kind, r, part, static_cast<int>(faces)});
    }
  }

  // A region that cannot be split goes to the neighbour where that costs least.
  void merge(int r) {
    RegionSums own;
    std::map<int, RegionSums> beside;
    for (const int f : faces_[r]) own.add(graph_, f);
    for (const int f : faces_[r])
      for (int c = graph_.faces.offsets()[f]; c < graph_.faces.offsets()[f + 1]; ++c)
        if (graph_.beside[c] >= 0 && regions_[graph_.beside[c]] != r) beside[regions_[graph_.beside[c]]];
    const ClusterMetric metric = for_regions(metric_, count_);
    std::optional<std::pair<double, int>> best;
    for (auto& [region, sums] : beside) {
      // Of this round's splits and merges nothing is known here.
      if (region >= faces_.size() || blocked_[region]) continue;
      for (const int f : faces_[region]) sums.add(graph_, f);
      const double alone = fit_proxy(sums, metric).error;
      sums += own;
      const double cost = fit_proxy(sums, metric).error - alone;
      if (!best || cost < best->first) best = {cost, region};
    }
    if (beside.empty()) stuck_ = r;
    if (!best) return;  // the next round may find one that is free
    block(r);
    block(best->second);
    for (const int f : faces_[r]) regions_[f] = best->second;
    repairs_.push_back({RepairKind::MergedFewCorners, best->second, r, faces_.valence(r)});
  }

  // No other repair of this round may touch r, or what lies beside it.
  void block(int r) {
    if (r >= faces_.size()) return;
    blocked_[r] = 1;
    for (const int f : faces_[r])
      for (int c = graph_.faces.offsets()[f]; c < graph_.faces.offsets()[f + 1]; ++c)
        if (graph_.beside[c] >= 0 && regions_[graph_.beside[c]] < faces_.size())
          blocked_[regions_[graph_.beside[c]]] = 1;
  }

  // Merged regions are gone: the others move up.
  void close_gaps() {
    std::vector<int> number(static_cast<size_t>(count_), -1);
    for (const int r : regions_) number[r] = 0;
    if (std::find(number.begin(), number.end(), -1) == number.end()) return;
    count_ = 0;
    for (int& n : number) n = n < 0 ? -1 : count_++;
    for (int& r : regions_) r = number[r];
    for (RegionRepair& repair : repairs_) {
      // What went later is told by the repair that removed it.
      repair.region = repair.region < 0 ? -1 : number[repair.region];
      repair.other = repair.kind == RepairKind::MergedFewCorners ? repair.region
                     : repair.other < 0                          ? -1
                                                                 : number[repair.other];
    }
    if (stuck_ >= 0) stuck_ = number[stuck_];
  }

  const FaceGraph& graph_;
  std::vector<int>& regions_;
  int& count_;
  const ClusterMetric& metric_;
  RegionShapes shapes_;
  Polygons faces_;             // at the beginning of the round
  std::vector<char> blocked_;  // #regions at the beginning of the round
  std::vector<RegionRepair> repairs_;
  bool gentle_ = true;
  int stuck_ = -1;
};

}  // namespace

std::string describe(const RegionRepair& repair) {
  const std::string region =
      repair.region < 0 ? "A region that is gone again" : "Region " + std::to_string(repair.region);
  const std::string other =
      repair.other < 0 ? "a region that is gone again" : "region " + std::to_string(repair.other);
  const std::string faces = " (" + std::to_string(repair.faces) + (repair.faces == 1 ? " face)" : " faces)");
  switch (repair.kind) {
    case RepairKind::SplitRing:
      return region + " was closed to a ring or had a hole: split, the new part is " + other + faces;
    case RepairKind::SplitTouching:
      return region + " touched itself at a vertex: split, the new part is " + other + faces;
    case RepairKind::MovedFaces:
      return region + " touched itself at a vertex: its faces there went to " + other + faces;
    case RepairKind::SplitFewCorners:
      return region + " had fewer than three corners: split, the new part is " + other + faces;
    case RepairKind::SplitForNeighbour:
      return region +
             " was split, so that a neighbour of a single face gets a third corner; the new part is " +
             other + faces;
    case RepairKind::MergedFewCorners:
      return region + " took in a neighbour that had fewer than three corners" + faces;
    case RepairKind::SplitSharedEnds:
      return region + " lay at one of two borders between the same two corners: split, the new part is " +
             other + faces;
  }
  return {};
}

Result<std::vector<RegionRepair>> repair_regions(const FaceGraph& graph, std::vector<int>& region_of_face,
                                                 int& count, const ClusterMetric& metric) {
  return Repairer(graph, region_of_face, count, metric).run();
}

}  // namespace planewright
