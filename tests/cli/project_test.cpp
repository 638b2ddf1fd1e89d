// --project through the real binary.
#include <gtest/gtest.h>

#include "cli/command_line.h"
#include "core/complex/state.h"
#include "core/design/design.h"
#include "core/edit/project_file.h"
#include "core/edit/project_panels.h"
#include "core/mesh/mesh_io.h"

namespace planewright {
namespace {

using test::Ended;
using test::expect_refusal;

class ProjectOption : public test::CommandLineTest {
 protected:
  Ended solve(const std::string& command, const std::string& input,
              const std::vector<std::string>& options) const {
    std::vector<std::string> arguments{
        command, input, "-o", path("p.obj"), "--quiet", "--project", path("r.planewright")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run(arguments);
  }
  Project project() const {
    auto read = load_project(path("r.planewright"));
    EXPECT_TRUE(read) << read.error().text();
    EXPECT_TRUE(read->warnings.empty());
    return std::move(read->project);
  }
  // The panels that a project holds of a layer are those that were written.
  void expect_panels(const Project& project, std::size_t layer, const std::string& file) const {
    ASSERT_TRUE(layer < project.solved.size() && project.solved[layer]);
    const auto complex = build_complex(project.mesh, project.design.layers[layer].settings).value();
    const Panels panels = panels_of(*complex, *project.solved[layer]);
    const auto written = load_mesh(path(file)).value();
    EXPECT_EQ(panels.points, written.mesh.positions());
    EXPECT_EQ(panels.polygons, written.mesh.faces());
  }
};

TEST_F(ProjectOption, KeepsClustersAndTheirPanels) {
  const Ended ended = solve("cluster", sample("dome", 200), {"--panels", "25", "--unit", "cm"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  const Project kept = project();
  ASSERT_TRUE(kept.clusters);
  EXPECT_EQ(kept.clusters->options.panels, 25);
  EXPECT_EQ(kept.contract.unit, LengthUnit::Centimetre);
  const auto panels = solved_panels(kept, "");
  ASSERT_TRUE(panels) << panels.error().text();
  const auto written = load_mesh(path("p.obj")).value();
  EXPECT_EQ(panels->panels.points, written.mesh.positions());
  EXPECT_EQ(panels->panels.polygons, written.mesh.faces());
}

TEST_F(ProjectOption, KeepsMeshSettingsAndPanels) {
  const std::string input = sample("dome", 60);
  folder_.write("roof.txt", "roof: vertices 3 4 5\n");
  folder_.write("pins.txt", "face 3 * * -\n");
  const Ended ended = solve("dual", input,
                            {"--unit", "mm", "--offset", "0.1", "--weights", "fairing=0.25", "--constraint",
                             "offset-band=0:0.5@roof", "--select", path("roof.txt"), "--pin",
                             path("pins.txt"), "--thickness", "0.05", "--reference", input});
  EXPECT_EQ(ended.status, 0) << ended.err;
  const Project project = this->project();
  EXPECT_EQ(project.name, "dome-input.obj");
  EXPECT_EQ(project.contract.unit, LengthUnit::Millimetre);
  EXPECT_EQ(project.mesh.positions(), load_mesh(input).value().mesh.positions());
  ASSERT_EQ(project.design.layers.size(), 1u);
  const Layer& layer = project.design.layers.front();
  EXPECT_EQ(layer.name, "panels");
  EXPECT_EQ(layer.thickness, 0.05);
  EXPECT_EQ(layer.settings.offset, 0.1);
  EXPECT_EQ(layer.settings.weights.at("fairing"), 0.25);
  ASSERT_EQ(layer.settings.demands.list.size(), 1u);
  EXPECT_EQ(layer.settings.demands.list[0].selection, "roof");
  EXPECT_EQ(layer.settings.demands.pins.size(), 1u);
  ASSERT_EQ(project.design.selections.size(), 1u);
  EXPECT_EQ(project.design.selections[0].vertices, (std::vector<int>{3, 4, 5}));
  EXPECT_EQ(project.design.reference, input);
  expect_panels(project, 0, "p.obj");
}

TEST_F(ProjectOption, KeepsLayersAndModes) {
  const std::string triangles = sample("dome", 60), quads = sample("twisted-roof", 30);
  EXPECT_EQ(solve("panels", triangles, {"--layers", "outer=0.3,inner=-0.2"}).status, 0);
  const Project layers = project();
  ASSERT_EQ(layers.design.layers.size(), 2u);
  EXPECT_EQ(layers.design.layers[1].name, "inner");
  EXPECT_EQ(layers.contract.unit, LengthUnit::Metre);
  expect_panels(layers, 0, "p-outer.obj");
  expect_panels(layers, 1, "p-inner.obj");
  EXPECT_EQ(solve("panels", quads, {}).status, 0);
  EXPECT_EQ(project().design.layers[0].settings.mode, ComplexKind::Planarize);
  expect_panels(project(), 0, "p.obj");
  EXPECT_EQ(solve("planarize", quads, {"--unit", "ft"}).status, 0);
  EXPECT_EQ(project().contract.unit, LengthUnit::Foot);
}

TEST_F(ProjectOption, RefusesNamesBeforeTheWork) {
  const std::string input = sample("dome", 60);
  const auto with = [&](const std::string& file) {
    return run({"dual", input, "-o", path("p.obj"), "--project", file});
  };
  expect_refusal(with(path("r.json")), 2, {"--project", ".planewright"});
  expect_refusal(with(path("none/r.planewright")), 5, {"none"});
  expect_refusal(run({"dual", input, "-o", path("p.obj"), "--project", path("r.planewright"), "--report",
                      path("r.planewright")}),
                 2, {"--project and --report are the same file"});
  EXPECT_FALSE(exists("p.obj"));
}

}  // namespace
}  // namespace planewright
