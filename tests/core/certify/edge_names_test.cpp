// Names along sides in files: there, on their part, and nearest to the side of the neighbour that they name.
#include <gtest/gtest.h>

#include "core/writers/drawing_writers.h"
#include "support/certify_sample.h"

namespace planewright {
namespace {

using sample::replaced;
using sample::Strip;
using Names = std::vector<std::string>;

// The second part's names along its sides are A-1, to the left, and A-3, to the right.
DrawingText& edge_name(Drawing& drawing, const std::string& text) {
  return *std::find_if(drawing.texts.begin(), drawing.texts.end(),
                       [&](const auto& t) { return !t.is_name && t.panel == 1 && t.text == text; });
}

// What of a file fails that was written of another drawing than it should be.
class CertificateEdgeNames : public ::testing::Test {
 protected:
  void expect(const Names& failed) const {
    EXPECT_EQ(wanted.failures("a.dxf", FileKind::SheetDxf, written.dxf()), failed);
    EXPECT_EQ(wanted.failures("a.svg", FileKind::SheetSvg, written.svg()), failed);
    EXPECT_EQ(wanted.failures("a.pdf", FileKind::SheetsPdf, written.pdf()), failed);
  }
  Drawing& drawing() { return written.content.drawings[0]; }
  Strip wanted, written;
  const Names wrong{"edge names"};
};

TEST_F(CertificateEdgeNames, OnTheWrongSide) {
  std::swap(edge_name(drawing(), "A-1").at, edge_name(drawing(), "A-3").at);
  expect(wrong);
}
TEST_F(CertificateEdgeNames, NearerToAnotherSide) {
  edge_name(drawing(), "A-1").at += Eigen::Vector2d(0.0, -15.0);  // 1.7 from the side below, 2.7 from its own
  expect(wrong);
}
TEST_F(CertificateEdgeNames, StillNearestToItsOwn) {
  edge_name(drawing(), "A-1").at += Eigen::Vector2d(0.0, -13.0);
  expect({});
}
TEST_F(CertificateEdgeNames, OffThePart) {
  edge_name(drawing(), "A-1").at.x() -= 3.5;  // between both
  expect(wrong);
}
TEST_F(CertificateEdgeNames, OnTheNeighboursPart) {
  edge_name(drawing(), "A-3").at.x() += 10.0;  // where its own name is
  EXPECT_EQ(wanted.failures("a.dxf", FileKind::SheetDxf, written.dxf()), wrong);
  EXPECT_EQ(wanted.failures("a.svg", FileKind::SheetSvg, written.svg()), wrong);
  // Pages have no layers: there it is a second name of that part, and too small for one.
  EXPECT_EQ(wanted.failures("a.pdf", FileKind::SheetsPdf, written.pdf()),
            (Names{"names on their parts", "edge names", "legible names"}));
}
TEST_F(CertificateEdgeNames, Missing) {
  std::erase_if(drawing().texts, [](const auto& t) { return !t.is_name && t.panel == 1 && t.text == "A-1"; });
  expect(wrong);
}
TEST_F(CertificateEdgeNames, Twice) {
  drawing().texts.push_back(edge_name(drawing(), "A-1"));
  expect(wrong);
}
TEST_F(CertificateEdgeNames, OfNoNeighbour) {
  edge_name(drawing(), "A-1").text = "A-9";
  expect(wrong);
}
TEST_F(CertificateEdgeNames, NotesAreThere) {
  for (Strip* strip : {&wanted, &written})
    strip->content.drawings[0].texts.push_back(
        {DrawingLayer::Text, "FAILS: edge length", {60.0, 20.0}, 3.0, 0.0, 1, false});
  expect({});
  drawing().texts.back().text = "FAILS: area";
  expect(wrong);
  drawing().texts.pop_back();
  expect(wrong);
}

TEST_F(CertificateEdgeNames, GroupedWithAnotherPart) {
  const std::string svg = wanted.svg();
  const std::string group = "<g data-panel=\"A-2\"><text";
  const size_t edges = svg.find("<g id=\"TEXT_EDGES\"");
  const std::string wrongly = replaced(svg.substr(edges), group, "<g data-panel=\"A-3\"><text");
  EXPECT_EQ(wanted.failures("a.svg", FileKind::SheetSvg, svg.substr(0, edges) + wrongly), wrong);
}

// Mitred outwards more is cut than the outer face has: a name beside that is no name on it.
TEST_F(CertificateEdgeNames, InsideWhatIsCutButOffTheOuterFace) {
  for (Strip* strip : {&wanted, &written})
    for (FlatPattern& p : strip->patterns) {
      p.outer.resize(4, 2);
      p.outer << 1.0, 1.0, 32.0, 1.0, 32.0, 32.0, 1.0, 32.0;
    }
  expect({});
  edge_name(drawing(), "A-1").at.x() -= 2.0;  // 0.7 from the side that is cut
  expect(wrong);
}

// Two sides to one neighbour: either will do.
TEST_F(CertificateEdgeNames, EitherSideOfANeighbour) {
  edge_name(drawing(), "A-1").at += Eigen::Vector2d(14.0, -14.0);
  expect(wrong);
  wanted.passports[1].sides[0].neighbour = 0;
  expect({});
}

// At 1:5 the names of the strip are 0.6 mm high.
TEST(CertificateSmallEdgeNames, AreLeftOutOfThePageWhichSaysSo) {
  const Strip strip;
  const Names wrong{"edge names"};
  const std::string good = strip.pdf(5.0, 5.0);
  EXPECT_EQ(strip.failures("a.pdf", FileKind::SheetsPdf, good), Names{});
  EXPECT_EQ(strip.failures(
                "a.pdf", FileKind::SheetsPdf,
                replaced(good, std::string(kPdfEdgeNamesLeftOut), "Edge names are left in on this page..")),
            wrong);
  EXPECT_EQ(strip.failures("a.pdf", FileKind::SheetsPdf, strip.pdf(5.0, 5.0, true)),
            (Names{"edge names", "legible names"}));
  // Said where none are.
  EXPECT_EQ(strip.failures("a.pdf", FileKind::SheetsPdf,
                           replaced(strip.pdf(), "Drawn by hand at this scale, or at an",
                                    std::string(kPdfEdgeNamesLeftOut))),
            wrong);
}

TEST(CertificateSmallNames, OfPanelsHaveToBeLegibleWhereThereIsRoom) {
  const Strip strip;
  Strip other;
  for (DrawingText& t : other.content.drawings[0].texts)
    if (t.is_name) t.height = 2.5;  // 1.25 mm on paper
  EXPECT_EQ(strip.failures("a.pdf", FileKind::SheetsPdf, other.pdf()), (Names{"legible names"}));
  // None of 1.6 mm would fit: 3.3 mm of part on paper.
  EXPECT_EQ(strip.failures("a.pdf", FileKind::SheetsPdf, strip.pdf(10.0, 10.0)), Names{});
}

}  // namespace
}  // namespace planewright
