#include "core/pattern/drawing.h"

#include <gtest/gtest.h>

#include <numbers>
#include <set>
#include <sstream>

#include "core/pattern/contours.h"
#include "core/pattern/stroke_font.h"
#include "support/workshop_models.h"

namespace planewright {
namespace {

using namespace test;
using Eigen::Vector2d;
using std::numbers::pi;

// The four corners of a text's box.
std::vector<Vector2d> box(const DrawingText& text) {
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(text.rotation).toRotationMatrix();
  const double w = stroke_width(text.text, text.height) / 2, h = text.height / 2;
  std::vector<Vector2d> corners;
  for (const auto& [x, y] : {std::pair(-w, -h), std::pair(w, -h), std::pair(w, h), std::pair(-w, h)})
    corners.push_back(text.at + turn * Vector2d(x, y));
  return corners;
}

const Contour& cut_of(const Drawing& drawing, int panel) {
  for (const DrawingLine& line : drawing.lines)
    if (line.layer == DrawingLayer::Cut && line.panel == panel) return line.points;
  throw std::runtime_error("no cut");
}

// Names once for each part, all text and all lines inside their parts.
void expect_proper(const Drawing& drawing, const WorkshopModel& model, size_t parts) {
  std::multiset<std::string> names;
  for (const DrawingText& text : drawing.texts) {
    EXPECT_EQ(text.layer, DrawingLayer::Text);
    if (text.is_name) {
      names.insert(text.text);
      EXPECT_EQ(text.text, model.names[text.panel]);
    }
    for (const Vector2d& corner : box(text)) EXPECT_GT(depth_in(cut_of(drawing, text.panel), corner), 0.0);
  }
  EXPECT_EQ(names.size(), parts);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), parts);
  size_t cuts = 0;
  for (const DrawingLine& line : drawing.lines) {
    EXPECT_GE(line.points.minCoeff(), -1e-9);
    EXPECT_LE(line.points.col(0).maxCoeff(), drawing.width + 1e-9);
    EXPECT_LE(line.points.col(1).maxCoeff(), drawing.height + 1e-9);
    cuts += line.layer == DrawingLayer::Cut;
    if (line.layer != DrawingLayer::Engrave) continue;
    for (Eigen::Index k = 0; k < line.points.rows(); ++k)
      EXPECT_GT(depth_in(cut_of(drawing, line.panel), line.points.row(k)), -1e-5);
  }
  EXPECT_EQ(cuts, parts);
}

WorkshopModel ball() {
  return workshop_model(ball_of_tangent_planes(40, 2000.0), 1.0);
}

TEST(Drawing, OfAPartNamesItAndItsNeighbours) {
  const WorkshopModel model = ball();
  const ThickPanels solids = thicken(model, {30.0, 4.0}).value();
  for (const FlatPattern& pattern : flatten(model, &solids)) {
    const Drawing drawing = part_drawing(model, pattern);
    expect_proper(drawing, model, 1);
    EXPECT_EQ(drawing.title, model.names[pattern.panel]);
    EXPECT_EQ(cut_of(drawing, pattern.panel), pattern.cut) << "bit for bit";
    for (const DrawingText& text : drawing.texts) {
      if (text.is_name) continue;
      // It lies nearest to the side that this neighbour is behind, and reads along it from left to right.
      int nearest = -1;
      double least = 1e9;
      const int n = static_cast<int>(pattern.nominal.rows());
      for (int k = 0; k < n; ++k) {
        const Vector2d a = pattern.nominal.row(k), b = pattern.nominal.row((k + 1) % n);
        const Vector2d along = (b - a).normalized(), to = text.at - a;
        const double off = std::abs(along.x() * to.y() - along.y() * to.x());
        if (off < least) {
          least = off;
          nearest = k;
        }
      }
      const WorkshopEdge& edge = model.edges[model.edges_of_panel[pattern.panel][nearest]];
      EXPECT_EQ(text.text, model.names[edge.left == pattern.panel ? edge.right : edge.left]);
      const Vector2d side = pattern.nominal.row((nearest + 1) % n) - pattern.nominal.row(nearest);
      const Vector2d reads(std::cos(text.rotation), std::sin(text.rotation));
      EXPECT_NEAR(std::abs(side.normalized().dot(reads)), 1.0, 1e-9);
      EXPECT_GE(reads.x(), -1e-9) << "upside down";
    }
    EXPECT_EQ(drawing.texts.size(), static_cast<size_t>(1 + pattern.nominal.rows()));
  }
}

TEST(Drawing, TheUpMarkPointsUpAndFlatPanelsHaveNone) {
  const WorkshopModel model = workshop_model(cube(), 500.0);
  for (const FlatPattern& pattern : flatten(model, nullptr)) {
    LabelOptions options;
    options.edge_names = false;
    const Drawing drawing = part_drawing(model, pattern, options);
    EXPECT_EQ(drawing.texts.size(), 1u);
    std::vector<const DrawingLine*> engraved;
    for (const DrawingLine& line : drawing.lines)
      if (line.layer == DrawingLayer::Engrave) engraved.push_back(&line);
    ASSERT_EQ(engraved.size(), pattern.lies_flat ? 0u : 2u);
    if (pattern.lies_flat) continue;
    const Contour &shaft = engraved[0]->points, &head = engraved[1]->points;
    EXPECT_EQ(shaft(0, 0), shaft(1, 0));
    EXPECT_GT(shaft(1, 1), shaft(0, 1));
    EXPECT_EQ(head.row(1), shaft.row(1));
    EXPECT_LT(head(0, 1), head(1, 1));
    EXPECT_GT(shaft(0, 1), box(drawing.texts[0])[2].y()) << "above the name";
  }
}

TEST(Drawing, NamesAreSmallerWhereThePartIsSmall) {
  const auto height = [](double size) {
    const WorkshopModel model = workshop_model(cube(), size);
    const Drawing drawing = part_drawing(model, flatten(model, nullptr)[2]);
    expect_proper(drawing, model, 1);
    return drawing.texts.front().height;
  };
  EXPECT_EQ(height(500.0), 12.0);
  EXPECT_LT(height(30.0), 12.0);
  EXPECT_NEAR(height(15.0), height(30.0) / 2, 1e-2 * height(30.0));
}

TEST(Drawing, OfASheetTurnsItsParts) {
  const WorkshopModel model = ball();
  const auto patterns = flatten(model, nullptr, 4.0);
  const Nesting nesting = nest(patterns, {}).value();
  size_t seen = 0;
  bool turned = false;
  for (int s = 0; s < static_cast<int>(nesting.sheets.size()); ++s) {
    const Drawing drawing = sheet_drawing(model, patterns, nesting, s);
    EXPECT_EQ(drawing.width, 3210.0);
    EXPECT_EQ(drawing.title,
              "test, sheet " + std::to_string(s + 1) + " of " + std::to_string(nesting.sheets.size()));
    expect_proper(drawing, model, nesting.sheets[s].parts.size());
    seen += nesting.sheets[s].parts.size();
    EXPECT_EQ(drawing.lines[0].layer, DrawingLayer::Sheet);
    for (const PlacedPart& part : nesting.sheets[s].parts) {
      turned = turned || part.rotation != 0.0;
      const FlatPattern& pattern = patterns[part.panel];
      EXPECT_NEAR(signed_area(cut_of(drawing, part.panel)), signed_area(pattern.cut), 1e-6);
      for (const DrawingText& text : drawing.texts)
        if (text.is_name && text.panel == part.panel) {
          EXPECT_EQ(text.rotation, part.rotation);
        }
    }
  }
  EXPECT_EQ(seen, patterns.size());
  EXPECT_TRUE(turned);
}

TEST(Drawing, InRowsKeepsPartsApartAndNamesInOrder) {
  const WorkshopModel model = ball();
  const auto patterns = flatten(model, nullptr);
  const Drawing drawing = row_drawing(model, patterns, 25.0);
  expect_proper(drawing, model, patterns.size());
  EXPECT_LT(drawing.width / drawing.height, 1.6);
  EXPECT_GT(drawing.width / drawing.height, 0.6);
  std::vector<std::string> names;
  for (const DrawingText& text : drawing.texts)
    if (text.is_name) names.push_back(text.text);
  for (size_t k = 0; k < names.size(); ++k) EXPECT_EQ(names[k], "P" + std::to_string(k + 1));
  for (int a = 0; a < 40; ++a)
    for (int b = 0; b < a; ++b) {
      const Contour &one = cut_of(drawing, a), &other = cut_of(drawing, b);
      const Vector2d gap = (one.colwise().minCoeff() - other.colwise().maxCoeff())
                               .cwiseMax(other.colwise().minCoeff() - one.colwise().maxCoeff())
                               .transpose();
      EXPECT_GE(gap.maxCoeff(), 25.0 - 1e-9);
    }
}

TEST(Drawing, EngravedNamesCoverTheirText) {
  const WorkshopModel model = workshop_model(dodecahedron(), 400.0);
  const auto patterns = flatten(model, nullptr);
  LabelOptions options;
  options.engrave_names = true;
  const Drawing plain = part_drawing(model, patterns[3]),
                engraved = part_drawing(model, patterns[3], options);
  EXPECT_EQ(plain.texts.size(), engraved.texts.size());
  EXPECT_GT(engraved.lines.size(), plain.lines.size() + 6);
  expect_proper(engraved, model, 1);
}

TEST(Drawing, OfNothingIsEmpty) {
  const WorkshopModel model = workshop_model(
      make_points({{0, 0, 0}, {100, 0, 0}, {20, 120, 0}, {100, 100, 0}, {0, 100, 0}}), {{0, 1, 2, 3, 4}});
  const auto patterns = flatten(model, nullptr);
  EXPECT_TRUE(part_drawing(model, patterns[0]).lines.empty());
  EXPECT_TRUE(row_drawing(model, patterns, 10.0).texts.empty());
}

TEST(StrokeFont, EveryCharacterIsItsOwnAndInItsBox) {
  std::set<std::string> seen;
  for (const char c : std::string("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_./")) {
    const auto strokes = text_strokes(std::string(1, c), 6.0);
    ASSERT_FALSE(strokes.empty()) << c;
    std::ostringstream shape;
    for (const Contour& stroke : strokes) {
      EXPECT_GE(stroke.rows(), 2) << c;
      EXPECT_GE(stroke.minCoeff(), 0.0) << c;
      EXPECT_LE(stroke.col(0).maxCoeff(), stroke_width("X", 6.0)) << c;
      EXPECT_LE(stroke.col(1).maxCoeff(), 6.0) << c;
      shape << stroke << ';';
    }
    EXPECT_TRUE(seen.insert(shape.str()).second) << c << " looks like another";
    EXPECT_NE(shape.str(), [] {
      std::ostringstream unknown;
      for (const Contour& stroke : text_strokes("~", 6.0)) unknown << stroke << ';';
      return unknown.str();
    }()) << c;
  }
  EXPECT_TRUE(text_strokes(" ", 6.0).empty());
  EXPECT_NEAR(text_strokes("AB", 6.0).back().col(0).maxCoeff(), stroke_width("AB", 6.0), 1e-12);
}

TEST(Drawing, LayersHaveTheirNames) {
  EXPECT_EQ(layer_name(DrawingLayer::Cut), "CUT");
  EXPECT_EQ(layer_name(DrawingLayer::Engrave), "ENGRAVE");
  EXPECT_EQ(layer_name(DrawingLayer::Text), "TEXT");
  EXPECT_EQ(layer_name(DrawingLayer::Sheet), "SHEET");
}

}  // namespace
}  // namespace planewright
