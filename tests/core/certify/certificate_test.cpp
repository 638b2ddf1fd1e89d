// Whole files: good ones pass, and each fault fails the checks that are about it, and no others.
#include "core/certify/certificate.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/certify_sample.h"

namespace planewright {
namespace {

using sample::replaced;
using sample::Strip;
using sample::text;
using Names = std::vector<std::string>;

// A coordinate of the second panel's contour, as the files write it.
std::string coordinate(const Strip& strip, int row, int axis) {
  for (const DrawingLine& l : strip.content.drawings[0].lines)
    if (l.layer == DrawingLayer::Cut && l.panel == 1) return text(l.points(row, axis));
  return {};
}

TEST(Certificate, GoodFilesPass) {
  const Strip strip;
  EXPECT_EQ(strip.failures("a.dxf", FileKind::SheetDxf, strip.dxf()), Names{});
  EXPECT_EQ(strip.failures("b.dxf", FileKind::SheetDxf, strip.dxf(true)), Names{});
  EXPECT_EQ(strip.failures("a.svg", FileKind::SheetSvg, strip.svg()), Names{});
  EXPECT_EQ(strip.failures("a.pdf", FileKind::SheetsPdf, strip.pdf()), Names{});
  EXPECT_EQ(strip.failures("panels.csv", FileKind::PanelCsv, strip.panel_csv()), Names{});
  EXPECT_EQ(strip.failures("edges.csv", FileKind::EdgeCsv, strip.edge_csv()), Names{});
  EXPECT_EQ(strip.failures("a.json", FileKind::ScheduleJson, strip.json()), Names{});
  for (const bool solid : {false, true}) {
    const FileKind kind = solid ? FileKind::SolidMesh : FileKind::PanelMesh;
    EXPECT_EQ(strip.failures("a.obj", kind, strip.obj(solid)), Names{});
    EXPECT_EQ(strip.failures("a.ply", kind, strip.ply(solid)), Names{});
    EXPECT_EQ(strip.failures("a.stl", kind, strip.stl(solid)), Names{});
    EXPECT_EQ(strip.failures("a.glb", kind, strip.gltf(solid)), Names{});
  }
  EXPECT_EQ(strip.failures("a.3mf", FileKind::SolidMesh, strip.three_mf()), Names{});
}

// The stroke of an engraved 0 is open, and ends where it begins.
TEST(Certificate, StrokesThatComeBackAreOpen) {
  Strip strip;
  Contour stroke(5, 2);
  stroke << 14.0, 14.0, 16.0, 14.0, 16.0, 17.0, 14.0, 17.0, 14.0, 14.0;
  strip.content.drawings[0].lines.push_back({DrawingLayer::Engrave, stroke, false, 0});
  EXPECT_EQ(strip.failures("a.dxf", FileKind::SheetDxf, strip.dxf()), Names{});
  EXPECT_EQ(strip.failures("b.dxf", FileKind::SheetDxf, strip.dxf(true)), Names{});
  EXPECT_EQ(strip.failures("a.svg", FileKind::SheetSvg, strip.svg()), Names{});
  // What is to be cut has to be closed.
  const std::string svg = strip.svg();
  const size_t cut = svg.find("<g id=\"CUT\"");
  EXPECT_EQ(strip.failures("a.svg", FileKind::SheetSvg,
                           svg.substr(0, cut) + replaced(svg.substr(cut), "<polygon", "<polyline")),
            (Names{"contours", "all: number of parts"}));
}

TEST(Certificate, WhatIsNoFileOfItsKindIsNotReadable) {
  const Strip strip;
  const std::vector<std::tuple<std::string, FileKind, std::string>> good{
      {"a.dxf", FileKind::SheetDxf, strip.dxf()},       {"a.svg", FileKind::SheetSvg, strip.svg()},
      {"a.pdf", FileKind::SheetsPdf, strip.pdf()},      {"p.csv", FileKind::PanelCsv, strip.panel_csv()},
      {"e.csv", FileKind::EdgeCsv, strip.edge_csv()},   {"a.json", FileKind::ScheduleJson, strip.json()},
      {"p.obj", FileKind::PanelMesh, strip.obj(false)}, {"p.ply", FileKind::PanelMesh, strip.ply(false)},
      {"p.stl", FileKind::PanelMesh, strip.stl(false)}, {"p.glb", FileKind::PanelMesh, strip.gltf(false)},
      {"s.3mf", FileKind::SolidMesh, strip.three_mf()}};
  for (const auto& [name, kind, bytes] : good) {
    const auto readable = [&](const std::string& content) {
      const Names failed = strip.failures(name, kind, content);
      return std::find(failed.begin(), failed.end(), "readable") == failed.end();
    };
    EXPECT_TRUE(readable(bytes)) << name;
    EXPECT_FALSE(readable(bytes.substr(0, bytes.size() * 6 / 10))) << name << " truncated";
    EXPECT_FALSE(readable("This is a letter, not a drawing.")) << name;
    EXPECT_FALSE(readable("")) << name;
  }
  EXPECT_FALSE(certify(strip.folder, {{"absent.dxf", FileKind::SheetDxf, 0}}, strip.content).pass());
  EXPECT_FALSE(certify(strip.folder, {{"absent.xyz", FileKind::PanelMesh, 0}}, strip.content).pass());
}

TEST(Certificate, DrawingsAtTheWrongScale) {
  const Strip strip;
  // Inches that are millimetres: nothing lies where it should, which is said once for each.
  const Names dxf = strip.failures("a.dxf", FileKind::SheetDxf,
                                   replaced(strip.dxf(), "$INSUNITS\n70\n4", "$INSUNITS\n70\n1"));
  EXPECT_EQ(dxf, (Names{"scale", "size", "contours", "engraving", "sheet border", "names on their parts",
                        "edge names"}));
  EXPECT_EQ(strip.failures("a.dxf", FileKind::SheetDxf,
                           replaced(strip.dxf(), "$INSUNITS\n70\n4", "$INSUNITS\n70\n0")),
            (Names{"scale"}));
  const Names svg = strip.failures("a.svg", FileKind::SheetSvg,
                                   replaced(replaced(strip.svg(), "width=\"150mm\"", "width=\"150in\""),
                                            "height=\"60mm\"", "height=\"60in\""));
  EXPECT_EQ(svg, (Names{"scale", "size", "contours", "engraving", "sheet border", "names on their parts",
                        "edge names"}));
  EXPECT_EQ(strip.failures("a.pdf", FileKind::SheetsPdf, strip.pdf(5.0, 2.0)),
            (Names{"scale", "contours", "names on their parts", "edge names", "legible names"}));
}

TEST(Certificate, NamesMissingTwiceAndAstray) {
  const Strip strip;
  const std::string dxf = strip.dxf(), svg = strip.svg();
  const std::string in_dxf = "1\nA-2\n72", in_svg = ">A-2</text>";
  const Names once{"every name once", "all: every name once"};
  // The first A-2 of a file is an edge's name, or the panel's: the DXF has them panel by panel.
  const std::string own = dxf.substr(dxf.find("0\nTEXT\n8\nTEXT\n", dxf.find("A-1\n")));
  EXPECT_EQ(
      strip.failures("a.dxf", FileKind::SheetDxf, replaced(dxf, own, replaced(own, in_dxf, "1\nA-9\n72"))),
      once);
  const std::string entity = own.substr(0, own.find("73\n2\n") + 5);
  EXPECT_EQ(strip.failures("a.dxf", FileKind::SheetDxf, replaced(dxf, own, entity + own)), once);
  const std::string panel = "<g data-panel=\"A-2\"><text";
  const std::string svg_own =
      svg.substr(svg.find(panel), svg.find("</g>", svg.find(panel)) + 4 - svg.find(panel));
  EXPECT_EQ(strip.failures("a.svg", FileKind::SheetSvg, replaced(svg, svg_own, "")), once);
  EXPECT_EQ(strip.failures("a.svg", FileKind::SheetSvg, replaced(svg, svg_own, svg_own + svg_own)), once);
  // A name on the neighbour's part.
  const std::string x = "<text x=\"" + text(strip.content.drawings[0].texts[2].at.x());
  const Names astray = strip.failures("a.svg", FileKind::SheetSvg,
                                      replaced(svg, svg_own, replaced(svg_own, x, "<text x=\"100")));
  EXPECT_EQ(astray, (Names{"names on their parts"}));
}

TEST(Certificate, AVertexMovedByAMicrometre) {
  const Strip strip;
  const std::string x = coordinate(strip, 0, 0);
  const std::string moved = text(std::stod(x) + 1e-3), hardly = text(std::stod(x) + 1e-7);
  EXPECT_EQ(strip.failures("a.dxf", FileKind::SheetDxf, replaced(strip.dxf(), "10\n" + x, "10\n" + moved)),
            (Names{"contours"}));
  EXPECT_EQ(strip.failures("a.dxf", FileKind::SheetDxf, replaced(strip.dxf(), "10\n" + x, "10\n" + hardly)),
            Names{});
  EXPECT_EQ(strip.failures("a.svg", FileKind::SheetSvg, replaced(strip.svg(), x + ",", moved + ",")),
            (Names{"contours"}));
  // In PDF that is below what paper shows; a tenth of a millimetre is not.
  for (const double by : {1e-3, 0.1}) {
    Strip other;
    for (DrawingLine& l : other.content.drawings[0].lines)
      if (l.panel == 1 && l.closed) l.points(2, 0) += by;
    EXPECT_EQ(strip.failures("a.pdf", FileKind::SheetsPdf, other.pdf()),
              by < 0.01 ? Names{} : (Names{"contours"}));
  }
}

TEST(Certificate, AContourReversed) {
  const Strip strip;
  Strip other;
  for (DrawingLine& l : other.content.drawings[0].lines)
    if (l.panel == 1 && l.closed) l.points = l.points.colwise().reverse().eval();
  EXPECT_EQ(strip.failures("a.dxf", FileKind::SheetDxf, other.dxf()), (Names{"orientation"}));
  EXPECT_EQ(strip.failures("a.svg", FileKind::SheetSvg, other.svg()), (Names{"orientation"}));
}

TEST(Certificate, APartMissingOrOnAnotherLayer) {
  const Strip strip;
  Strip other;
  auto& lines = other.content.drawings[0].lines;
  lines.erase(
      std::find_if(lines.begin(), lines.end(), [](const auto& l) { return l.panel == 1 && l.closed; }));
  const Names missing{"contours", "all: number of parts"};
  EXPECT_EQ(strip.failures("a.dxf", FileKind::SheetDxf, other.dxf()), missing);
  EXPECT_EQ(strip.failures("a.svg", FileKind::SheetSvg, other.svg()), missing);
  EXPECT_EQ(strip.failures("a.pdf", FileKind::SheetsPdf, other.pdf()), (Names{"contours"}));
  EXPECT_EQ(strip.failures("a.dxf", FileKind::SheetDxf, replaced(strip.dxf(), "2\nENGRAVE", "2\nMARKS")),
            (Names{"layers"}));
}

TEST(Certificate, SchedulesWithOtherValues) {
  const Strip strip;
  const std::string area = text(sample::kSide * sample::kSide * 1e-6);
  EXPECT_EQ(strip.failures("p.csv", FileKind::PanelCsv, replaced(strip.panel_csv(), area, "0.00112")),
            (Names{"values of the passports"}));
  EXPECT_EQ(strip.failures("p.csv", FileKind::PanelCsv, replaced(strip.panel_csv(), "A-2,", "A-1,")),
            (Names{"every name once", "values of the passports", "verdicts and failures"}));
  EXPECT_EQ(strip.failures("p.csv", FileKind::PanelCsv, replaced(strip.panel_csv(), "area_m2", "area")),
            (Names{"columns"}));
  EXPECT_EQ(strip.failures("e.csv", FileKind::EdgeCsv, replaced(strip.edge_csv(), "A-1,2,A-2", "A-1,2,A-3")),
            (Names{"values of the passports"}));
  EXPECT_EQ(strip.failures("e.csv", FileKind::EdgeCsv, replaced(strip.edge_csv(), "A-1,2,", "A-1,1,")),
            (Names{"every side once"}));
  EXPECT_EQ(strip.failures("a.json", FileKind::ScheduleJson,
                           replaced(strip.json(), "\"unit\":\"mm\"", "\"unit\":\"m\"")),
            (Names{"scale"}));
  EXPECT_EQ(
      strip.failures("a.json", FileKind::ScheduleJson, replaced(strip.json(), "[[1000,", "[[1000.001,")),
      (Names{"corners"}));
}

TEST(Certificate, MeshesWithFaults) {
  const Strip strip;
  const std::string obj = strip.obj(false), solid = strip.obj(true);
  EXPECT_EQ(strip.failures("p.obj", FileKind::PanelMesh, replaced(obj, "units: mm", "units: inch")),
            (Names{"scale"}));
  EXPECT_EQ(strip.failures("p.obj", FileKind::PanelMesh, replaced(obj, "f 2 3 7 6", "f 6 7 3 2")),
            (Names{"outside", "shared edges"}));
  EXPECT_EQ(strip.failures("p.obj", FileKind::PanelMesh, replaced(obj, "g A-2", "g A-7")),
            (Names{"every name once"}));
  // One corner a micrometre above the plane.
  EXPECT_EQ(
      strip.failures("p.obj", FileKind::PanelMesh, replaced(obj, "v 1000 2000 500", "v 1000 2000 500.001")),
      (Names{"corners", "outside", "planarity"}));
  EXPECT_EQ(strip.failures("s.obj", FileKind::SolidMesh, replaced(solid, "f 8 7 6 5\n", "")),
            (Names{"closed", "volume"}));
  EXPECT_EQ(
      strip.failures("s.ply", FileKind::SolidMesh, replaced(strip.ply(true), "4 7 6 5 4 0", "4 4 5 6 7 0")),
      (Names{"closed", "volume"}));
  EXPECT_EQ(strip.failures("s.3mf", FileKind::SolidMesh, strip.three_mf("inch")), (Names{"scale"}));
  // A triangle less in a binary STL.
  std::string stl = strip.stl(true);
  stl.resize(stl.size() - 50);
  stl[80] = static_cast<char>(stl[80] - 1);
  EXPECT_EQ(strip.failures("s.stl", FileKind::SolidMesh, stl),
            (Names{"number of solids", "closed", "volume"}));
  EXPECT_EQ(strip.failures("s.glb", FileKind::SolidMesh, replaced(strip.gltf(true), "\"A-2\"", "\"A-1\"")),
            (Names{"every name once", "closed", "volume", "corners"}));
}

TEST(Certificate, SolidsInsideOut) {
  Strip strip;
  const std::string good = strip.obj(true);
  std::string turned;
  std::istringstream in(good);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string f, a, b, c, d;
    if (line.starts_with("f ") && words >> f >> a >> b >> c >> d)
      line = "f " + d + " " + c + " " + b + " " + a;
    turned += line + "\n";
  }
  EXPECT_EQ(strip.failures("s.obj", FileKind::SolidMesh, turned), (Names{"positive volume", "volume"}));
}

// --- The design itself
// ----------------------------------------------------------------------------------------

Names design(const Strip& strip) {
  Names failed;
  for (const Check& c : certify(strip.folder, {}, strip.content).design)
    if (!c.pass) failed.push_back(c.name);
  return failed;
}

TEST(Certificate, DesignThatHolds) {
  const Strip strip;
  EXPECT_EQ(design(strip), Names{});
  EXPECT_EQ(certify(strip.folder, {}, strip.content).design.size(), 12u);
}

TEST(Certificate, DesignWithFaults) {
  {
    Strip s;
    s.model.points(0, 2) = 0.01;
    EXPECT_EQ(design(s), (Names{"planarity", "areas of patterns and panels"}));  // neither know of it
  }
  {
    Strip s;
    s.verdicts.failures.push_back({1, ToleranceKind::Planarity, -1, 0.7, 0.5});
    EXPECT_EQ(design(s), (Names{"planarity"}));
  }
  {
    Strip s;
    s.model.points.row(0).swap(s.model.points.row(4));
    const Names failed = design(s);
    EXPECT_NE(std::find(failed.begin(), failed.end(), "simple polygons"), failed.end());
  }
  {
    Strip s;
    s.patterns[1].nominal(0, 1) -= 1e-3;  // longer at one end alone
    EXPECT_EQ(design(s), (Names{"equal lengths of shared edges", "areas of patterns and panels"}));
  }
  {
    Strip s;
    s.solids.panels[0].faces = {{0, 1, 2, 3}, {7, 6, 5, 4}, {1, 0, 4, 5}, {2, 1, 5, 6}, {3, 2, 6, 7}};
    EXPECT_EQ(design(s), (Names{"closed solids"}));
  }
  {
    Strip s;
    s.solids.panels[1].points.col(0).array() += 0.01;
    EXPECT_EQ(design(s), (Names{"no penetrating solids"}));
    s.solids.panels[1].points.col(0).array() -= 0.01 + 1e-7;
    EXPECT_EQ(design(s), Names{});  // within the tolerance
  }
  {
    Strip s;  // two in one place: no two triangles cross
    s.solids.panels[2].points = s.solids.panels[1].points;
    EXPECT_EQ(design(s), (Names{"no penetrating solids"}));
  }
}

TEST(Certificate, LeftOutPanelsAreNotMissed) {
  Strip strip;
  auto& d = strip.content.drawings[0];
  std::erase_if(d.lines, [](const auto& l) { return l.panel == 2; });
  std::erase_if(d.texts, [](const auto& t) { return t.panel == 2; });
  const std::string two = strip.dxf();
  EXPECT_EQ(strip.failures("a.dxf", FileKind::SheetDxf, two),
            (Names{"design: every part on one drawing", "all: every name once", "all: number of parts"}));
  strip.content.left_out = {2};
  EXPECT_EQ(strip.failures("a.dxf", FileKind::SheetDxf, two), Names{});
}

TEST(Certificate, ReportAndPageSayTheVerdict) {
  Strip strip;
  strip.model.title = "<b>roof & \"dome\"</b>";
  strip.write("a.dxf", strip.dxf());
  const Certificate good = certify(strip.folder, {{"a.dxf", FileKind::SheetDxf, 0}}, strip.content);
  const auto json = nlohmann::json::parse(to_json(good, strip.content));
  EXPECT_EQ(json["pass"], true);
  EXPECT_EQ(json["files"].size(), 2u);
  EXPECT_EQ(json["files"][0]["checks"][0]["name"], "readable");
  const std::string page = certificate_page(good, strip.content);
  EXPECT_NE(page.find("PASS"), std::string::npos);
  EXPECT_EQ(page.find("FAIL"), std::string::npos);
  EXPECT_EQ(page.find("<b>"), std::string::npos);
  EXPECT_NE(page.find("&lt;b&gt;roof &amp; &quot;dome&quot;&lt;/b&gt;"), std::string::npos);
  EXPECT_EQ(page.find("http"), std::string::npos);  // needs nothing else

  strip.write("a.dxf", "\xff\xfe<script>");
  const Certificate bad = certify(strip.folder, {{"a.dxf", FileKind::SheetDxf, 0}}, strip.content);
  EXPECT_EQ(nlohmann::json::parse(to_json(bad, strip.content))["pass"], false);
  const std::string fails = certificate_page(bad, strip.content);
  EXPECT_NE(fails.find("FAIL"), std::string::npos);
  EXPECT_NE(fails.find("What fails"), std::string::npos);
  EXPECT_EQ(fails.find("<script>"), std::string::npos);
}

TEST(Certificate, ProgressReachesTheEnd) {
  const Strip strip;
  strip.write("a.json", strip.json());
  std::vector<std::pair<int, int>> told;
  certify(strip.folder, {{"a.json", FileKind::ScheduleJson}}, strip.content,
          [&](int done, int total) { told.emplace_back(done, total); });
  EXPECT_EQ(told.front(), std::pair(0, 2));
  EXPECT_EQ(told.back(), std::pair(2, 2));
}

}  // namespace
}  // namespace planewright
