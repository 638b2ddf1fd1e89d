#include "core/cluster/clustering.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "core/cluster/partition.h"
#include "core/cluster/region_growing.h"
#include "core/cluster/seeds.h"

namespace planewright {
namespace {

// Lloyd iterations end when one lowers the error by less than this share.
constexpr double kRest = 1e-4;
// A teleport is kept if it lowers the error by this share.
constexpr double kWorthwhile = 1e-5;
// Errors at this share of the area are rounding: a model of flat pieces, each with a region of its own.
constexpr double kNoError = 1e-14;
// So many iterations in a row may raise it.
constexpr int kPatience = 4;
// Iterations after which it shows whether a teleport is worthwhile, and those of a warm start.
constexpr int kTrialIterations = 4, kWarmIterations = 8;
// A teleport is tried where the merge costs less than this share of the worst region's error: splitting a
// region in two saves at least half of it.
constexpr double kHopeful = 0.5;
constexpr double kGrowth = 1.4;  // of the number of regions, while a target is not met

class Clusterer {
 public:
  Clusterer(const FaceGraph& graph, const ClusterOptions& options, ClusterObserver* observer,
            std::stop_token stop)
      : graph_(graph), options_(options), observer_(observer), stop_(std::move(stop)), grower_(graph) {}

  Clustering from_seeds(int count, std::span<const int> seeds) {
    set_count(count);
    std::vector<Proxy> proxies;
    for (const int f : seeds) proxies.push_back(proxy_of_face(graph_, f));
    grow_into(at_, seeds, proxies);
    tell(at_, false);
    lloyd(at_, options_.iterations);
    return finished();
  }

  Clustering from(const Clustering& start) {
    at_.region_of_face = start.region_of_face;
    set_count(start.regions());
    at_.refit(graph_, start.regions(), metric_);
    change_count(at_, options_.panels);
    tell(at_, false);
    lloyd(at_, std::min(options_.iterations, kWarmIterations));
    warm_ = true;
    return finished();
  }

  Clustering to_target(std::vector<int> seeds) {
    const int least = static_cast<int>(seeds.size());
    set_count(least);
    std::vector<Proxy> proxies;
    for (const int f : seeds) proxies.push_back(proxy_of_face(graph_, f));
    grow_into(at_, seeds, proxies);
    tell(at_, false);
    lloyd(at_, options_.iterations);
    Partition low = at_;
    while (!meets_target(at_) && at_.regions() < options_.panels && !stop_.stop_requested()) {
      low = at_;
      const int more = std::max(at_.regions() + 1, static_cast<int>(kGrowth * at_.regions()));
      change_count(at_, std::min(options_.panels, more));
      tell(at_, false);
      lloyd(at_, kWarmIterations);
    }
    while (meets_target(at_) && at_.regions() - low.regions() > 1 && !stop_.stop_requested()) {
      Partition between = low;
      change_count(between, low.regions() + (at_.regions() - low.regions()) / 2);
      lloyd(between, kWarmIterations);
      (meets_target(between) ? at_ : low) = between;
    }
    set_count(at_.regions());
    at_.refit(graph_, at_.regions(), metric_);
    return finished();
  }

 private:
  void set_count(int regions) { metric_ = for_regions(options_.metric, regions); }

  void grow_into(Partition& partition, std::span<const int> seeds, std::span<const Proxy> proxies) {
    grower_.grow(seeds, proxies, metric_, partition.region_of_face);
    partition.refit(graph_, static_cast<int>(seeds.size()), metric_);
  }
  void regrow(Partition& partition) {
    const std::vector<int> seeds = best_faces(graph_, partition, metric_);
    grow_into(partition, seeds, partition.proxies());
  }

  void tell(const Partition& partition, bool teleport) {
    ++iterations_;
    if (!observer_) return;
    const std::vector<Proxy> proxies = partition.proxies();
    observer_->on_iteration({iterations_, partition.error, teleport, partition.region_of_face, proxies});
  }

  // Lowers the error until it rests. An iteration that raises it, as region growing may, is not kept, but may
  // be on the way to one that is.
  void lloyd(Partition& partition, int most, bool silent = false) {
    next_ = partition;
    int patience = kPatience;
    for (int k = 0; k < most && !stop_.stop_requested() && partition.error > kNoError; ++k) {
      regrow(next_);
      if (next_.error < partition.error) {
        const bool rests = next_.error > (1.0 - kRest) * partition.error;
        partition = next_;
        if (!silent) tell(partition, false);
        if (rests) return;
        patience = kPatience;
      } else if (next_.region_of_face == partition.region_of_face || --patience == 0) {
        return;
      }
    }
  }

  // A hopeful exchange: regions a and b become one, b's number goes to a region that starts at a face.
  struct Teleport {
    std::array<int, 2> merged;
    int face;
  };
  std::vector<Teleport> hopeful(size_t most) const {
    struct Merge {
      double cost;
      std::array<int, 2> pair;
    };
    std::vector<Merge> merges;
    for (const auto& pair : neighbouring_regions(graph_, at_.region_of_face))
      merges.push_back({merge_cost(at_, pair, metric_), pair});
    std::stable_sort(merges.begin(), merges.end(),
                     [](const Merge& a, const Merge& b) { return a.cost < b.cost; });
    const std::vector<int> order = by_error(at_), faces = worst_faces(graph_, at_, metric_);
    std::vector<char> used(order.size(), 0);
    std::vector<Teleport> list;
    auto merge = merges.begin();
    for (const int worst : order) {
      if (list.size() == most) break;
      if (used[worst] || at_.sums[worst].faces < 2) continue;
      used[worst] = 1;
      while (merge != merges.end() && (used[merge->pair[0]] || used[merge->pair[1]])) ++merge;
      if (merge == merges.end() || merge->cost > kHopeful * at_.fitted[worst].error) break;
      used[merge->pair[0]] = used[merge->pair[1]] = 1;
      list.push_back({merge->pair, faces[worst]});
    }
    return list;
  }

  // Regions, the greatest error first.
  static std::vector<int> by_error(const Partition& partition) {
    std::vector<int> order(partition.sums.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return partition.fitted[a].error > partition.fitted[b].error; });
    return order;
  }

  // Many exchanges at once while that helps, then fewer, then one.
  void teleport() {
    size_t most = std::max<size_t>(1, static_cast<size_t>(at_.regions()) / 20);
    for (int tries = 0; tries < options_.teleports && most > 0; ++tries) {
      if (stop_.stop_requested() || at_.error <= kNoError) return;
      const std::vector<Teleport> list = hopeful(most);
      if (list.empty()) return;
      Partition trial = at_;
      for (const Teleport& t : list) {
        for (int& r : trial.region_of_face)
          if (r == t.merged[1]) r = t.merged[0];
      }
      for (const Teleport& t : list) trial.region_of_face[t.face] = t.merged[1];
      trial.refit(graph_, at_.regions(), metric_);
      regrow(trial);
      lloyd(trial, kTrialIterations, true);
      if (trial.error < (1.0 - kWorthwhile) * at_.error) {
        std::swap(at_, trial);
        teleports_ += static_cast<int>(list.size());
        tell(at_, true);
        lloyd(at_, options_.iterations);
      } else {
        most = std::min(most, list.size()) / 2;
      }
    }
  }

  // More regions at the worst faces of the worst ones, or fewer by the cheapest merges.
  void change_count(Partition& partition, int count) {
    set_count(count);
    partition.refit(graph_, partition.regions(), metric_);
    while (partition.regions() < count) {
      const std::vector<int> faces = worst_faces(graph_, partition, metric_);
      int regions = partition.regions();
      const std::vector<int> order = by_error(partition);
      for (const int r : order)
        if (regions < count && partition.sums[r].faces > 1) partition.region_of_face[faces[r]] = regions++;
      partition.refit(graph_, regions, metric_);
      regrow(partition);
    }
    while (partition.regions() > count) {
      double least = 0.0;
      std::optional<std::array<int, 2>> cheapest;
      for (const auto& pair : neighbouring_regions(graph_, partition.region_of_face)) {
        const double cost = merge_cost(partition, pair, metric_);
        if (cheapest && cost >= least) continue;
        least = cost;
        cheapest = pair;
      }
      if (!cheapest) break;
      partition.merge((*cheapest)[0], (*cheapest)[1], metric_);
    }
  }

  bool meets_target(const Partition& partition) const {
    const auto [normal, distance] = errors(partition);
    return !(options_.target_normal && normal > *options_.target_normal) &&
           !(options_.target_distance && distance > *options_.target_distance);
  }
  static std::pair<double, double> errors(const Partition& partition) {
    double normal = 0.0, distance = 0.0;
    for (const FittedProxy& f : partition.fitted) {
      normal += f.normal;
      distance += f.distance;
    }
    return {std::sqrt(normal), std::sqrt(distance)};  // of an area of 1
  }

  Clustering finished() {
    if (!warm_) teleport();
    Clustering result = described(at_);
    result.target_met = meets_target(at_);
    result.stopped = stop_.stop_requested();
    result.iterations = iterations_;
    result.teleports = teleports_;
    return result;
  }

 public:
  static Clustering described(const Partition& partition) {
    Clustering result;
    result.region_of_face = partition.region_of_face;
    result.proxies = partition.proxies();
    for (const FittedProxy& f : partition.fitted) result.errors.push_back(f.error);
    result.error = partition.error;
    std::tie(result.normal_error, result.distance_error) = errors(partition);
    return result;
  }

 private:
  const FaceGraph& graph_;
  const ClusterOptions& options_;
  ClusterObserver* observer_;
  std::stop_token stop_;
  RegionGrower grower_;
  ClusterMetric metric_;
  Partition at_, next_;
  int iterations_ = 0, teleports_ = 0;
  bool warm_ = false;
};

tl::unexpected<Error> usage(std::string what, std::string remedy, std::string where = "panels") {
  return fail(ErrorCode::Usage, std::move(what), std::move(where), std::move(remedy));
}

std::string counted(int count, const char* one) {
  return std::to_string(count) + ' ' + one + (count == 1 ? "" : "s");
}

Result<void> check_count(const FaceGraph& graph, int panels) {
  if (panels < 1) return usage("there have to be panels, not " + std::to_string(panels), "Ask for 1 or more");
  if (panels > graph.face_count())
    return usage(
        counted(panels, "panel") + " cannot be made of a mesh with " + counted(graph.face_count(), "face"),
        "Ask for fewer panels, or subdivide the mesh");
  if (panels < graph.component_count())
    return usage("the mesh has " + counted(graph.component_count(), "separate part") + ", but only " +
                     counted(panels, "panel") + " to cover them with",
                 "Ask for at least one panel for each part, or remove parts");
  return {};
}

Result<void> check_given(const FaceGraph& graph, const ClusterOptions& options) {
  if (static_cast<int>(options.given.size()) != options.panels)
    return usage(counted(static_cast<int>(options.given.size()), "seed face") + " for " +
                     counted(options.panels, "panel"),
                 "Give one face for each panel", "seeds");
  std::vector<char> taken(static_cast<size_t>(graph.face_count()), 0);
  std::vector<char> seeded(static_cast<size_t>(graph.component_count()), 0);
  for (const int f : options.given) {
    if (f < 0 || f >= graph.face_count())
      return usage("the mesh has no face " + std::to_string(f), "Give faces of the mesh", "seeds");
    if (taken[f])
      return usage("face " + std::to_string(f) + " is given twice", "Give different faces", "seeds");
    taken[f] = seeded[graph.component_of_face[f]] = 1;
  }
  for (int f = 0; f < graph.face_count(); ++f)
    if (!seeded[graph.component_of_face[f]])
      return usage("the part of the mesh with face " + std::to_string(f) + " has no seed",
                   "Give a face of each separate part", "seeds");
  return {};
}

Result<void> check_options(const FaceGraph& graph, const ClusterOptions& options) {
  if (auto ok = check_count(graph, options.panels); !ok) return ok;
  if (auto ok = check_metric(options.metric); !ok) return ok;
  for (const auto& target : {options.target_normal, options.target_distance})
    if (target && !(std::isfinite(*target) && *target > 0.0))
      return usage("the error to reach is not a positive number", "Give a number above 0", "target");
  if (options.seeds == SeedKind::Given && !options.target_normal && !options.target_distance)
    return check_given(graph, options);
  return {};
}

}  // namespace

Result<Clustering> cluster(const FaceGraph& graph, const ClusterOptions& options, ClusterObserver* observer,
                           std::stop_token stop, const Clustering* start) {
  if (auto ok = check_options(graph, options); !ok) return tl::unexpected(ok.error());
  Clusterer clusterer(graph, options, observer, std::move(stop));
  const bool target = options.target_normal || options.target_distance;
  if (start) {
    if (auto known = clustering_of(graph, start->region_of_face, options.metric); !known)
      return usage("the clustering to start from is not one of this mesh: " + known.error().text(),
                   "Start anew", "start");
    return clusterer.from(*start);
  }
  const int count = target ? graph.component_count() : options.panels;
  std::vector<int> seeds;
  switch (options.seeds) {
    case SeedKind::Random:
      seeds = random_seeds(graph, count, options.seed_number);
      break;
    case SeedKind::Farthest:
      seeds = farthest_seeds(graph, count);
      break;
    case SeedKind::Given:
      seeds = target ? farthest_seeds(graph, count) : options.given;
      break;
  }
  return target ? clusterer.to_target(seeds) : clusterer.from_seeds(count, seeds);
}

Result<Clustering> clustering_of(const FaceGraph& graph, std::vector<int> region_of_face,
                                 const ClusterMetric& metric) {
  const auto refuse = [](std::string what, std::string where) {
    return fail(ErrorCode::Refused, std::move(what), std::move(where), "Cluster the mesh anew");
  };
  if (static_cast<int>(region_of_face.size()) != graph.face_count())
    return refuse(counted(static_cast<int>(region_of_face.size()), "number") + " for " +
                      counted(graph.face_count(), "face"),
                  {});
  int regions = 0;
  for (int f = 0; f < graph.face_count(); ++f) {
    if (region_of_face[f] < 0 || region_of_face[f] >= graph.face_count())
      return refuse("there is no region " + std::to_string(region_of_face[f]), "face " + std::to_string(f));
    regions = std::max(regions, region_of_face[f] + 1);
  }
  // One flood for each region; a face that none reaches lies apart from the rest of its region.
  std::vector<char> reached(region_of_face.size(), 0), begun(static_cast<size_t>(regions), 0);
  std::vector<int> stack;
  for (int start = 0; start < graph.face_count(); ++start) {
    if (reached[start]) continue;
    const int region = region_of_face[start];
    if (begun[region])
      return refuse("the region is not connected: face " + std::to_string(start) + " lies apart",
                    "region " + std::to_string(region));
    begun[region] = reached[start] = 1;
    stack.push_back(start);
    while (!stack.empty()) {
      const int f = stack.back();
      stack.pop_back();
      for (int c = graph.faces.offsets()[f]; c < graph.faces.offsets()[f + 1]; ++c) {
        const int g = graph.beside[c];
        if (g < 0 || reached[g] || region_of_face[g] != region) continue;
        reached[g] = 1;
        stack.push_back(g);
      }
    }
  }
  for (int r = 0; r < regions; ++r)
    if (!begun[r]) return refuse("the region has no face", "region " + std::to_string(r));
  Partition partition;
  partition.region_of_face = std::move(region_of_face);
  partition.refit(graph, regions, for_regions(metric, regions));
  return Clusterer::described(partition);
}

}  // namespace planewright
