// A document that is saved, opened again and edited on.
#include <gtest/gtest.h>

#include <set>

#include "core/edit/document.h"
#include "core/edit/project_file.h"
#include "core/mesh/sample_shapes.h"
#include "support/projects.h"

namespace planewright {
namespace {

Document opened(const std::string& sample, int panels) {
  CheckedMesh mesh;
  mesh.mesh = make_sample(sample, panels).value();
  Document document;
  document.open(std::move(mesh), sample, {});
  return document;
}

Document opened_again(const Document& document) {
  auto read = read_project(format_project(document.to_project()).value(), "x");
  EXPECT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->warnings, std::vector<std::string>{});
  Document again;
  again.open_project(std::move(read->project));
  return again;
}

int first_flip(const Document& document, int from = 0) {
  while (!document.may_edit(MeshEdit::flip(from))) ++from;
  return from;
}
int first_collapse(const Document& document, int from) {
  while (!document.may_edit(MeshEdit::collapse(from))) ++from;
  return from;
}

void edit(Document& document, const MeshEdit& edit) {
  const auto done = document.edit_mesh(edit);
  ASSERT_TRUE(done) << done.error().text();
}

void expect_same_numbers(const Document& a, const Document& b) {
  EXPECT_EQ(*a.ids(), *b.ids());
  for (std::size_t layer = 0; layer < a.design().layers.size(); ++layer)
    for (int origin = 0; origin < a.mesh()->vertex_count(); ++origin)
      ASSERT_EQ(a.panel_number(static_cast<int>(layer), origin),
                b.panel_number(static_cast<int>(layer), origin))
          << "layer " << layer << ", panel of " << origin;
}

TEST(ProjectDocument, OpensAsItWas) {
  Document document;
  const Project project = test::busy_project();
  document.open_project(project);
  Project again = document.to_project();
  EXPECT_EQ(again.solved.size(), project.solved.size());
  again.solved = project.solved;  // which the document leaves to whoever shows results
  test::expect_same_project(again, project);
  EXPECT_FALSE(document.can_undo());
  EXPECT_EQ(document.contract().unit, LengthUnit::Inch);
  EXPECT_EQ(document.health().vertices, project.mesh.vertex_count());
}

TEST(ProjectDocument, NumbersOutliveEditsUndoAndReopening) {
  Document document = opened("dome", 60);
  Design design = document.design();
  design.layers.resize(3);
  design.layers[1].settings.border = BorderPolicy::Interior;
  design.layers[2].settings.mode = ComplexKind::Planarize;
  document.change_design(design, "Add layers");
  edit(document, MeshEdit::collapse(first_collapse(document, 40)));
  edit(document, MeshEdit::flip(first_flip(document, 20)));
  edit(document, MeshEdit::collapse(first_collapse(document, 70)));
  document.undo();
  edit(document, MeshEdit::flip(first_flip(document, 50)));

  Document again = opened_again(document);
  test::expect_same_mesh(*again.mesh(), *document.mesh());
  EXPECT_EQ(again.design(), document.design());
  expect_same_numbers(again, document);
  // And what is made from there on gets the same new numbers, never one that was given.
  for (Document* each : {&document, &again}) {
    edit(*each, MeshEdit::split_edge(10));
    edit(*each, MeshEdit::collapse(first_collapse(*each, 30)));
  }
  expect_same_numbers(again, document);
}

TEST(ProjectDocument, WaiversNameTheSamePlacesAfterFlips) {
  Document document = opened("dome", 60);
  for (int e = 0; e < 100; ++e) edit(document, MeshEdit::flip(first_flip(document, e)));
  LayerSettings settings = document.settings();
  const auto before = build_complex(*document.mesh(), settings).value();
  for (int k = 0; k < static_cast<int>(before->panel_edges.size()); k += 3)
    settings.demands.waived.push_back({"edge", {ElementKind::PanelEdge, k}});
  document.change_settings(settings, "Give up");

  const Document again = opened_again(document);
  const auto after = build_complex(*again.mesh(), again.settings()).value();
  const auto places = [](const TangentComplex& complex, const std::vector<Waiver>& waived) {
    std::set<std::set<int>> points;
    for (const Waiver& waiver : waived) {
      const PanelEdge& edge = complex.panel_edges[static_cast<std::size_t>(waiver.element.index)];
      points.insert({edge.a, edge.b});
    }
    return points;
  };
  EXPECT_EQ(again.settings().demands.waived, settings.demands.waived);
  EXPECT_EQ(places(*after, again.settings().demands.waived), places(*before, settings.demands.waived));
}

TEST(ProjectDocument, TheContractIsAStep) {
  Document document = opened("dome", 60);
  const auto revision = document.revision();
  WorkshopContract contract = document.contract();
  document.change_contract(contract, "Nothing");
  EXPECT_FALSE(document.can_undo());
  for (const double thickness : {4.0, 5.0, 6.0}) {
    contract.thickness = thickness;
    document.change_contract(contract, "Thickness", "thickness");
  }
  document.end_merge();
  EXPECT_EQ(document.history(), std::vector<std::string>{"Thickness"});
  EXPECT_GT(document.revision(), revision);
  contract.unit = LengthUnit::Millimetre;
  document.change_contract(contract, "Unit");
  document.undo();
  EXPECT_EQ(document.contract().unit, LengthUnit::Metre);
  EXPECT_EQ(document.contract().thickness, 6.0);
  document.undo();
  EXPECT_EQ(document.contract(), WorkshopContract{});
  document.redo();
  EXPECT_EQ(document.contract().thickness, 6.0);
  EXPECT_EQ(opened_again(document).contract(), document.contract());

  // Dragged back to where it began: no step.
  const auto steps = document.steps_done();
  for (const double gap : {1.0, 0.0}) {
    contract = document.contract();
    contract.gap = gap;
    document.change_contract(contract, "Gap", "gap");
  }
  EXPECT_EQ(document.steps_done(), steps);
}

TEST(ProjectDocument, GivenNamesStayWhateverIsUndone) {
  Document document = opened("dome", 60);
  edit(document, MeshEdit::flip(first_flip(document)));
  ASSERT_TRUE(document.keep_names(0, {{0, "A-1"}, {5, "B-2"}}));
  EXPECT_EQ(document.steps_done(), 1);
  document.undo();
  const PanelSeries dual{ComplexKind::Dual, BorderPolicy::Closed};
  EXPECT_EQ(document.given_names().at(dual).at(5), "B-2");
  ASSERT_TRUE(document.keep_names(0, {{5, "B-3"}, {6, "B-2"}}));
  EXPECT_EQ(document.given_names().at(dual),
            (std::map<int, std::string>{{0, "A-1"}, {5, "B-3"}, {6, "B-2"}}));

  const auto clash = document.keep_names(0, {{7, "A-1"}});
  ASSERT_FALSE(clash);
  EXPECT_NE(clash.error().what.find("panels 0 and 7"), std::string::npos) << clash.error().text();
  EXPECT_FALSE(document.keep_names(0, {{7, ""}}));
  EXPECT_FALSE(document.keep_names(0, {{-1, "x"}}));
  EXPECT_FALSE(document.keep_names(1, {{7, "x"}})) << "there is no such layer";
  EXPECT_EQ(document.given_names().at(dual).size(), 3u);
  EXPECT_EQ(opened_again(document).given_names(), document.given_names());

  document.open({make_torus(8, 8), {}, {}, {}}, "torus", {});
  EXPECT_TRUE(document.given_names().empty());
}

}  // namespace
}  // namespace planewright
