#include "cli/layer_crossings.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "core/diagnose/crossings.h"

namespace planewright::cli {
namespace {

// In the frame of the first layer, so that a model far from 0 loses no digits.
struct Built {
  Points panels;
  std::optional<Points> offset;
  const Polygons* polygons;
  double touch;
};

Built built(const SolvedLayer& layer, const SolveRecord& record, const Vector3d& origin) {
  const auto shift = (layer.complex->origin - origin).transpose().eval();
  Built out{layer.state.x.rowwise() + shift,
            {},
            &layer.complex->panels,
            record.settings.demands.margin * layer.complex->mean_edge};
  if (layer.offset) out.offset = layer.offset->x.rowwise() + shift;
  return out;
}

int pairs(const Points& a, const Built& of_a, const Points& b, const Built& of_b) {
  const double touch = std::min(of_a.touch, of_b.touch);
  return static_cast<int>(find_crossings({a, *of_a.polygons}, {b, *of_b.polygons}, touch).size());
}

// Of the offset of `a` with the panels of `b` and their offset.
int offset_pairs(const Built& a, const Built& b) {
  return pairs(*a.offset, a, b.panels, b) + (b.offset ? pairs(*a.offset, a, *b.offset, b) : 0);
}

int offset_and_mesh(const SolvedLayer& layer, const SolveRecord& record) {
  const TangentComplex& complex = *layer.complex;
  const auto crossings =
      find_crossings({layer.offset->x, complex.panels}, {complex.input.vertices, complex.input.faces},
                     record.settings.demands.margin * complex.mean_edge);
  const auto& waived = record.settings.demands.waived;
  return static_cast<int>(std::count_if(crossings.begin(), crossings.end(), [&](const Crossing& crossing) {
    const Waiver here{"no-penetration", {ElementKind::Panel, crossing.first}};
    return std::find(waived.begin(), waived.end(), here) == waived.end();
  }));
}

// One thing that crosses another. `forbidden`: one of the layers is to penetrate nothing.
using Tell = std::function<void(const std::string& one, const std::string& other, int pairs, bool forbidden)>;

void for_each_crossing(const std::vector<SolveRecord>& records, const Tell& tell) {
  const auto index_of = [&](const std::string& name) {
    return std::find_if(records.begin(), records.end(),
                        [&](const SolveRecord& record) { return record.layer == name; }) -
           records.begin();
  };
  for (size_t k = 0; k < records.size(); ++k) {
    const SolveRecord& record = records[k];
    const bool clear = record.settings.no_penetration;
    const std::string layer = record.layer.empty() ? "" : "layer " + record.layer;
    const auto forbidden = [&](const std::string& other) {
      return clear || records[static_cast<size_t>(index_of(other))].settings.no_penetration;
    };
    for (const auto& [other, count] : record.crosses)
      if (count > 0 && index_of(other) < static_cast<std::ptrdiff_t>(k))  // once for both
        tell(layer, "layer " + other, count, forbidden(other));
    if (!record.offset_layer) continue;
    const std::string offset = layer.empty() ? "the offset" : "the offset of " + layer;
    if (record.offset_layer->crossings > 0) tell(offset, "the mesh", record.offset_layer->crossings, clear);
    for (const auto& [other, count] : record.offset_layer->crosses)
      if (count > 0) tell(offset, "layer " + other, count, forbidden(other));
  }
}

}  // namespace

void count_crossings(const std::vector<SolvedLayer>& layers, std::vector<SolveRecord>& records) {
  std::vector<Built> all;
  for (size_t k = 0; k < layers.size(); ++k)
    all.push_back(built(layers[k], records[k], layers.front().complex->origin));
  for (size_t a = 0; a < all.size(); ++a) {
    SolveRecord& record = records[a];
    if (record.offset_layer) record.offset_layer->crossings = offset_and_mesh(layers[a], record);
    for (size_t b = 0; b < all.size(); ++b) {
      if (a == b) continue;
      if (a < b) {
        const int count = pairs(all[a].panels, all[a], all[b].panels, all[b]);
        record.crosses.emplace_back(records[b].layer, count);
        records[b].crosses.emplace_back(record.layer, count);
      }
      if (record.offset_layer)
        record.offset_layer->crosses.emplace_back(records[b].layer, offset_pairs(all[a], all[b]));
    }
  }
}

void print_crossings(const std::vector<SolveRecord>& records) {
  for_each_crossing(records, [](const std::string& one, const std::string& other, int count, bool) {
    std::printf("%s crosses %s: %d pairs\n", one.c_str(), other.c_str(), count);
  });
}

ExitStatus judge_crossings(const std::vector<SolveRecord>& records) {
  ExitStatus status = kSuccess;
  for_each_crossing(records,
                    [&](const std::string& one, const std::string& other, int count, bool forbidden) {
                      if (!forbidden) return;
                      std::fprintf(stderr, "planewright-cli: warning: %s crosses %s: %d pairs\n", one.c_str(),
                                   other.c_str(), count);
                      status = kNotMet;
                    });
  return status;
}

}  // namespace planewright::cli
