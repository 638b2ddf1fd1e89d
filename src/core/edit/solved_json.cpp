#include "core/edit/solved_json.h"

#include <cmath>
#include <utility>

#include "core/design/design.h"

namespace planewright {
namespace {

using Json = nlohmann::json;
using Written = nlohmann::ordered_json;

constexpr double kUnit = 1e-9;  // by how much the square of a normal may differ from 1

Written rows_json(const Points& points) {
  Written rows = Written::array();
  for (Eigen::Index k = 0; k < points.rows(); ++k) rows.push_back({points(k, 0), points(k, 1), points(k, 2)});
  return rows;
}

State read_state(JsonReading& reading, JsonObject& object) {
  State state;
  if (const Json* x = object.needed("points")) state.x = reading.points(*x, object.path_of("points"));
  if (const Json* n = object.needed("normals")) state.n = reading.points(*n, object.path_of("normals"));
  if (const Json* h = object.needed("offsets")) {
    const std::vector<double> offsets = reading.numbers(*h, object.path_of("offsets"));
    state.h = Eigen::Map<const Vector>(offsets.data(), static_cast<Eigen::Index>(offsets.size()));
  }
  return state;
}

// Why the state is none of the complex; empty: it is one.
std::string misfit(const State& state, const TangentComplex& complex) {
  const auto differ = [](const char* what, Eigen::Index has, int wanted) {
    return "they have " + std::to_string(has) + " " + what + ", but mesh and settings make " +
           std::to_string(wanted);
  };
  if (state.x.rows() != complex.point_count()) return differ("points", state.x.rows(), complex.point_count());
  if (state.n.rows() != complex.plane_count())
    return differ("normals", state.n.rows(), complex.plane_count());
  if (state.h.size() != complex.plane_count())
    return differ("offsets", state.h.size(), complex.plane_count());
  for (Eigen::Index i = 0; i < state.n.rows(); ++i)
    if (!(std::abs(state.n.row(i).squaredNorm() - 1.0) <= kUnit))
      return "normal " + std::to_string(i) + " is not of length 1";
  return {};
}

int count_of(const TangentComplex& complex, ElementKind kind) {
  return kind == ElementKind::Point   ? complex.point_count()
         : kind == ElementKind::Panel ? complex.plane_count()
                                      : static_cast<int>(complex.panel_edges.size());
}

void check_waivers(JsonReading& reading, const Layer& layer, const std::string& path,
                   const TangentComplex& complex) {
  for (std::size_t k = 0; k < layer.settings.demands.waived.size(); ++k) {
    const ElementRef& element = layer.settings.demands.waived[k].element;
    if (element.index >= count_of(complex, element.kind))
      reading.fail(entry_path(path + ".settings.demands.waived", k) + ".index",
                   "the panels of this layer have no " + text(element));
  }
}

}  // namespace

Written solved_json(const std::vector<std::optional<State>>& solved) {
  Written json = Written::array();
  for (std::size_t k = 0; k < solved.size(); ++k) {
    if (!solved[k]) continue;
    const State& state = *solved[k];
    json.push_back({{"layer", k},
                    {"points", rows_json(state.x)},
                    {"normals", rows_json(state.n)},
                    {"offsets", std::vector<double>(state.h.begin(), state.h.end())}});
  }
  return json;
}

std::vector<std::optional<State>> read_solved(JsonReading& reading, const Json* json, const std::string& path,
                                              const PolygonMesh& mesh, const Regions* regions,
                                              const Design& design) {
  const std::size_t layers = design.layers.size();
  std::vector<std::optional<State>> solved(layers);
  if (json && !reading.list(*json, path)) return solved;
  std::vector<std::string> place_of(layers);
  for (std::size_t k = 0; json && k < json->size() && !reading.failed(); ++k) {
    JsonObject object(reading, &(*json)[k], entry_path(path, k));
    int layer = 0;
    if (object.needed("layer")) object.read("layer", layer, 0, static_cast<int>(layers) - 1);
    if (solved[static_cast<std::size_t>(layer)])
      object.fail("layer", "the panels of layer " + std::to_string(layer) + " are there twice");
    solved[static_cast<std::size_t>(layer)] = read_state(reading, object);
    place_of[static_cast<std::size_t>(layer)] = entry_path(path, k);
  }
  for (std::size_t k = 0; k < layers && !reading.failed(); ++k) {
    const Layer& layer = design.layers[k];
    if (!solved[k] && layer.settings.demands.waived.empty()) continue;
    const auto complex = build_complex(mesh, layer.settings, regions);
    if (complex) check_waivers(reading, layer, entry_path("design.layers", k), **complex);
    if (!solved[k]) continue;
    const std::string why = complex ? misfit(*solved[k], **complex) : complex.error().text();
    if (why.empty()) continue;
    solved[k].reset();
    reading.warn(place_of[k], "the solved panels of layer '" + layer.name +
                                  "' are left out and have to be solved again: " + why);
  }
  return solved;
}

}  // namespace planewright
