#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

#include "core/certify/pdf_reader.h"
#include "core/writers/drawing_writers.h"
#include "support/python.h"
#include "support/writer_scenes.h"

namespace planewright {
namespace {

using namespace test;

TEST(PdfWriter, ChoosesTheLargestUsualScaleThatFits) {
  PdfOptions options;
  Drawing drawing;
  EXPECT_EQ(page_scale(drawing, options), 1.0);
  drawing.width = drawing.height = 200.0;
  EXPECT_EQ(page_scale(drawing, options), 1.0);
  drawing.width = 3210.0;
  drawing.height = 6000.0;
  EXPECT_EQ(page_scale(drawing, options), 25.0);
  drawing.width = 1e6;
  EXPECT_EQ(page_scale(drawing, options), 5000.0);
  const double usual[] = {1, 2, 5, 10, 20, 25, 50, 100, 200, 250, 500, 1000};
  for (double size = 50.0; size < 2e5; size *= 1.3) {
    drawing.width = drawing.height = size;
    const double scale = page_scale(drawing, options);
    EXPECT_NE(std::find(std::begin(usual), std::end(usual), scale), std::end(usual)) << scale;
    EXPECT_LE(size / scale, 277.0);
  }
}

TEST(PdfWriter, HasAPagePerDrawingAndTextThatIsText) {
  const WorkshopModel model = named_cube();
  const std::vector<Drawing> drawings{hexagons(model, 3, 800.0, "Sheet 1"),
                                      hexagons(model, 2, 90.0, "Sheet 2")};
  PdfOptions options;
  options.title = {
      "Fa\xC3\xA7"
      "ade",
      "A. Mason", "2026-11-26", ""};
  const auto pdf = format_pdf(model, drawings, {"C-1 fits no sheet"}, options);
  ASSERT_TRUE(pdf);
  EXPECT_TRUE(pdf->starts_with("%PDF-1."));
  if (std::system("command -v pdftotext >/dev/null 2>&1") != 0) GTEST_SKIP() << "no pdftotext";
  const TemporaryFolder folder;
  const auto file = folder.write("sheets.pdf", *pdf);
  ASSERT_EQ(std::system(("pdftotext -layout " + file.string() + " " + (folder / "text").string()).c_str()),
            0);
  const std::string text = read_file(folder / "text").value();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\f'), 3);
  for (const char* expected : {"page 1 of 3", "page 3 of 3", "C-1 fits no sheet",
                               "Fa\xC3\xA7"
                               "ade",
                               "A. Mason", "Sheet 2", "1:20", "1:2", "2026-11-26"})
    EXPECT_NE(text.find(expected), std::string::npos) << expected;
  // Page 2 has every name, the first of the drawing's texts.
  const std::string page = text.substr(text.find('\f'));
  for (const std::string& name : model.names) EXPECT_NE(page.find(name), std::string::npos) << name;
}

// [number of points, width, height in mm, closed] of each path stroked or filled on each page.
constexpr const char* kPaths = R"(
import sys, json, re, zlib
pages = []
for m in re.finditer(rb"stream\r?\n(.*?)\r?\nendstream", open(sys.argv[1], "rb").read(), re.S):
    try: text = zlib.decompress(m.group(1)).decode("latin-1")
    except zlib.error: continue
    if " Tf" not in text: continue
    paths, stack, points, scale = [], [], [], 1.0
    scales = []
    for w in text.split():
        if w == "q": scales.append(scale)
        elif w == "Q" and scales: scale = scales.pop()
        elif w == "cm": scale *= abs(float(stack[-6]))
        elif w == "m": points = [(float(stack[-2]), float(stack[-1]))]
        elif w == "l": points.append((float(stack[-2]), float(stack[-1])))
        elif w == "h" and points:
            mm = scale * 25.4 / 72
            xs, ys = zip(*points)
            paths.append([len(points), (max(xs) - min(xs)) * mm, (max(ys) - min(ys)) * mm]); points = []
        stack.append(w)
    pages.append(paths)
print(json.dumps(pages))
)";

TEST(PdfWriter, DrawsPartsAtTheScaleItWrites) {
  const std::string python = python_with("zlib");
  if (python.empty()) GTEST_SKIP() << "no python";
  const WorkshopModel model = named_cube();
  const Drawing drawing = hexagons(model, 3, 800.0, "Sheet 1");
  const double scale = page_scale(drawing, {});
  ASSERT_EQ(scale, 20.0);
  const auto pdf = format_pdf(model, {drawing}, {}, {});
  ASSERT_TRUE(pdf);
  const nlohmann::json pages = read_with_python(python, kPaths, *pdf, "sheets.pdf");
  ASSERT_EQ(pages.size(), 2u);
  int cut = 0, engraved = 0;
  const Eigen::RowVector2d size =
      drawing.lines[1].points.colwise().maxCoeff() - drawing.lines[1].points.colwise().minCoeff();
  for (const auto& path : pages[1]) {
    if (path[0] != 6) {
      EXPECT_EQ(path[0], 4) << "only the sheet's border, with no stray point";
      continue;
    }
    const bool outer = std::abs(path[1].get<double>() - size.x() / scale) < 0.01 &&
                       std::abs(path[2].get<double>() - size.y() / scale) < 0.01;
    ++(outer ? cut : engraved);
  }
  EXPECT_EQ(cut, 6);
  EXPECT_EQ(engraved, 6);
}

// What the only sheet of a PDF says, as its reader sees it.
std::vector<ReadText> texts_of(const WorkshopModel& model, const Drawing& drawing,
                               const std::string& note = {}) {
  PdfOptions options;
  options.title.note = note;
  const auto pdf = format_pdf(model, {drawing}, {}, options);
  const TemporaryFolder folder;
  const auto pages = read_pdf(folder.write("sheets.pdf", pdf.value()));
  return pages.value().back().texts;
}
long long times(const std::vector<ReadText>& texts, std::string_view wanted) {
  return std::count_if(texts.begin(), texts.end(), [&](const ReadText& t) { return t.text == wanted; });
}

TEST(PdfWriter, LeavesOutEdgeNamesThatNobodyCouldReadAndSaysSo) {
  const WorkshopModel model = named_cube();
  for (const double height : {23.0, 25.0}) {  // at 1:20
    Drawing drawing = hexagons(model, 3, 800.0, "Sheet 1");
    for (DrawingText& text : drawing.texts)
      if (!text.is_name) text.height = height;
    DrawingText mark = drawing.texts[0];
    mark.text = "FAILS: area";
    mark.is_name = false;
    mark.height = 3.0;
    drawing.texts.push_back(mark);
    const bool left_out = height / 20.0 < kLeastPdfText;
    for (const std::string& note : {std::string(), std::string("a long note "), std::string(300, 'n')}) {
      const auto texts = texts_of(model, drawing, note);
      EXPECT_EQ(times(texts, kPdfEdgeNamesLeftOut), left_out ? 1 : 0) << note;
      EXPECT_EQ(times(texts, "FAILS: area"), 1);
      for (const std::string& name : model.names) EXPECT_EQ(times(texts, name), left_out ? 1 : 7) << name;
      for (const ReadText& text : texts) EXPECT_GE(text.height, 0.95 * kLeastPdfText) << text.text;
    }
  }
}

// Parts beside each other, whose names nearly touch: two texts, not one that cairo makes of both.
TEST(PdfWriter, NamesOnOneLineStayApart) {
  const WorkshopModel model = named_cube();
  Drawing drawing;
  drawing.title = "row";
  for (int p = 0; p < 6; ++p) {
    drawing.lines.push_back(
        {DrawingLayer::Cut, regular_polygon(6, 100.0, {100.0 + 210.0 * p, 100.0}), true, p});
    drawing.texts.push_back({DrawingLayer::Text,
                             model.names[static_cast<size_t>(p)],
                             {100.0 + 210.0 * p, 100.0},
                             80.0,
                             0.0,
                             p,
                             true});
  }
  drawing.width = 1250.0;
  drawing.height = 200.0;
  const auto texts = texts_of(model, drawing);
  for (const std::string& name : model.names) EXPECT_EQ(times(texts, name), 1) << name;
}

TEST(PdfWriter, NamesAreLegibleWhereTheirPartHasRoom) {
  const WorkshopModel model = named_cube();
  for (const double radius : {800.0, 40.0}) {
    Drawing drawing = hexagons(model, 3, 800.0, "Sheet 1");
    for (DrawingText& text : drawing.texts) text.height = 4.0;  // 0.2 mm at 1:20
    for (DrawingLine& line : drawing.lines)
      if (line.layer == DrawingLayer::Cut) {
        const Eigen::RowVector2d middle = line.points.colwise().mean();
        line.points = (line.points.rowwise() - middle) * (radius / 800.0);
        line.points.rowwise() += middle;
      }
    for (const ReadText& text : texts_of(model, drawing)) {
      if (std::find(model.names.begin(), model.names.end(), text.text) == model.names.end()) continue;
      const double room = 0.866 * radius / 20.0;
      if (radius > 100.0)
        EXPECT_GE(text.height, 0.95 * kLeastPdfName);
      else
        EXPECT_LE(std::hypot(text.width, text.height), 2.0 * room) << "inside its part";
    }
  }
}

TEST(PdfWriter, OfNoDrawingsIsAnIndexAndOfBadOnesRefused) {
  const WorkshopModel model = named_cube();
  EXPECT_TRUE(format_pdf(model, {}, {}, {}));
  PdfOptions small;
  small.page_width = 50.0;
  EXPECT_EQ(format_pdf(model, {}, {}, small).error().code, ErrorCode::Refused);
  Drawing drawing = hexagons(model, 3, 50.0, "Sheet 7");
  drawing.lines[1].points(0, 0) = std::numeric_limits<double>::quiet_NaN();
  const auto refused = format_pdf(model, {drawing}, {}, {});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().text().find("Sheet 7"), std::string::npos);
}

}  // namespace
}  // namespace planewright
