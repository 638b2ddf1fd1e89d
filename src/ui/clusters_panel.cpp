// The clusters in the left panel: how many regions, by which measure, from which seeds; the tools that change
// them by hand, and what of all is seen.
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/format.h"
#include "ui/panels.h"

namespace planewright::ui {
namespace {

enum Metric { kBoth, kNormals, kDistances, kOwn };

Metric kind_of(const ClusterMetric& metric) {
  if (metric == ClusterMetric{}) return kBoth;
  if (metric == ClusterMetric::l21()) return kNormals;
  return metric == ClusterMetric::l2() ? kDistances : kOwn;
}

void draw_count(Desk& desk) {
  Ui& ui = desk.ui;
  AppState& state = desk.state;
  ClusterOptions options = state.cluster_options();
  const int faces = state.document().mesh()->face_count();
  CountLook look;
  look.least = std::min(state.fewest_regions(), faces);
  look.most = std::max({look.least + 1, faces / 4, std::min(faces, 8)});
  look.tooltip =
      "How many regions, and with them panels, there are to be. Drag, turn the wheel, or click the number to "
      "type; repairs may add a few.";
  const Edit edit = ui.count("regions", "Regions", options.panels, look);
  if (edit.changed) {
    state.set_cluster_options(options, "Cluster into " + format_count(options.panels, "region", "regions"),
                              "clusters count");
  }
  if (edit.finished) state.end_merge();
}

// What came of it: one line whatever happens, so that nothing jumps.
void draw_outcome(Desk& desk) {
  Ui& ui = desk.ui;
  const AppState& state = desk.state;
  if (const auto& why = state.cluster_error()) {
    ui.wrapped(capitalised(why->what) + ".", ui.colours().error, true);
    if (!why->remedy.empty()) ui.wrapped(capitalised(why->remedy) + ".", ui.colours().ink_soft, true);
    if (state.clusters()) ui.wrapped("What is shown stays as it was.", ui.colours().ink_soft, true);
    return;
  }
  if (!state.clusters()) {
    ui.small_text(state.clustering() ? "Clustering…" : "–");
    return;
  }
  const Regions& regions = state.clusters()->regions;
  std::string text = format_count(regions.count(), "region", "regions");
  if (const auto repairs = static_cast<std::int64_t>(regions.repairs.size()); repairs > 0)
    text += " after " + format_count(repairs, "repair", "repairs");
  text += ", L2,1 error " + format_number(regions.normal_error * regions.normal_error);
  ui.small_text(text);
}

void draw_metric(Desk& desk) {
  Ui& ui = desk.ui;
  AppState& state = desk.state;
  ClusterOptions options = state.cluster_options();
  static const std::array<std::string, 4> kMetrics = {"normals and distances", "normals (L2,1)",
                                                      "distances (L2)", "own weights"};
  static const std::array<std::string, 4> kAbout = {
      "Both, and regions that are round where the design is flat",
      "How much normals differ from their region's", "How far the design is from its region's plane",
      "Any blend of the three"};
  int metric = desk.window.own_metric ? kOwn : kind_of(options.metric);
  if (ui.choice("metric", "Measure", kMetrics, metric,
                "By which regions are flat: what makes a face belong to a region.", kAbout)) {
    desk.window.own_metric = metric == kOwn;
    if (metric != kOwn) {
      options.metric = metric == kBoth      ? ClusterMetric{}
                       : metric == kNormals ? ClusterMetric::l21()
                                            : ClusterMetric::l2();
      state.set_cluster_options(options,
                                "Measure of the clusters: " + kMetrics[static_cast<std::size_t>(metric)]);
    }
  }
  if (metric != kOwn) return;
  const auto weight = [&](const char* name, const char* label, double& value, double reset,
                          const char* about) {
    QuantityLook look;
    look.per_pixel = reset >= 10 ? 0.5 : 0.01;
    look.reset_value = reset;
    look.least = 0;
    look.tooltip = about;
    const Edit edit = ui.quantity_row(name, label, value, look);
    if (edit.changed)
      state.set_cluster_options(options, "Measure of the clusters", std::string("clusters ") + name);
    if (edit.finished) state.end_merge();
  };
  const ClusterMetric usual;
  weight("metric normal", "  normals", options.metric.normal, usual.normal, "Difference of normals, squared");
  weight("metric distance", "  distances", options.metric.distance, usual.distance,
         "Distance to the region's plane, squared, in sizes of a mean region");
  weight("metric compactness", "  roundness", options.metric.compactness, usual.compactness,
         "Distance to the region's middle, squared: keeps regions round");
}

void draw_seeds(Desk& desk) {
  Ui& ui = desk.ui;
  AppState& state = desk.state;
  ClusterOptions options = state.cluster_options();
  static const std::array<std::string, 2> kSeeds = {"farthest apart", "by lot"};
  static const std::array<std::string, 2> kAbout = {
      "Each seed is the face that differs most in place and direction from those before",
      "Faces drawn by lot: another number, other regions"};
  int seeds = options.seeds == SeedKind::Random ? 1 : 0;
  if (ui.choice("seeds", "Seeds", kSeeds, seeds, "Where regions begin when they are clustered anew.",
                kAbout)) {
    options.seeds = seeds == 1 ? SeedKind::Random : SeedKind::Farthest;
    state.set_cluster_options(options, "Seeds " + kSeeds[static_cast<std::size_t>(seeds)], {}, true);
  }
  if (seeds == 1) {
    double number = options.seed_number;
    QuantityLook look;
    look.per_pixel = 1;
    look.reset_value = 1;
    look.least = 0;
    look.tooltip = "Of the lot: the same number gives the same regions, on every machine";
    const Edit edit = ui.quantity_row("seed", "  number", number, look);
    if (edit.changed) {
      options.seed_number = static_cast<std::uint32_t>(std::lround(std::min(number, 4294967295.0)));
      state.set_cluster_options(options, "Seed " + format_count(options.seed_number), "clusters seed", true);
    }
    if (edit.finished) state.end_merge();
  }
  ButtonLook look;
  look.width = -1;
  look.has_icon = true;
  look.icon = Icon::Restart;
  look.enabled = desk.actions.enabled(Action::ClusterAnew);
  look.tooltip = "From seeds, with teleports out of bad minima; changes by hand are given up  (" +
                 info(Action::ClusterAnew).shortcut + ")";
  if (ui.button("cluster anew", "Cluster anew", look)) desk.actions.request(Action::ClusterAnew);
}

void draw_hand_tools(Desk& desk) {
  Ui& ui = desk.ui;
  const float spacing = ui.px(4);
  const float width = std::floor((ImGui::GetContentRegionAvail().x - 2 * spacing) / 3);
  const auto tool = [&](Action action, const char* text, const char* about, bool last) {
    const ActionInfo& of = info(action);
    ButtonLook look;
    look.width = width;
    look.enabled = desk.actions.enabled(action);
    look.active = desk.actions.checked(action);
    look.tooltip = std::string(about) + "  (" + of.shortcut + ")";
    if (ui.button(of.name, text, look)) desk.actions.request(action);
    if (!last) ImGui::SameLine(0, spacing);
  };
  tool(Action::SplitRegion, "Split", "Click a region: it becomes two", false);
  tool(Action::MergeRegions, "Merge", "Click the border between two regions, or one and then its neighbour",
       false);
  tool(Action::PaintRegions, "Paint", "Drag from a region over its neighbours' faces: they go over to it",
       true);
}

void draw_sight(Desk& desk) {
  static const std::array<std::string, 4> kSights = {"Input", "Beside", "Over", "Panels"};
  static const std::array<std::string, 4> kAbout = {
      "The input in its regions' colours", "The input on the left, the panels on the right",
      "The panels as glass over the coloured input", "The panels alone"};
  static const std::array<ClusterSight, 4> kOrder = {ClusterSight::Regions, ClusterSight::Beside,
                                                     ClusterSight::Over, ClusterSight::Panels};
  const auto now = std::find(kOrder.begin(), kOrder.end(), desk.state.view_options.cluster_sight);
  int sight = static_cast<int>(now - kOrder.begin());
  if (desk.ui.segmented("sight", kSights, sight, kAbout))
    desk.state.view_options.cluster_sight = kOrder[static_cast<std::size_t>(sight)];
}

}  // namespace

std::string clusters_summary(const Desk& desk) {
  const AppState& state = desk.state;
  if (state.clustering()) return "clustering…";
  return state.clusters() ? format_count(state.clusters()->regions.count(), "region", "regions") : "none";
}

void draw_clusters(Desk& desk) {
  draw_count(desk);
  draw_outcome(desk);
  desk.ui.gap(4);
  draw_metric(desk);
  draw_seeds(desk);
  desk.ui.gap(6);
  draw_hand_tools(desk);
  desk.ui.gap(4);
  draw_sight(desk);
}

}  // namespace planewright::ui
