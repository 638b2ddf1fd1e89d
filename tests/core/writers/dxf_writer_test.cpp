#include <gtest/gtest.h>

#include <limits>
#include <map>

#include "core/writers/drawing_writers.h"
#include "support/python.h"
#include "support/writer_scenes.h"

namespace planewright {
namespace {

using namespace test;
using Json = nlohmann::json;

constexpr const char* kRead = R"(
import sys, json, ezdxf
doc = ezdxf.readfile(sys.argv[1])
audit = doc.audit()
lines, texts = [], []
for e in doc.modelspace():
    if e.dxftype() == "LWPOLYLINE":
        lines.append([e.dxf.layer, e.closed, [[p[0], p[1]] for p in e.get_points()]])
    elif e.dxftype() == "POLYLINE":
        lines.append([e.dxf.layer, e.is_closed, [[v.dxf.location.x, v.dxf.location.y] for v in e.vertices]])
    elif e.dxftype() == "TEXT":
        texts.append([e.dxf.layer, e.dxf.text, [e.dxf.align_point.x, e.dxf.align_point.y], e.dxf.height,
                      e.dxf.rotation, e.dxf.halign, e.dxf.valign])
    else:
        texts.append(["?", e.dxftype()])
raw = open(sys.argv[1]).read().split("\n")
head = {raw[i + 1]: raw[i + 3] for i in range(0, 200, 2) if raw[i].strip() == "9"}
print(json.dumps({"version": doc.dxfversion, "errors": [e.message for e in audit.errors],
  "fixes": [e.message for e in audit.fixes], "layers": {l.dxf.name: l.dxf.color for l in doc.layers},
  "units": head["$INSUNITS"].strip(), "measurement": head["$MEASUREMENT"].strip(), "lines": lines,
  "texts": texts}))
)";

class DxfWriter : public testing::TestWithParam<DxfVersion> {
 protected:
  // Null where no python has ezdxf.
  Json read(const Drawing& drawing) {
    const std::string python = python_with("ezdxf");
    if (python.empty()) return {};
    return read_with_python(python, kRead, format_dxf(drawing, GetParam()), "drawing.dxf");
  }
};

TEST_P(DxfWriter, IsReadByAnotherProgramAtScaleWithEveryName) {
  if (python_with("ezdxf").empty()) GTEST_SKIP() << "no python with ezdxf";
  const WorkshopModel model = named_cube();
  const Drawing drawing = hexagons(model, 3, 431.25 / 7.0, "sheet 1");
  const Json json = read(drawing);
  ASSERT_TRUE(json.is_object());
  EXPECT_EQ(json["version"], GetParam() == DxfVersion::R12 ? "AC1009" : "AC1015");
  EXPECT_EQ(json["errors"], Json::array());
  EXPECT_EQ(json["fixes"], Json::array());
  EXPECT_EQ(json["units"], "4");
  EXPECT_EQ(json["measurement"], "1");
  const std::map<std::string, int> colours{
      {"CUT", 1}, {"ENGRAVE", 5}, {"TEXT", 7}, {"TEXT_EDGES", 9}, {"SHEET", 8}};
  for (const auto& [layer, colour] : colours) EXPECT_EQ(json["layers"].value(layer, -1), colour) << layer;

  const char* layers[] = {"CUT", "ENGRAVE", "TEXT", "SHEET"};
  ASSERT_EQ(json["lines"].size(), drawing.lines.size());
  for (size_t k = 0; k < drawing.lines.size(); ++k) {
    const DrawingLine& line = drawing.lines[k];
    EXPECT_EQ(json["lines"][k][0], layers[static_cast<int>(line.layer)]);
    EXPECT_EQ(json["lines"][k][1], line.closed);
    ASSERT_EQ(json["lines"][k][2].size(), static_cast<size_t>(line.points.rows()));
    for (int i = 0; i < line.points.rows(); ++i)
      for (int axis = 0; axis < 2; ++axis)
        EXPECT_NEAR(json["lines"][k][2][i][axis].get<double>(), line.points(i, axis), 1e-9);
  }
  std::map<std::string, int> names;
  ASSERT_EQ(json["texts"].size(), drawing.texts.size());
  for (size_t k = 0; k < drawing.texts.size(); ++k) {
    const Json& told = json["texts"][k];
    const DrawingText& text = drawing.texts[k];
    EXPECT_EQ(told[1], text.text);
    EXPECT_EQ(told[0], text.is_name ? "TEXT" : "TEXT_EDGES");
    EXPECT_NEAR(told[2][0].get<double>(), text.at.x(), 1e-9);
    EXPECT_NEAR(told[2][1].get<double>(), text.at.y(), 1e-9);
    EXPECT_NEAR(told[3].get<double>(), text.height, 1e-12);
    EXPECT_NEAR(told[4].get<double>(), text.rotation * 180.0 / M_PI, 1e-9);
    EXPECT_EQ(told[5], 1);
    EXPECT_EQ(told[6], 2);
    if (told[0] == "TEXT") ++names[told[1]];
  }
  EXPECT_EQ(names.size(), model.names.size());
  for (const auto& [name, count] : names) EXPECT_EQ(count, 1) << name;
}

TEST_P(DxfWriter, OfAnEmptyDrawingIsAWholeFile) {
  if (python_with("ezdxf").empty()) GTEST_SKIP() << "no python with ezdxf";
  const Json json = read({});
  ASSERT_TRUE(json.is_object());
  EXPECT_EQ(json["errors"], Json::array());
  EXPECT_EQ(json["fixes"], Json::array());
  EXPECT_TRUE(json["lines"].empty());
}

TEST_P(DxfWriter, TextsOfAnyKindStayOneLine) {
  Drawing drawing;
  drawing.texts.push_back({DrawingLayer::Text,
                           "a\n  0\nEOF \xC3\xBC \xF0\x9F\x98\x80 \xFF 5^2 100%%d",
                           {0.0, 0.0},
                           5.0,
                           0.0,
                           -1,
                           false});
  const std::string dxf = format_dxf(drawing, GetParam());
  EXPECT_NE(dxf.find("\na   0 EOF \\U+00FC \\U+D83D\\U+DE00 \\U+FFFD 5^ 2 100%%%%%%d\n"), std::string::npos);
  EXPECT_EQ(dxf.find("EOF\n"), dxf.size() - 4);
  for (const char c : dxf) ASSERT_LT(static_cast<unsigned char>(c), 0x80);
}

TEST_P(DxfWriter, HoldsNoNumberThatIsNone) {
  Drawing drawing = hexagons(named_cube(), 3, 50.0, "sheet");
  EXPECT_TRUE(check_drawing(drawing));
  drawing.lines[3].points(1, 1) = std::numeric_limits<double>::quiet_NaN();
  const auto checked = check_drawing(drawing);
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().code, ErrorCode::Refused);
  EXPECT_NE(checked.error().text().find("panel 0"), std::string::npos);
  EXPECT_THROW(format_dxf(drawing, GetParam()), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(Versions, DxfWriter, testing::Values(DxfVersion::R12, DxfVersion::R2000),
                         [](const auto& tested) {
                           return std::string(tested.param == DxfVersion::R12 ? "R12" : "R2000");
                         });

}  // namespace
}  // namespace planewright
