// AppState's clusters: how they come to be, how the designer changes them, and what is seen and known of
// them.
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/app_state.h"
#include "ui/format.h"

namespace planewright::ui {
namespace {

// A few hundred panels of a fine mesh: more than a designer would draw, fewer than a screen shows.
int default_regions(const PolygonMesh& mesh) {
  return std::max(1, static_cast<int>(std::lround(1.1 * std::sqrt(mesh.face_count()))));
}

Painted whole(SharedClusters clusters) {
  return {std::move(clusters), {}, {}};
}

std::string regions_text(int count) {
  return format_count(count, "region", "regions");
}

}  // namespace

// --- What is asked for -----------------------------------------------------------------------

int AppState::fewest_regions() const {
  return std::max(1, document_.health().components);
}

ClusterOptions AppState::cluster_options() const {
  if (cluster_asked_) return *cluster_asked_;
  if (clusters()) return clusters()->options;
  ClusterOptions options;
  if (document_.empty()) return options;
  const int faces = document_.mesh()->face_count();
  options.panels = std::clamp(default_regions(*document_.mesh()), std::min(fewest_regions(), faces), faces);
  return options;
}

void AppState::set_cluster_options(const ClusterOptions& options, std::string what, std::string merge_key,
                                   bool anew) {
  if (document_.empty()) return;
  cluster_asked_ = options;
  ClusterWish wanted;
  wanted.make = [options, anew, mesh = document_.mesh()](const SharedClusters& from,
                                                         const std::stop_token& stop) {
    const bool targets = options.target_normal || options.target_distance;
    auto made = !from             ? cluster_mesh(mesh, options, nullptr, stop)
                : anew || targets ? planewright::cluster_anew(*from, options, stop)
                                  : recluster(*from, options, stop);
    return std::move(made).map(whole);
  };
  wanted.what = std::move(what);
  wanted.merge_key = std::move(merge_key);
  wish(std::move(wanted));
}

void AppState::cluster_anew() {
  const ClusterOptions options = cluster_options();
  set_cluster_options(options, "Cluster anew: " + regions_text(options.panels), {}, true);
}

// Each region by one of its faces: what came before may give it another number.
void AppState::merge_regions(int a, int b) {
  if (!clusters()) return;
  const std::vector<int>& regions = clusters()->regions.region_of_face;
  const auto face_of = [&](int region) {
    return std::find(regions.begin(), regions.end(), region) - regions.begin();
  };
  const auto first = face_of(a), second = face_of(b), faces = static_cast<std::ptrdiff_t>(regions.size());
  if (first == faces || second == faces) return;
  ClusterWish wanted;
  wanted.by_hand = true;
  wanted.what = "Merge regions " + format_count(std::min(a, b)) + " and " + format_count(std::max(a, b));
  wanted.make = [first, second](const SharedClusters& from, const std::stop_token&) {
    const std::vector<int>& now = from->regions.region_of_face;
    return with_regions_merged(*from, now[static_cast<std::size_t>(first)],
                               now[static_cast<std::size_t>(second)])
        .map(whole);
  };
  wish(std::move(wanted));
}

void AppState::split_region(int region) {
  if (!clusters()) return;
  const std::vector<int>& regions = clusters()->regions.region_of_face;
  const auto face = std::find(regions.begin(), regions.end(), region) - regions.begin();
  if (face == static_cast<std::ptrdiff_t>(regions.size())) return;
  ClusterWish wanted;
  wanted.by_hand = true;
  wanted.what = "Split region " + format_count(region);
  wanted.make = [face](const SharedClusters& from, const std::stop_token&) {
    return with_region_split(*from, from->regions.region_of_face[static_cast<std::size_t>(face)]).map(whole);
  };
  wish(std::move(wanted));
}

// --- Painting --------------------------------------------------------------------------------

void AppState::begin_painting(int from) {
  if (!clusters() || from < 0 || from >= document_.mesh()->face_count()) return;
  end_painting();
  stroke_ = Stroke{from, {}, {}, next_stroke_++, false};
}

void AppState::paint(const std::vector<int>& faces) {
  if (!stroke_ || stroke_->ended || !clusters()) return;
  const std::vector<int>& regions = clusters()->regions.region_of_face;
  const int region = regions[static_cast<std::size_t>(stroke_->from)];
  for (const int f : faces) {
    if (f < 0 || f >= static_cast<int>(regions.size()) || regions[static_cast<std::size_t>(f)] == region)
      continue;
    if (std::find(stroke_->waiting.begin(), stroke_->waiting.end(), f) == stroke_->waiting.end()) {
      stroke_->waiting.push_back(f);
      stroke_->refused.reset();  // tried anew with this one
    }
  }
}

void AppState::end_painting() {
  if (stroke_) stroke_->ended = true;
}

std::optional<int> AppState::painting_region() const {
  if (!stroke_ || !clusters()) return std::nullopt;
  return clusters()->regions.region_of_face[static_cast<std::size_t>(stroke_->from)];
}

// What could not go over stays in the brush: with more of the stroke it may.
void AppState::take_stroke(const Painted& painted) {
  if (!stroke_) return;
  for (const int f : painted.refused) {
    if (std::find(stroke_->waiting.begin(), stroke_->waiting.end(), f) == stroke_->waiting.end())
      stroke_->waiting.push_back(f);
  }
  stroke_->refused = stroke_->waiting.size() == painted.refused.size() ? painted.why : std::nullopt;
}

// --- In the background -----------------------------------------------------------------------

bool AppState::clusters_wanted() const {
  const auto& layers = document_.design().layers;
  return !document_.empty() && std::any_of(layers.begin(), layers.end(), [](const Layer& layer) {
    return layer.settings.mode == ComplexKind::Cluster;
  });
}

void AppState::wish(ClusterWish wanted) {
  cluster_error_.reset();
  if (!wanted.by_hand) {
    std::erase_if(cluster_wishes_, [](const ClusterWish& other) { return !other.by_hand; });
    // From seeds it can take seconds, for a result that nobody asks for any more.
    if (clustering_wish_ && !clustering_wish_->by_hand && clustering_wish_->merge_key.empty()) {
      clustering_cut_short_ = false;
      cluster_stop_.request_stop();
    }
  }
  cluster_wishes_.push_back(std::move(wanted));
  start_clustering();
}

void AppState::stop_clustering() {
  if (!clustering_wish_ || clustering_wish_->by_hand || cluster_stop_.stop_requested()) return;
  clustering_cut_short_ = true;
  cluster_stop_.request_stop();
}

void AppState::drop_cluster_wishes() {
  clustering_cut_short_ = false;
  cluster_wishes_.clear();
  stroke_.reset();
  clustering_wish_.reset();
  cluster_asked_.reset();
  cluster_error_.reset();
  merge_ends_late_ = false;
  cluster_stop_.request_stop();
}

void AppState::start_clustering() {
  if (cluster_task_.running()) return;
  if (cluster_wishes_.empty() && stroke_ && !stroke_->waiting.empty() && !stroke_->refused) {
    ClusterWish wanted;
    wanted.by_hand = wanted.paints = true;
    wanted.what = "Paint region " + format_count(painting_region().value_or(0));
    wanted.merge_key = "paint " + std::to_string(stroke_->number);
    wanted.make = [faces = std::exchange(stroke_->waiting, {}), from = stroke_->from](
                      const SharedClusters& clusters, const std::stop_token&) {
      return with_faces_painted(*clusters, faces, from);
    };
    cluster_wishes_.push_back(std::move(wanted));
  }
  if (cluster_wishes_.empty()) return;
  clustering_wish_ = std::move(cluster_wishes_.front());
  cluster_wishes_.pop_front();
  cluster_stop_ = {};
  clustering_since_ = Clock::now();
  cluster_task_.start([make = clustering_wish_->make, from = clusters(),
                       stop = cluster_stop_.get_token()] { return make(from, stop); },
                      wake_);
}

bool AppState::update_clusters() {
  bool changed = false;
  if (auto made = cluster_task_.take()) {
    changed = true;
    const bool superseded = cluster_stop_.stop_requested() && !std::exchange(clustering_cut_short_, false);
    if (clustering_wish_ && !superseded) take_clusters(std::move(*made));
    clustering_wish_.reset();
  }
  if (clusters_wanted() && !clusters() && !clustering() && !cluster_error_) {
    const ClusterOptions options = cluster_options();
    set_cluster_options(options, {}, {}, true);
    if (!cluster_wishes_.empty()) cluster_wishes_.back().is_step = false;
    if (clustering_wish_) clustering_wish_->is_step = false;
  }
  start_clustering();
  const bool stroke_over =
      stroke_ && stroke_->ended && !cluster_task_.running() && (stroke_->waiting.empty() || stroke_->refused);
  if (stroke_over) {
    if (const auto& why = stroke_->refused) post(Message::Kind::Refused, why->what, why->where, why->remedy);
    stroke_.reset();
    end_merge();
    changed = true;
  }
  if (merge_ends_late_ && !clustering()) end_merge();
  changed |= update_region_view();
  changed |= update_cluster_report();
  return changed;
}

void AppState::take_clusters(Result<Painted> made) {
  const ClusterWish& wanted = *clustering_wish_;
  clustering_ms_ = std::chrono::duration<double, std::milli>(Clock::now() - clustering_since_).count();
  if (!made) {
    const Error& why = made.error();
    if (wanted.by_hand) {
      post(Message::Kind::Refused, why.what, why.where, why.remedy);
      if (wanted.paints) stroke_.reset();
    } else {
      cluster_error_ = why;
    }
    if (!clusters()) solve_wanted_ = false;  // there is nothing to solve
    return;
  }
  if (made->clusters->mesh != document_.mesh()) return;
  if (wanted.by_hand && !wanted.paints) {
    // Else a merge that had to be split again would look as if it had come to nothing.
    const std::vector<RegionRepair>& repairs = made->clusters->regions.repairs;
    const auto further = static_cast<std::int64_t>(repairs.size()) - 1;
    if (further >= 0) {
      post(Message::Kind::Info,
           describe(repairs.front()) + (further > 0 ? ", and " + format_count(further) + " more" : ""));
    }
  }
  if (wanted.paints) take_stroke(*made);
  if (cluster_wishes_.empty()) cluster_asked_.reset();
  if (clusters() && clusters()->regions.region_of_face == made->clusters->regions.region_of_face &&
      clusters()->options.panels == made->clusters->options.panels &&
      clusters()->options.metric == made->clusters->options.metric &&
      clusters()->options.seeds == made->clusters->options.seeds && wanted.by_hand)
    return;
  if (!wanted.is_step) {
    document_.set_clusters(std::move(made->clusters));
  } else {
    const auto dropped = document_.change_clusters(std::move(made->clusters), wanted.what, wanted.merge_key);
    merging_ = !wanted.merge_key.empty();
    tell_of_dropped(dropped);
  }
  ++selection_changes_;
  document_changed();
}

bool AppState::update_region_view() {
  bool changed = false;
  if (auto made = region_task_.take()) {
    region_view_ = std::move(*made);
    changed = true;
  }
  if (!clusters_wanted() || !clusters() || !mesh_view_ || mesh_view_->mesh != clusters()->mesh) {
    if (region_view_ && !clusters_wanted()) {
      region_view_.reset();
      changed = true;
    }
    return changed;
  }
  if ((region_view_ && region_view_->clusters == clusters()) || region_task_.running()) return changed;
  region_task_.start(
      [clusters = clusters(), mesh = mesh_view_, before = region_view_] {
        return std::make_shared<const RegionView>(make_region_view(clusters, mesh, before.get()));
      },
      wake_);
  return changed;
}

bool AppState::update_cluster_report() {
  bool changed = false;
  if (auto measured = measure_task_.take()) {
    measured_ = std::move(*measured);
    changed = true;
  }
  if (document_.empty() || merging_ || solving() || measure_task_.running()) return changed;
  const LayerRun& of = run(active_layer());
  if (!of.newest_final || !of.started || !of.started->clusters ||
      (measured_ && measured_->iterate == of.newest))
    return changed;
  if (of.newest->complex->kind != ComplexKind::Cluster || of.stale) return changed;
  measure_task_.start(
      [clusters = of.started->clusters, iterate = of.newest] {
        return std::make_shared<const MeasuredClusters>(MeasuredClusters{
            iterate, measure_clusters(*clusters, panels_of(*iterate->complex, iterate->state))});
      },
      wake_);
  return changed;
}

// --- What is seen and known ------------------------------------------------------------------

std::shared_ptr<const ClusterReport> AppState::cluster_report() const {
  const LayerRun& of = run(active_layer());
  if (!measured_ || !of.newest_final || of.newest != measured_->iterate) return nullptr;
  return {measured_, &measured_->report};
}

ClusterSight AppState::cluster_sight() const {
  const bool clusters_drawn =
      !document_.empty() && document_.settings().mode == ComplexKind::Cluster && region_view_;
  return clusters_drawn ? view_options.cluster_sight : ClusterSight::Panels;
}

const std::vector<int>& AppState::selected_regions() const {
  const std::pair now(selection_changes_, clusters());
  if (selected_regions_of_ == now) return selected_regions_;
  selected_regions_of_ = now;
  selected_regions_.clear();
  if (!clusters() || selection_.faces.empty()) return selected_regions_;
  const Regions& regions = clusters()->regions;
  std::vector<char> whole_ones(static_cast<std::size_t>(regions.count()), 1);
  for (std::size_t f = 0; f < regions.region_of_face.size(); ++f) {
    if (!std::binary_search(selection_.faces.begin(), selection_.faces.end(), static_cast<int>(f)))
      whole_ones[static_cast<std::size_t>(regions.region_of_face[f])] = 0;
  }
  for (int r = 0; r < regions.count(); ++r)
    if (whole_ones[static_cast<std::size_t>(r)] != 0) selected_regions_.push_back(r);
  return selected_regions_;
}

void AppState::select_region(int region, Combine how) {
  if (!clusters() || region < 0 || region >= clusters()->regions.count()) return;
  Selection faces;
  const std::vector<int>& regions = clusters()->regions.region_of_face;
  for (std::size_t f = 0; f < regions.size(); ++f)
    if (regions[f] == region) faces.faces.push_back(static_cast<int>(f));
  if (how == Combine::Replace) clear_selection();
  select(std::move(faces), how);
}

void AppState::show_region(int region) {
  if (!clusters() || region < 0 || region >= clusters()->regions.count()) return;
  select_region(region, Combine::Replace);
  const Regions& regions = clusters()->regions;
  // On the surface, not beside it: the face whose middle is nearest to the region's.
  const FaceGraph& graph = *clusters()->graph;
  const Vector3d middle = regions.origin + regions.proxies[static_cast<std::size_t>(region)].centre;
  Vector3d place = middle;
  double nearest = 1e300;
  for (const int f : selection_.faces) {
    const Vector3d centre = graph.to_model(graph.shapes[static_cast<std::size_t>(f)].centre);
    if ((centre - middle).norm() >= nearest) continue;
    nearest = (centre - middle).norm();
    place = centre;
  }
  const double size = graph.length / std::sqrt(std::max(regions.count(), 1));
  look_at_ = LookAt{place - scene_origin_, 5.0 * size};
}

}  // namespace planewright::ui
