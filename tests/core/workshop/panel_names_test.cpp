#include "core/workshop/panel_names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <numbers>
#include <set>

#include "core/complex/dual.h"
#include "core/mesh/sample_shapes.h"
#include "support/panel_designs.h"

namespace planewright {
namespace {

// The panels of a sample before any solve: of triangles the dual, of quads the faces.
PanelDesign sample_panels(const SampleInfo& info, int panels) {
  const PolygonMesh mesh = make_sample(info.name, panels).value();
  if (!info.triangles) return {mesh.positions(), mesh.faces()};
  const TangentComplex dual = build_dual(mesh).value();
  return {dual.preferred, dual.panels};
}

// A closed drum of `rows` rings of `columns` unit-high panels; panel r * columns + c begins at angle c.
PanelDesign drum(int rows, int columns, double radius) {
  PanelDesign drum;
  drum.points.resize((rows + 1) * columns, 3);
  for (int r = 0; r <= rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const double angle = 2.0 * std::numbers::pi * (c + 0.25) / columns;
      drum.points.row(r * columns + c) << radius * std::cos(angle), radius * std::sin(angle), r;
    }
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const int d = (c + 1) % columns;
      drum.panels.push_back(
          std::array{r * columns + c, r * columns + d, (r + 1) * columns + d, (r + 1) * columns + c});
    }
  return drum;
}

TEST(PanelNames, AFacadeIsNumberedFromLeftToRightAndFromBelow) {
  const auto names = model_of(wall(3, 4))->names;
  const std::vector<std::string> expected{"A-1", "A-2", "A-3", "A-4", "B-1", "B-2",
                                          "B-3", "B-4", "C-1", "C-2", "C-3", "C-4"};
  EXPECT_EQ(names, expected);
  // Seen from the other side left is the other end.
  PanelDesign north = wall(1, 3);
  north.panels = {{3 + 1, 4 + 1, 1, 0}, {5, 6, 2, 1}, {6, 7, 3, 2}};
  EXPECT_EQ(model_of(north)->names, (std::vector<std::string>{"A-3", "A-2", "A-1"}));
}

TEST(PanelNames, NumbersHaveTheDigitsOfTheLongestRow) {
  const auto names = model_of(wall(2, 12))->names;
  EXPECT_EQ(names[0], "A-01");
  EXPECT_EQ(names[11], "A-12");
  EXPECT_EQ(names[12], "B-01");
}

TEST(PanelNames, AnotherUpTurnsTheRows) {
  WorkshopOptions options;
  options.up = Vector3d::UnitX();
  const auto names = model_of(wall(3, 2), options)->names;  // rows are columns now
  EXPECT_EQ(names[0].substr(0, 1), "A");
  EXPECT_EQ(names[2].substr(0, 1), "A");
  EXPECT_EQ(names[1].substr(0, 1), "B");
  // Outside is -y, up is +x: left to right is from +z to -z.
  EXPECT_EQ(names[0], "A-3");
  EXPECT_EQ(names[4], "A-1");
}

TEST(PanelNames, ADrumIsNumberedRoundEachRow) {
  const auto names = model_of(drum(2, 8, 2.0))->names;
  for (int c = 0; c < 8; ++c) {
    EXPECT_EQ(names[static_cast<size_t>(c)], "A-" + std::to_string(c + 1));
    EXPECT_EQ(names[static_cast<size_t>(8 + c)], "B-" + std::to_string(c + 1));
  }
}

TEST(PanelNames, AFlatRoofIsCutIntoRowsAlongItsLength) {
  PanelDesign roof = wall(2, 5);  // laid down: 5 long, 2 deep
  for (int v = 0; v < roof.points.rows(); ++v)
    roof.points.row(v) << roof.points(v, 0), roof.points(v, 2), 0.0;
  const std::vector<std::string> expected{"A-1", "A-2", "A-3", "A-4", "A-5",
                                          "B-1", "B-2", "B-3", "B-4", "B-5"};
  EXPECT_EQ(model_of(roof)->names, expected);
  // Turned by 30 degrees the rows turn, too.
  const double c = std::sqrt(0.75), s = 0.5;
  Matrix3d turn;
  turn << c, -s, 0, s, c, 0, 0, 0, 1;
  roof.points = roof.points * turn.transpose();
  EXPECT_EQ(model_of(roof)->names, expected);
}

TEST(PanelNames, OfRingsInsideOneAnotherTheOuterComesFirst) {
  PanelDesign both = drum(1, 8, 5.0), inner = drum(1, 6, 2.0);
  const int shift = static_cast<int>(both.points.rows());
  Points points(shift + inner.points.rows(), 3);
  points << both.points, inner.points;
  both.points = points;
  for (int p = 0; p < 6; ++p) {  // seen from inside the inner ring
    std::vector<int> corners(inner.panels[p].rbegin(), inner.panels[p].rend());
    for (int& v : corners) v += shift;
    both.panels.push_back(corners);
  }
  const auto names = model_of(both)->names;
  for (int p = 0; p < 8; ++p) EXPECT_EQ(names[static_cast<size_t>(p)], "A-0" + std::to_string(p + 1));
  EXPECT_EQ(names[8], "A-09");
  EXPECT_EQ(names[13], "A-14");
}

TEST(PanelNames, ATorusHasRowsFromBelowWithItsOuterRingFirst) {
  const PolygonMesh torus = make_torus(16, 32);
  const auto model = model_of({torus.positions(), torus.faces()});
  std::map<std::string, std::vector<std::pair<int, int>>> rows;  // number, panel
  for (int p = 0; p < model->panel_count(); ++p) {
    const std::string& name = model->names[static_cast<size_t>(p)];
    const size_t dash = name.find('-');
    rows[name.substr(0, dash)].emplace_back(std::stoi(name.substr(dash + 1)), p);
  }
  double below = -1e9;
  for (auto& [letters, row] : rows) {
    std::sort(row.begin(), row.end());
    double height = 0.0;
    for (const auto& [number, p] : row) height += centroid(model->points, model->panels[p]).z();
    height /= static_cast<double>(row.size());
    EXPECT_GT(height, below) << letters;
    below = height;
  }
}

TEST(PanelNames, EveryPanelOfEverySampleHasOneNameInEveryUnit) {
  for (const SampleInfo& info : samples())
    for (const int panels : {60, 900}) {
      const PanelDesign design = sample_panels(info, panels);
      const auto names = model_of(design)->names;
      std::set<std::string> distinct;
      for (const std::string& name : names) {
        EXPECT_TRUE(distinct.insert(name).second) << info.name << ": " << name;
        const size_t dash = name.find('-');
        ASSERT_NE(dash, std::string::npos) << info.name << ": " << name;
        EXPECT_TRUE(std::all_of(name.begin(), name.begin() + static_cast<std::ptrdiff_t>(dash), ::isupper))
            << name;
        EXPECT_TRUE(std::all_of(name.begin() + static_cast<std::ptrdiff_t>(dash) + 1, name.end(), ::isdigit))
            << name;
      }
      for (const LengthUnit unit : length_units()) {
        PanelDesign other = design;
        other.points *= 1000.0 / millimetres_per(unit);
        EXPECT_EQ(model_of(other, in_unit(unit))->names, names) << info.name << " in " << symbol(unit);
      }
    }
}

TEST(PanelNames, PlainNamesAreNumbersFromOne) {
  WorkshopOptions options;
  options.names = NameStyle::Plain;
  options.numbers = {0, 1, 2, 3, 4, 16};
  EXPECT_EQ(model_of(cube(), options)->names, (std::vector<std::string>{"1", "2", "3", "4", "5", "17"}));
  options.kept_names = {{3, "5"}};  // panel 4 has to give way: beyond all
  EXPECT_EQ(model_of(cube(), options)->names, (std::vector<std::string>{"1", "2", "3", "5", "18", "17"}));
}

TEST(PanelNames, KeptNamesWinAndTheOthersGiveWay) {
  WorkshopOptions options;
  options.numbers = {10, 11, 12, 13};
  // 12 keeps A-1; panel 99 is gone, but its name is not given to another.
  options.kept_names = {{12, "A-1"}, {99, "a-2"}};
  EXPECT_EQ(model_of(wall(1, 4), options)->names, (std::vector<std::string>{"A-5", "A-6", "A-1", "A-4"}));
  options.kept_names = {{11, "Entrance_2.b"}};
  EXPECT_EQ(model_of(wall(1, 4), options)->names,
            (std::vector<std::string>{"A-1", "Entrance_2.b", "A-3", "A-4"}));
}

TEST(PanelNames, NamesThatAreAllKeptStayWhenThePanelsMove) {
  const auto before = model_of(wall(2, 3));
  PanelDesign turned = wall(2, 3);
  turned.points.col(2) *= -1.0;
  WorkshopOptions options;
  EXPECT_NE(model_of(turned, options)->names, before->names);
  for (int p = 0; p < 6; ++p) options.kept_names.emplace_back(p, before->names[static_cast<size_t>(p)]);
  EXPECT_EQ(model_of(turned, options)->names, before->names);
}

TEST(PanelNames, RowLettersGoOnBehindZ) {
  EXPECT_EQ(row_letters(0), "A");
  EXPECT_EQ(row_letters(25), "Z");
  EXPECT_EQ(row_letters(26), "AA");
  EXPECT_EQ(row_letters(51), "AZ");
  EXPECT_EQ(row_letters(52), "BA");
  EXPECT_EQ(row_letters(26 + 26 * 26 - 1), "ZZ");
  EXPECT_EQ(row_letters(26 + 26 * 26), "AAA");
}

TEST(PanelNames, NaturalOrder) {
  const std::vector<std::string> ordered{"1",    "2",   "10",  "A-1",  "A-2",  "A-02x",
                                         "A-10", "B-1", "Z-9", "AA-1", "AB-1", "Entrance"};
  for (size_t i = 0; i < ordered.size(); ++i)
    for (size_t k = 0; k < ordered.size(); ++k)
      EXPECT_EQ(natural_name_less(ordered[i], ordered[k]), i < k) << ordered[i] << " " << ordered[k];
  EXPECT_NE(natural_name_less("A-07", "A-7"), natural_name_less("A-7", "A-07"));  // total
}

}  // namespace
}  // namespace planewright
