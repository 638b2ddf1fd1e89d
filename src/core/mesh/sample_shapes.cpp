#include "core/mesh/sample_shapes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/mesh/sample_grids.h"

namespace planewright {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kFewestPanels = 8;
constexpr int kMostPanels = 4'000'000;

// exp(-(x / width)^2)
double bump(double x, double width) {
  return std::exp(-(x / width) * (x / width));
}

// Surfaces over u, v in -1 .. 1 (the disc for the dome), z up. None has a flat spot: panels there would have
// no say in where the dual's points lie.

// Ring of radius R = 1 and tube r = 0.4: ((R + r cos b) cos a, (R + r cos b) sin a, r + r sin b), a = pi u, b
// = pi v.
Vector3d torus(double u, double v) {
  const double a = kPi * u, b = kPi * v, radius = 1.0 + 0.4 * std::cos(b);
  return {radius * std::cos(a), radius * std::sin(a), 0.4 + 0.4 * std::sin(b)};
}

// Cap of a sphere, 24 m wide and 7 m high: on the disc, colatitude = |(u, v)| * the cap's opening angle.
Vector3d dome(double u, double v) {
  constexpr double half_width = 12.0, rise = 7.0;
  const double radius = (half_width * half_width + rise * rise) / (2.0 * rise);
  const double opening = std::asin(half_width / radius);
  const double t = std::hypot(u, v), horizontal = t > 0.0 ? radius * std::sin(opening * t) / t : 0.0;
  return {horizontal * u, horizontal * v, radius * (std::cos(opening * t) - std::cos(opening))};
}

// Barrel vault, 12 m wide and 24 m long: circular arches of 150 degrees, (a sin w, y, a (cos w - cos 75)),
// whose radius a shrinks by a quarter from the middle to both ends, so that ridge and sides are gently bowed.
// A cylinder proper is curved in one direction only, and neighbouring tangent planes would not meet in
// points.
Vector3d vault(double u, double v) {
  const double opening = 75.0 * kPi / 180.0;
  const double radius = 6.0 / std::sin(opening) * (1.0 - 0.25 * u * u), w = opening * v;
  // The arches stand across the length: u runs along, v across.
  return {12.0 * u, radius * std::sin(w), radius * (std::cos(w) - std::cos(opening))};
}

// Hyperbolic paraboloid over 20 m x 16 m: z = 2 + 2.4 u^2 - 2 v^2.
Vector3d saddle_roof(double u, double v) {
  return {10.0 * u, 8.0 * v, 2.0 + 2.4 * u * u - 2.0 * v * v};
}

// Waves along the length over a gentle arch across, 30 m x 16 m: z = 1.2 (1 + cos 3 pi u) + 2.5 (1 - v^2).
Vector3d wave_roof(double u, double v) {
  return {15.0 * u, 8.0 * v, 1.2 * (1.0 + std::cos(3.0 * kPi * u)) + 2.5 * (1.0 - v * v)};
}

// Steep ridge that rises to both gables, flared eaves, and a plan that runs out to a prow under the ridge:
// y = 6 v (1 - 0.18 u^2), z = 6.5 (1 + 0.22 v^2) / (1 + (u / 0.5)^2), x = 5 u.
Vector3d alpine_hut(double u, double v) {
  return {5.0 * u, 6.0 * v * (1.0 - 0.18 * u * u), 6.5 * (1.0 + 0.22 * v * v) / (1.0 + 4.0 * u * u)};
}

// Concourse, 60 m long, with a high and wide hall in the middle and two bays to each side: half width
// b = 8 (1 + 0.8 bump(u, 0.25)), height h = 5 + 3.5 bump(u, 0.3) + 1.5 sum bump(|u| - 0.5, 0.13) + bump(|u| -
// 0.87, 0.13), z = h (1 - v^2), x = 30 u, y = b v.
Vector3d train_station(double u, double v) {
  const double bays = 1.5 * (bump(std::abs(u) - 0.5, 0.13) + bump(std::abs(u) - 0.87, 0.13));
  const double height = 5.0 + 3.5 * bump(u, 0.3) + bays;
  return {30.0 * u, 8.0 * (1.0 + 0.8 * bump(u, 0.25)) * v, height * (1.0 - v * v)};
}

// Arched strip, 24 m long and 8 m wide, that turns by 70 degrees about its long axis: the section
// (4 v, 1.2 (1 - v^2)) turned by 35 degrees * u.
Vector3d twisted_roof(double u, double v) {
  const double angle = 35.0 * kPi / 180.0 * u, across = 4.0 * v, up = 1.2 * (1.0 - v * v);
  return {12.0 * u, across * std::cos(angle) - up * std::sin(angle),
          across * std::sin(angle) + up * std::cos(angle)};
}

// Saddle over 20 m x 16 m, six times as bent along x as along y: z = 0.06 x^2 - 0.01 y^2. Equilateral
// triangles fit it; of a slanting edge flipped, the dual edge runs backwards, most so near x = 0.
Vector3d saddle(double u, double v) {
  const double x = 10.0 * u, y = 8.0 * v;
  return {x, y, 0.06 * x * x - 0.01 * y * y};
}

// Strips over the hyperbolic paraboloid z = 0.06 (x^2 - y^2), 4 m wide and 5 pi m long: one along its axis x
// of curvature, and one that turns by 90 degrees on a quarter of a circle, from the one axis to the other.
double paraboloid(double x, double y) {
  return 0.06 * (x * x - y * y);
}
Vector3d straight_strip(double u, double v) {
  const double x = 2.5 * kPi * u, y = 2.0 * v;
  return {x, y, paraboloid(x, y)};
}
Vector3d turning_strip(double u, double v) {
  const double radius = 10.0 - 2.0 * v, angle = kPi / 4.0 * (1.0 + u);
  const double x = radius * std::sin(angle), y = -radius * std::cos(angle);
  return {x, y, paraboloid(x, y)};
}

using Surface = std::function<Vector3d(double u, double v)>;

// Lowers (or raises) the surface until its lowest vertex stands on the ground.
PolygonMesh draw(const Pattern& pattern, const Surface& surface) {
  Points positions(pattern.uv.rows(), 3);
  for (Eigen::Index i = 0; i < positions.rows(); ++i)
    positions.row(i) = surface(pattern.uv(i, 0), pattern.uv(i, 1));
  positions.col(2).array() -= positions.col(2).minCoeff();
  return PolygonMesh::from_polygons(positions, pattern.faces).value();
}

// `length_ratio`: length along u over length along v, about.
GridSize staggered_size(int panels, double length_ratio) {
  // Equilateral triangles: the rows stand sqrt(3)/2 steps apart. An even number of strips keeps the symmetry.
  return fit_grid(panels, length_ratio * std::sqrt(3.0) / 2.0, {2, 1}, 2,
                  [](std::int64_t rows, std::int64_t columns) {
                    return (rows / 2 + 1) * (columns + 1) + rows / 2 * (columns + 2);
                  });
}
Pattern fit_staggered(int panels, double length_ratio) {
  const GridSize size = staggered_size(panels, length_ratio);
  return staggered_triangles(size.rows, size.columns);
}

Pattern fit_diagonal(int panels, double length_ratio) {
  const GridSize size =
      fit_grid(panels, length_ratio, {1, 1}, 1,
               [](std::int64_t rows, std::int64_t columns) { return (rows + 1) * (columns + 1); });
  return diagonal_triangles(size.rows, size.columns);
}

GridSize quads_size(int panels, double length_ratio) {
  return fit_grid(panels, length_ratio, {1, 1}, 1,
                  [](std::int64_t rows, std::int64_t columns) { return rows * columns; });
}
Pattern fit_quads(int panels, double length_ratio) {
  const GridSize size = quads_size(panels, length_ratio);
  return quads(size.rows, size.columns);
}

Pattern fit_torus(int panels, double length_ratio) {
  const GridSize size = fit_grid(panels, length_ratio * std::sqrt(3.0) / 2.0, {4, 3}, 2,
                                 [](std::int64_t rows, std::int64_t columns) { return rows * columns; });
  return torus_triangles(size.rows, size.columns);
}

int disc_rings(int panels) {
  const auto count = [](double rings) { return 1.0 + 3.0 * rings * (rings + 1.0); };
  int rings = 1;
  while (std::abs(count(rings + 1) - panels) < std::abs(count(rings) - panels)) ++rings;
  return rings;
}
Pattern fit_disc(int panels) {
  return hexagonal_disc(disc_rings(panels));
}

// --- Planted places ---------------------------------------------------------------------------------------

constexpr double kSaddleRatio = 1.25;
constexpr double kStripRatio = 4.0;
// On coarser grids the flaws are lost among the panels of the border.
constexpr int kFewestWithFlaws = 200;

// The dome's inner rings, up to this one, are cut off flat.
int flat_rings(int panels) {
  return static_cast<int>(std::lround(0.6 * disc_rings(panels)));
}

PolygonMesh flat_patch_dome(int panels) {
  const double cut = static_cast<double>(flat_rings(panels)) / disc_rings(panels);
  return draw(fit_disc(panels), [cut](double u, double v) {
    Vector3d at = dome(u, v);
    if (std::hypot(u, v) < cut) at.z() = dome(cut, 0.0).z();
    return at;
  });
}

// Vertices of the inner rings have faces in the flat patch alone, and panels in its plane; so the points of
// faces between them are on three planes that are one.
std::vector<PlantedPlace> flat_patch(const PolygonMesh& mesh, int panels) {
  if (panels < kFewestWithFlaws) return {};
  const int rings = flat_rings(panels) - 1, inner = 1 + 3 * rings * (rings + 1);
  const Polygons faces = mesh.faces();
  std::vector<PlantedPlace> places;
  for (int f = 0; f < faces.size(); ++f)
    if (std::all_of(faces[f].begin(), faces[f].end(), [&](int v) { return v < inner; }))
      places.push_back({"flat patch, whose planes are one", {}, {f}});
  return places;
}

// Edges apart from each other and from the border, near x = 0.
bool runs_the_wrong_way(int row, int k, const GridSize& size) {
  return row % 4 == 0 && k % 4 == 2 && row >= 4 && row + 4 <= size.rows &&
         std::abs(2.0 * (k + 0.25) / size.columns - 1.0) < 0.4;
}

PolygonMesh bad_saddle(int panels) {
  const GridSize size = staggered_size(panels, kSaddleRatio);
  return draw(staggered_triangles(size.rows, size.columns,
                                  [&](int row, int k) { return runs_the_wrong_way(row, k, size); }),
              saddle);
}

std::vector<PlantedPlace> wrong_edges(const PolygonMesh& mesh, int panels) {
  if (panels < kFewestWithFlaws) return {};
  const GridSize size = staggered_size(panels, kSaddleRatio);
  std::vector<PlantedPlace> places;
  for (int row = 0; row < size.rows; ++row)
    for (int k = 0; k < size.columns; ++k) {
      if (!runs_the_wrong_way(row, k, size)) continue;
      // Such rows are even; so many vertices lie below the row and the shifted one after it.
      const int plain = staggered_vertex_count(row, size.columns) - (size.columns + 1);
      const int shifted = plain + size.columns + 1;
      places.push_back({"edge flipped the wrong way", {mesh.find_edge(shifted + k, plain + k + 1)}, {}});
    }
  return places;
}

// Where the strip runs along the asymptotic direction of the paraboloid, in the middle of the turn, its quads
// would have to have parallel sides to be planar.
std::vector<PlantedPlace> turning_point(const PolygonMesh&, int panels) {
  const GridSize size = quads_size(panels, kStripRatio);
  PlantedPlace place{"turning point of the strip", {}, {}};
  for (int row = 0; row < size.rows; ++row)
    for (int column = 0; column < size.columns; ++column)
      if (3 * column >= size.columns && 3 * (column + 1) <= 2 * size.columns)
        place.faces.push_back(row * size.columns + column);
  return {place};
}

struct Sample {
  SampleInfo info;
  std::function<PolygonMesh(int panels)> make;
  std::function<std::vector<PlantedPlace>(const PolygonMesh& mesh, int panels)> planted = {};
};

const std::vector<Sample>& catalogue() {
  static const std::vector<Sample> kSamples = {
      {{"torus", "closed ring: curvature of both signs, no border", true, 1000},
       [](int n) { return draw(fit_torus(n, 2.5), torus); }},
      {{"dome", "cap of a sphere, 24 m wide, on a six-fold ring pattern", true, 547},
       [](int n) { return draw(fit_disc(n), dome); }},
      {{"vault", "barrel vault, 24 m long, with a gently bowed ridge", true, 600},
       [](int n) { return draw(fit_staggered(n, 1.55), vault); }},
      {{"saddle-roof", "hyperbolic paraboloid over a rectangle of 20 m x 16 m", true, 500},
       [](int n) { return draw(fit_staggered(n, 1.25), saddle_roof); }},
      {{"wave-roof", "three waves along 30 m, arched across", true, 800},
       [](int n) { return draw(fit_staggered(n, 2.1), wave_roof); }},
      {{"alpine-hut", "shelter of 10 m x 12 m with a steep sagging ridge and flared eaves", true, 500},
       [](int n) { return draw(fit_staggered(n, 1.4), alpine_hut); }},
      {{"train-station", "concourse of 60 m with five bays, triangulated symmetrically", true, 900},
       [](int n) { return draw(fit_staggered(n, 2.6), train_station); }},
      {{"train-station-unsymmetric", "the same concourse with all diagonals running the same way", true, 900},
       [](int n) { return draw(fit_diagonal(n, 2.6), train_station); }},
      {{"twisted-roof", "arched strip of 24 m that turns by 70 degrees, as quads", false, 300},
       [](int n) { return draw(fit_quads(n, 3.0), twisted_roof); }},
      {{"saddle", "saddle over 20 m x 16 m, bent more along than across", true, 400},
       [](int n) { return draw(fit_staggered(n, kSaddleRatio), saddle); }},
      {{"straight-strip", "strip of quads along an axis of a saddle", false, 144},
       [](int n) { return draw(fit_quads(n, kStripRatio), straight_strip); }},
      {{"flat-patch-dome", "flawed on purpose: the dome with a flat patch in its middle", true, 547, "dome"},
       flat_patch_dome,
       flat_patch},
      {{"bad-saddle", "flawed on purpose: the saddle with edges flipped the wrong way", true, 400, "saddle"},
       bad_saddle,
       wrong_edges},
      {{"turning-strip", "flawed on purpose: the strip turns by 90 degrees on its saddle", false, 144,
        "straight-strip"},
       [](int n) { return draw(fit_quads(n, kStripRatio), turning_strip); },
       turning_point},
  };
  return kSamples;
}

// What make_sample and planted_places refuse; panels: the default if 0.
Result<const Sample*> find_sample(std::string_view name, int& panels) {
  std::string known;
  for (const Sample& sample : catalogue()) {
    known += (known.empty() ? "" : ", ") + std::string(sample.info.name);
    if (sample.info.name != name) continue;
    if (panels == 0) panels = sample.info.default_panels;
    if (panels < kFewestPanels || panels > kMostPanels)
      return fail(ErrorCode::Usage, "a sample cannot have " + std::to_string(panels) + " panels", {},
                  "Ask for " + std::to_string(kFewestPanels) + " to " + std::to_string(kMostPanels));
    return &sample;
  }
  return fail(ErrorCode::Usage, "there is no sample named \"" + std::string(name) + "\"", {},
              "Known: " + known);
}

}  // namespace

const std::vector<SampleInfo>& samples() {
  static const std::vector<SampleInfo> kInfos = [] {
    std::vector<SampleInfo> infos;
    for (const Sample& sample : catalogue()) infos.push_back(sample.info);
    return infos;
  }();
  return kInfos;
}

Result<PolygonMesh> make_sample(std::string_view name, int panels) {
  const auto sample = find_sample(name, panels);
  if (!sample) return tl::unexpected(sample.error());
  return (*sample)->make(panels);
}

Result<std::vector<PlantedPlace>> planted_places(std::string_view name, int panels) {
  const auto sample = find_sample(name, panels);
  if (!sample) return tl::unexpected(sample.error());
  if (!(*sample)->planted) return std::vector<PlantedPlace>{};
  return (*sample)->planted((*sample)->make(panels), panels);
}

PolygonMesh make_torus(int rows, int columns) {
  return draw(torus_triangles(std::max(rows, 3), std::max(columns, 3)), torus);
}

}  // namespace planewright
