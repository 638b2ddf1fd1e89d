// Projects of clusters: their regions and solved panels come back to the bit, and files that lie are refused.
#include <gtest/gtest.h>

#include "core/complex/state.h"
#include "core/design/design.h"
#include "core/edit/document.h"
#include "core/edit/project_file.h"
#include "core/edit/project_panels.h"
#include "core/mesh/sample_shapes.h"

namespace planewright {
namespace {

SharedClusters clustered(const std::shared_ptr<const PolygonMesh>& mesh) {
  ClusterOptions options;
  options.panels = 17;
  options.metric = {1.0, 30.0, 0.25};
  options.seeds = SeedKind::Random;
  options.seed_number = 4000000000u;
  options.target_normal = 1.0 / 3.0;
  return cluster_mesh(mesh, options).value();
}

// A solved design of clusters.
Project cluster_project() {
  Design design;
  design.layers.front().settings.mode = ComplexKind::Cluster;
  Project project = new_project("torus", make_sample("torus", 100).value(), design);
  const auto clusters = clustered(std::make_shared<const PolygonMesh>(project.mesh));
  project.clusters = record_of(*clusters);
  const auto complex =
      build_complex(project.mesh, design.layers.front().settings, &clusters->regions).value();
  State state = initial_state(*complex);
  state.x *= 1.0 + 1e-3 / 3.0;
  project.solved = {state};
  return project;
}

std::string text_of(const Project& project) {
  return format_project(project).value();
}

void expect_refused(const std::string& text, const std::string& what) {
  const auto read = read_project(text, "roof.planewright");
  ASSERT_FALSE(read) << what;
  EXPECT_EQ(read.error().code, ErrorCode::Unreadable);
  EXPECT_NE(read.error().text().find(what), std::string::npos) << read.error().text();
  EXPECT_NE(read.error().where.find("clusters"), std::string::npos) << read.error().where;
}

// The file with other regions.
std::string with_regions(std::vector<int> region_of_face) {
  Project project = cluster_project();
  project.clusters->region_of_face = std::move(region_of_face);
  project.solved.clear();
  return text_of(project);
}

TEST(ProjectClusters, AreMadeAgainToTheBit) {
  const auto mesh = std::make_shared<const PolygonMesh>(make_sample("dome", 300).value());
  for (const int panels : {5, 20, 60}) {
    ClusterOptions options;
    options.panels = panels;
    const SharedClusters first = cluster_mesh(mesh, options).value();
    const SharedClusters again = clusters_of(mesh, record_of(*first)).value();
    EXPECT_EQ(again->regions.region_of_face, first->regions.region_of_face);
    EXPECT_EQ(again->regions.corner_vertex, first->regions.corner_vertex);
    EXPECT_EQ(again->regions.repairs.size(), first->regions.repairs.size());
    for (int k = 0; k < first->regions.count(); ++k) {
      EXPECT_EQ(again->regions.proxies[k].centre, first->regions.proxies[k].centre);
      EXPECT_EQ(again->regions.proxies[k].normal, first->regions.proxies[k].normal);
    }
    EXPECT_EQ(again->options.panels, panels);
  }
}

TEST(ProjectClusters, ComeBackWithTheirPanels) {
  const Project project = cluster_project();
  const std::string text = text_of(project);
  const auto read = read_project(text, "x");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->warnings, std::vector<std::string>{});
  ASSERT_TRUE(read->project.clusters);
  const ClusterRecord &was = *project.clusters, &is = *read->project.clusters;
  EXPECT_EQ(is.region_of_face, was.region_of_face);
  EXPECT_EQ(is.options.panels, was.options.panels);
  EXPECT_EQ(is.options.metric, was.options.metric);
  EXPECT_EQ(is.options.seeds, was.options.seeds);
  EXPECT_EQ(is.options.seed_number, was.options.seed_number);
  EXPECT_EQ(is.options.target_normal, was.options.target_normal);
  EXPECT_EQ(is.target_met, was.target_met);
  ASSERT_TRUE(read->project.solved[0]);
  EXPECT_EQ(read->project.solved[0]->x, project.solved[0]->x);
  EXPECT_EQ(text_of(read->project), text);
  const auto panels = solved_panels(read->project, "");
  ASSERT_TRUE(panels) << panels.error().text();
  EXPECT_EQ(panels->panels.polygons.size(), static_cast<int>(panels->numbers.size()));
  EXPECT_GE(panels->panels.polygons.size(), 17);
}

TEST(ProjectClusters, ADocumentGoesOnWithThem) {
  Document document;
  document.open_project(cluster_project());
  ASSERT_NE(document.clusters(), nullptr);
  EXPECT_EQ(document.clusters()->mesh, document.mesh());
  EXPECT_EQ(document.clusters()->options.seed_number, 4000000000u);
  EXPECT_FALSE(document.can_undo());
  EXPECT_EQ(document.to_project().clusters->region_of_face, cluster_project().clusters->region_of_face);
}

TEST(ProjectClusters, OptionsOfAMeshThatHadMoreFacesStay) {
  Project project = cluster_project();
  project.clusters->options.given = {0, 100000};
  project.clusters->options.panels = 100000;
  const auto read = read_project(text_of(project), "x");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->project.clusters->options.given, (std::vector<int>{0, 100000}));
  EXPECT_EQ(read->project.clusters->options.panels, 100000);
}

TEST(ProjectClusters, FilesThatLieAreRefused) {
  const std::vector<int> regions = cluster_project().clusters->region_of_face;
  std::vector<int> short_by_one = regions;
  short_by_one.pop_back();
  expect_refused(with_regions(short_by_one), "Give the region of each face");
  std::vector<int> gap = regions;
  for (int& region : gap)
    if (region == 3) region = 4;
  expect_refused(with_regions(gap), "region");  // one without a face
  std::vector<int> apart = regions;
  apart.front() = apart[regions.size() / 2];
  if (apart != regions) expect_refused(with_regions(apart), "region");
  std::string text = text_of(cluster_project());
  const auto replaced = [&](const std::string& what, const std::string& by) {
    std::string changed = text;
    const std::size_t at = changed.find(what);
    EXPECT_NE(at, changed.npos) << what;
    return changed.replace(at, what.size(), by);
  };
  expect_refused(replaced("\"panels\": 17", "\"panels\": 0"), "panels");
  expect_refused(replaced("\"seed_number\": 4000000000", "\"seed_number\": 1.5"), "32 bits");
  expect_refused(replaced("\"seeds\": \"random\"", "\"seeds\": \"salt\""), "random, farthest, given");
}

TEST(ProjectClusters, WithoutRegionsTheirPanelsHaveToBeSolvedAgain) {
  Project project = cluster_project();
  project.clusters.reset();
  const auto read = read_project(text_of(project), "x");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_FALSE(read->project.solved[0]);
  EXPECT_EQ(read->warnings.size(), 1u);
}

}  // namespace
}  // namespace planewright
