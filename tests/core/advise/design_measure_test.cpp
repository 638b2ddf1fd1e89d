#include "core/advise/design_measure.h"

#include <gtest/gtest.h>

#include "support/advised.h"
#include "support/findings.h"

namespace planewright {
namespace {

using test::planarizing;
using test::Scene;

Advised design_of(const Scene& scene, const PolygonMesh& mesh) {
  return {std::make_shared<PolygonMesh>(mesh), scene.complex, scene.state, planarizing()};
}

TEST(DesignMeasure, OfACleanDesignIsNothing) {
  const Scene scene = Scene::flat_grid(4, 4);
  const Advised design = design_of(scene, test::grid(4, 4).mesh());
  const DesignMeasure measure = measure_design(design, diagnose(*scene.complex, scene.state)).value();
  EXPECT_EQ(measure.panels, 16);
  EXPECT_EQ(measure.points, 25);
  EXPECT_EQ(measure.unbuildable(), 0);
  EXPECT_EQ(measure.score.crossing, 0.0);
  EXPECT_NEAR(total(measure.score), 0.0, 1e-20);
}

TEST(DesignMeasure, CountsFindingsByKindAndAddsTheEnergy) {
  Scene scene = Scene::flat_grid(2, 1);
  scene.put(2, 0.3, 0.0);  // the second quad lies on the first
  scene.put(5, 0.3, 1.0);
  const Advised design = design_of(scene, test::grid(2, 1).mesh());
  const Diagnosis diagnosis = diagnose(*scene.complex, scene.state);
  const DesignMeasure measure = measure_design(design, diagnosis).value();
  int unbuildable = 0;
  for (const FindingKind kind : all_finding_kinds()) {
    EXPECT_EQ(measure.findings[static_cast<size_t>(kind)], diagnosis.count(kind)) << info(kind).name;
    if (is_unbuildable(kind)) unbuildable += diagnosis.count(kind);
  }
  EXPECT_EQ(measure.unbuildable(), unbuildable);
  EXPECT_GE(unbuildable, 2);
  // All but the energy is the score of the whole; the energy is the problem's.
  Score score = defects_of(*scene.complex, scene.state, whole_region(*scene.complex));
  const auto problem = build_problem(scene.complex, design.settings).value();
  score.energy = problem->objective(problem->from_state(scene.state).data());
  EXPECT_GT(score.energy, 0.0);
  EXPECT_EQ(measure.score, score);
}

TEST(DesignMeasure, KnowsWhatNoWorkshopCanBuild) {
  for (const FindingKind kind : all_finding_kinds()) {
    const bool expected = kind == FindingKind::ClosePoints || kind == FindingKind::SelfCrossing ||
                          kind == FindingKind::FoldedOver || kind == FindingKind::CrossingPanels;
    EXPECT_EQ(is_unbuildable(kind), expected) << info(kind).name;
    if (expected) {
      EXPECT_TRUE(calls_for_edits(kind)) << info(kind).name;
    }
  }
}

TEST(DesignMeasure, FailsAsTheProblemDoes) {
  const Scene scene = Scene::flat_grid(2, 1);
  Advised design = design_of(scene, test::grid(2, 1).mesh());
  design.settings.demands.list = {{"convex", true, "nowhere", {}}};
  EXPECT_FALSE(measure_design(design, diagnose(*scene.complex, scene.state)));
}

}  // namespace
}  // namespace planewright
