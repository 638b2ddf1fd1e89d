#include "core/diagnose/diagnosis.h"

#include <gtest/gtest.h>

#include <set>

#include "core/design/design.h"
#include "core/mesh/mesh_io.h"
#include "core/solve/solver_choice.h"
#include "support/findings.h"
#include "support/shared_meshes.h"

namespace planewright {
namespace {

using namespace test;

// Several kinds at once.
Scene spoilt_grid() {
  Scene scene = Scene::flat_grid(6, 6);
  scene.put(8, 2.0, 1.0);
  scene.put(9, 1.0, 1.0);
  scene.put(24, 3.0, 5.2);
  scene.put(32, 4.9, 4.0);
  scene.put(26, 4.95, 4.0);
  return scene;
}

std::vector<std::pair<FindingKind, ElementRef>> list(const std::vector<Finding>& findings) {
  std::vector<std::pair<FindingKind, ElementRef>> all;
  for (const Finding& finding : findings) all.emplace_back(finding.kind, finding.element);
  return all;
}

TEST(Diagnosis, OfAStateThatIsNotPlanarSaysSo) {
  const SharedComplex complex = planarize_of(twisted_grid(3, 3).mesh());
  const Diagnosis diagnosis = diagnose(*complex, initial_state(*complex));
  EXPECT_FALSE(diagnosis.solved);
  EXPECT_GT(diagnosis.off_planes, 1e-3);
  EXPECT_TRUE(diagnosis.findings.empty());
  State broken = initial_state(*complex);
  broken.x(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(diagnose(*complex, broken).solved);
  FindingSettings loose;
  loose.planar = 10.0;
  EXPECT_TRUE(diagnose(*complex, initial_state(*complex), loose).solved);
}

TEST(Diagnosis, OfACleanPlanarStateIsEmpty) {
  for (const Scene& scene : {Scene::flat_grid(4, 4), Scene(planarize_of(cube().mesh()))}) {
    FindingSettings settings;
    settings[FindingKind::IllDetermined].on = false;  // all of a flat design is
    const Diagnosis diagnosis = diagnose(*scene.complex, scene.state, settings);
    EXPECT_TRUE(diagnosis.solved);
    EXPECT_TRUE(diagnosis.findings.empty());
  }
}

TEST(FindAll, SortsByKindAndThenWorstFirst) {
  const Scene scene = spoilt_grid();
  const auto findings = find_all(*scene.complex, scene.state);
  std::set<FindingKind> kinds;
  for (size_t k = 0; k < findings.size(); ++k) {
    expect_well_formed(findings[k]);
    kinds.insert(findings[k].kind);
    if (k == 0) continue;
    EXPECT_LE(findings[k - 1].kind, findings[k].kind);
    if (findings[k - 1].kind == findings[k].kind) {
      EXPECT_GE(findings[k - 1].severity, findings[k].severity);
    }
  }
  for (const FindingKind kind :
       {FindingKind::IllDetermined, FindingKind::ClosePoints, FindingKind::ReversedEdge,
        FindingKind::SelfCrossing, FindingKind::FoldedOver, FindingKind::NotConvex, FindingKind::FarPoint,
        FindingKind::CollapsedQuad})
    EXPECT_TRUE(kinds.contains(kind)) << info(kind).name;
  EXPECT_EQ(list(findings), list(find_all(*scene.complex, scene.state)));
  // Equal places by their index.
  const auto flat = find_all(*scene.complex, initial_state(*scene.complex));
  for (size_t k = 1; k < flat.size(); ++k) EXPECT_LT(flat[k - 1].element.index, flat[k].element.index);
}

TEST(FindAll, LeavesOutWhatIsOffAndNothingElse) {
  const Scene scene = spoilt_grid();
  const auto all = find_all(*scene.complex, scene.state);
  for (const FindingKind off : all_finding_kinds()) {
    FindingSettings settings;
    settings[off].on = false;
    auto expected = list(all);
    std::erase_if(expected, [&](const auto& entry) { return entry.first == off; });
    EXPECT_EQ(list(find_all(*scene.complex, scene.state, settings)), expected) << info(off).name;
  }
}

TEST(FindAll, KnowsBeamsOnlyWithAnotherLayer) {
  const Scene scene = Scene::flat_grid(2, 2);
  State other = scene.state;
  other.x.col(0).swap(other.x.col(1));
  other.x.col(2).array() += 1.0;
  const NeighbourLayer neighbour{scene.complex, other};
  EXPECT_EQ(diagnose(*scene.complex, scene.state).count(FindingKind::TwistedBeam), 0);
  EXPECT_EQ(diagnose(*scene.complex, scene.state, {}, &neighbour).count(FindingKind::TwistedBeam), 12);
}

// --- Solved designs ---------------------------------------------------------------------------------------

struct Solved {
  SharedComplex complex;
  State state;
};

Solved solved(const PolygonMesh& mesh, double offset = 0.0) {
  LayerSettings settings;
  settings.mode = suggested_mode(mesh);
  settings.offset = offset;
  const SharedComplex complex = build_complex(mesh, settings).value();
  const auto problem = build_problem(complex, settings).value();
  const SolveReport report =
      make_solver(SolverKind::Tangent)
          ->solve(*problem, start_state(*complex, settings), solve_options(settings), nullptr, {});
  EXPECT_EQ(report.status, SolveStatus::Converged) << report.stop_reason;
  return {complex, report.state};
}

bool at(const PlantedPlace& place, const Finding& finding, const TangentComplex& complex) {
  for (const int edge : finding.mesh_edges)
    if (std::binary_search(place.edges.begin(), place.edges.end(), edge)) return true;
  int face = -1;
  if (finding.element.kind == ElementKind::Point) face = complex.face_of_point[finding.element.index];
  if (finding.element.kind == ElementKind::Panel && complex.kind == ComplexKind::Planarize)
    face = complex.plane_origin[finding.element.index];
  return std::binary_search(place.faces.begin(), place.faces.end(), face);
}

class PlantedPlaces : public testing::TestWithParam<std::string_view> {};

TEST_P(PlantedPlaces, AreAllFoundAndNoneInTheCleanDesign) {
  const auto sample = std::find_if(samples().begin(), samples().end(),
                                   [](const SampleInfo& s) { return s.name == GetParam(); });
  for (const int panels : {0, 200, 300, 700}) {
    const auto places = planted_places(sample->name, panels).value();
    EXPECT_FALSE(places.empty()) << panels;
    const Solved bad = solved(make_sample(sample->name, panels).value());
    const Diagnosis diagnosis = diagnose(*bad.complex, bad.state);
    EXPECT_TRUE(diagnosis.solved);
    for (const PlantedPlace& place : places)
      EXPECT_TRUE(std::any_of(diagnosis.findings.begin(), diagnosis.findings.end(),
                              [&](const Finding& finding) { return at(place, finding, *bad.complex); }))
          << panels << ": " << place.what
          << (place.edges.empty() ? "" : ", edge " + std::to_string(place.edges[0]));
    const Solved clean = solved(make_sample(sample->flaw_of, panels).value());
    for (const Finding& finding : diagnose(*clean.complex, clean.state).findings)
      ADD_FAILURE() << sample->flaw_of << " " << panels << ": " << info(finding.kind).name << " at "
                    << text(finding.element) << ", " << finding.measure;
  }
}
INSTANTIATE_TEST_SUITE_P(Samples, PlantedPlaces,
                         testing::Values("flat-patch-dome", "bad-saddle", "turning-strip"),
                         [](const auto& sample) {
                           std::string label(sample.param);
                           std::replace(label.begin(), label.end(), '-', '_');
                           return label;
                         });

// Rare, as they should be: the paper's kind of place at about one edge in a hundred.
TEST(Diagnosis, OfARealMeshMarksFewPlaces) {
  PLANEWRIGHT_SHARED_MESHES_OR_SKIP(meshes);
  const Solved bunny = solved(load_mesh((meshes / "tri/bunny1k.obj").string()).value().mesh);
  const Diagnosis diagnosis = diagnose(*bunny.complex, bunny.state);
  ASSERT_TRUE(diagnosis.solved);
  EXPECT_GE(diagnosis.count(FindingKind::ClosePoints), 5);
  EXPECT_LE(diagnosis.count(FindingKind::ClosePoints), 25);
  EXPECT_GE(diagnosis.count(FindingKind::ReversedEdge), 2);
  EXPECT_LE(diagnosis.count(FindingKind::ReversedEdge), 12);
  EXPECT_LE(diagnosis.count(FindingKind::IllDetermined), bunny.complex->point_count() / 40);
  EXPECT_LE(diagnosis.count(FindingKind::NotConvex), bunny.complex->plane_count() / 10);
}

}  // namespace
}  // namespace planewright
