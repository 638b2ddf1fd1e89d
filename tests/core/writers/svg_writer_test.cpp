#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "core/writers/drawing_writers.h"
#include "support/python.h"
#include "support/writer_scenes.h"

namespace planewright {
namespace {

using namespace test;
using Json = nlohmann::json;

constexpr const char* kRead = R"(
import sys, json
import xml.etree.ElementTree as ET
S = "{http://www.w3.org/2000/svg}"; I = "{http://www.inkscape.org/namespaces/inkscape}"
root = ET.parse(sys.argv[1]).getroot()
out = {"width": root.get("width"), "height": root.get("height"), "box": root.get("viewBox"),
       "title": root.find(S + "title").text, "layers": [], "paths": [], "texts": []}
for layer in root.findall(S + "g"):
    out["layers"].append([layer.get("id"), layer.get(I + "label"), layer.get(I + "groupmode")])
    for group in [layer] + layer.findall(S + "g"):
        for e in group.findall(S + "path"):
            out["paths"].append([layer.get("id"), group.get("data-panel"), e.get("d")])
        for e in group.findall(S + "text"):
            out["texts"].append([layer.get("id"), group.get("data-panel"), e.text, e.get("class")])
print(json.dumps(out))
)";

TEST(SvgWriter, IsInMillimetresWithLayersAndNames) {
  const std::string python = python_with("xml.etree.ElementTree");
  if (python.empty()) GTEST_SKIP() << "no python";
  const WorkshopModel model = named_cube();
  Drawing drawing = hexagons(model, 3, 431.25 / 7.0, "sheet <1> & \"more\"");
  const Json json = read_with_python(python, kRead, format_svg(model, drawing), "drawing.svg");
  ASSERT_TRUE(json.is_object());
  const std::string width = json["width"], height = json["height"];
  ASSERT_TRUE(width.ends_with("mm") && height.ends_with("mm"));
  EXPECT_EQ(std::stod(width), drawing.width);
  EXPECT_EQ(std::stod(height), drawing.height);
  EXPECT_EQ(json["box"],
            "0 0 " + width.substr(0, width.size() - 2) + " " + height.substr(0, height.size() - 2));
  EXPECT_EQ(json["title"], drawing.title);
  ASSERT_EQ(json["layers"].size(), 5u);
  for (const Json& layer : json["layers"]) {
    EXPECT_EQ(layer[0], layer[1]);
    EXPECT_EQ(layer[2], "layer");
  }
  // Paths come layer by layer; those of one layer in the drawing's order.
  ASSERT_EQ(json["paths"].size(), drawing.lines.size());
  std::vector<const DrawingLine*> cuts;
  for (const DrawingLine& line : drawing.lines)
    if (line.layer == DrawingLayer::Cut) cuts.push_back(&line);
  size_t seen = 0;
  for (const Json& path : json["paths"]) {
    if (path[0] != "CUT") continue;
    const DrawingLine& line = *cuts.at(seen++);
    EXPECT_EQ(path[1], model.names[line.panel]);
    std::istringstream in(path[2].get<std::string>());
    std::string word;
    for (int i = 0; i < line.points.rows(); ++i) {
      double x = 0.0, y = 0.0;
      ASSERT_TRUE(in >> word >> x >> y);
      EXPECT_EQ(word, i == 0 ? "M" : "L");
      EXPECT_NEAR(x, line.points(i, 0), 1e-9);
      EXPECT_NEAR(drawing.height - y, line.points(i, 1), 1e-9);
    }
    EXPECT_TRUE(in >> word && word == "Z");
  }
  EXPECT_EQ(seen, model.names.size());
  std::map<std::string, int> names;
  for (const Json& text : json["texts"]) {
    if (text[0] != "TEXT") continue;
    EXPECT_EQ(text[1], text[2]);
    EXPECT_EQ(text[3], "name");
    ++names[text[2]];
  }
  EXPECT_EQ(names.size(), model.names.size());
  for (const auto& [name, count] : names) EXPECT_EQ(count, 1) << name;
}

TEST(SvgWriter, OfAnEmptyDrawingAndOfNaN) {
  const WorkshopModel model = named_cube();
  EXPECT_NE(format_svg(model, {}).find("viewBox=\"0 0 0 0\""), std::string::npos);
  Drawing drawing = hexagons(model, 3, 50.0, "sheet");
  drawing.texts[2].at.x() = std::numeric_limits<double>::infinity();
  EXPECT_THROW(format_svg(model, drawing), std::invalid_argument);
}

}  // namespace
}  // namespace planewright
