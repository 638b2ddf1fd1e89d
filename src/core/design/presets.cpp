#include "core/design/presets.h"

#include <algorithm>

namespace planewright {
namespace {

// Low and high of [Z 4.1, Fig. 5]. The paper states "approximative relational sizes" alone; these are ours.
constexpr double kLow = 0.05, kHigh = 1.0;

// "llh": low position, low direction, high shape (edge and diagonal lengths). The order of the first two is
// our reading of the figure. As only ratios matter, LLL and HHH give the same panels.
Preset figure_five(const char* letters) {
  const auto weight = [&](int k) { return letters[k] == 'h' ? kHigh : kLow; };
  const auto word = [&](int k) { return std::string(letters[k] == 'h' ? "high" : "low"); };
  std::string label(letters);
  for (char& c : label) c = c == 'h' ? 'H' : 'L';
  return {letters,
          label,
          "Figure 5 of the paper: position " + word(0) + ", edge direction " + word(1) +
              ", lengths of edges and diagonals " + word(2) + ".",
          "4.1, figure 5",
          false,
          true,
          true,
          {{"position", weight(0)},
           {"edge-direction", weight(1)},
           {"edge-length", weight(2)},
           {"diagonal-length", weight(2)}},
          {}};
}

std::vector<Preset> make_presets() {
  std::vector<Preset> table = {
      {"close-to-design",
       "Close to the design",
       "Every corner as near its wanted place as planar panels allow.",
       "2.1",
       true,
       true,
       true,
       {{"position", 1.0}},
       {}},
      {"even-panels",
       "Even panels",
       "Panels of like size and regular shape, a little off the design.",
       "4.3",
       true,
       true,
       true,
       {{"position", 1.0}, {"fairing", 1.0}},
       {}},
      // Figure 7: normal smoothness rounds, fairing gathers the curvature in creases.
      {"smooth-shell",
       "Smooth shell",
       "Neighbouring panels turn little: the shell looks round.",
       "4.3, figure 7",
       true,
       true,
       true,
       {{"position", 0.1}, {"normal-smoothness", 1.0}},
       {}},
      {"faceted-shell",
       "Faceted shell",
       "Flat patches of regular panels between sharp creases.",
       "4.3, figure 7",
       true,
       true,
       true,
       {{"position", 0.1}, {"fairing", 1.0}},
       {}},
      {"close",
       "Strictly close",
       "Corners stay on the reference surface, free to slide along it.",
       "ours",
       true,
       true,
       true,
       {{"position", 0.05}, {"closeness", 1.0}},
       {}},
      {"proxy-planes",
       "Proxy planes",
       "Panels stay in the planes that fit the design best; corners go where these meet, near the design.",
       "4.2",
       false,
       true,
       true,
       {{"position", 0.1}, {"proxy-normal", 1.0}, {"offset", 10.0}},
       {}},
      {"blunt-corners",
       "Blunt corners",
       "As proxy planes, without edges next to no length and with fewer acute corners, a little off the "
       "design.",
       "ours",
       false,
       true,
       true,
       {{"position", 0.1}, {"proxy-normal", 1.0}, {"offset", 10.0}, {"corner-angle", 1.0}},
       {}},
      {"uncrossed",
       "Uncrossed quads",
       "Planar quads that never cross themselves, near the design.",
       "ours",
       false,
       true,
       false,
       {{"position", 1.0}},
       {{"uncrossed", true, {}, {}}}},
  };
  for (const char* letters : {"lll", "llh", "lhl", "lhh", "hll", "hlh", "hhl", "hhh"})
    table.push_back(figure_five(letters));
  return table;
}

}  // namespace

const std::vector<Preset>& presets() {
  static const std::vector<Preset> table = make_presets();
  return table;
}

Result<const Preset*> find_preset(const std::string& name) {
  std::string known;
  for (const Preset& preset : presets()) {
    if (preset.name == name) return &preset;
    known += (known.empty() ? "" : ", ") + preset.name;
  }
  return fail(ErrorCode::Usage, "there is no preset of the name '" + name + "'", "presets",
              "Known: " + known);
}

Result<void> apply(const Preset& preset, LayerSettings& settings) {
  if (!preset.fits(settings.mode)) {
    std::string fitting;
    for (const Preset& other : presets())
      if (other.fits(settings.mode)) fitting += (fitting.empty() ? "" : ", ") + other.name;
    return fail(ErrorCode::Usage,
                "the preset '" + preset.name + "' means nothing " +
                    (settings.mode == ComplexKind::Dual        ? "for a dual"
                     : settings.mode == ComplexKind::Planarize ? "when planarizing"
                                                               : "for panels of clusters"),
                "presets", "These fit: " + fitting);
  }
  settings.weights = preset.weights;
  for (const Demand& demand : preset.demands) set_demand(settings.demands.list, demand);
  return {};
}

void set_demand(std::vector<Demand>& list, Demand demand) {
  const auto same = std::find_if(list.begin(), list.end(), [&](const Demand& d) {
    return d.name == demand.name && d.selection == demand.selection;
  });
  if (same != list.end())
    *same = std::move(demand);
  else
    list.push_back(std::move(demand));
}

}  // namespace planewright
