// A strip of three thick square panels, and its files written by hand, for tests of the certificate: what a
// writer would write, without any of the writers.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numeric>
#include <sstream>
#include <string>

#include "core/certify/certificate.h"

namespace planewright::sample {

inline constexpr double kSide = 100.0 / 3.0, kThick = 10.0;

inline std::string text(double v) {
  std::ostringstream out;
  out.precision(17);
  out << v;
  return out.str();
}
inline std::string replaced(std::string in, const std::string& from, const std::string& to) {
  const size_t at = in.find(from);
  if (at == std::string::npos) throw std::runtime_error("the sample has no '" + from + "'");
  return in.replace(at, from.size(), to);
}

class Strip {
 public:
  Strip() {
    namespace fs = std::filesystem;
    static int made = 0;
    folder = fs::temp_directory_path() /
             ("planewright-certify-" + std::to_string(::getpid()) + "-" + std::to_string(made++));
    fs::create_directories(folder);
    make_model();
    make_parts();
    content = {&model, &passports, &verdicts, &patterns, &solids, {drawing()}, {}, {}};
    // The second panel lies on the first turned by a quarter, the third turned over.
    classes = {{{{0}, {1, false, 1, 0.0}, {2, true, 2, 0.0}}}};
    content.classes = &classes;
    content.nesting = NestingOptions{{150.0, 60.0}, 2.0, 5.0, true};
  }
  ~Strip() { std::filesystem::remove_all(folder); }
  Strip(const Strip&) = delete;

  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder / name, std::ios::binary) << bytes;
  }
  // The certificate of one file alone, and what of it fails: "every name once" (its own checks), "all: ..."
  // (all files together), "design: ...".
  std::vector<std::string> failures(const std::string& name, FileKind kind, const std::string& bytes) const {
    write(name, bytes);
    const Certificate c = certify(folder, {{name, kind, 0}}, content);
    std::vector<std::string> failed;
    for (const Check& check : c.design)
      if (!check.pass) failed.push_back("design: " + check.name);
    for (size_t f = 0; f < c.files.size(); ++f)
      for (const Check& check : c.files[f].checks)
        if (!check.pass) failed.push_back((f > 0 ? "all: " : "") + check.name);
    EXPECT_EQ(c.pass(), failed.empty());
    return failed;
  }

  std::string dxf(bool r12 = false) const {
    std::string out =
        "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n9\n$EXTMIN\n10\n0\n20\n0\n30\n0\n9\n$EXTMAX\n10\n" +
        text(content.drawings[0].width) + "\n20\n" + text(content.drawings[0].height) +
        "\n30\n0\n0\nENDSEC\n0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n70\n4\n";
    for (const char* layer : {"CUT", "ENGRAVE", "TEXT", "TEXT_EDGES", "SHEET"})
      out += std::string("0\nLAYER\n2\n") + layer + "\n70\n0\n62\n7\n6\nCONTINUOUS\n";
    out += "0\nENDTAB\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
    for (const DrawingLine& l : content.drawings[0].lines) {
      const std::string layer = layer_of(l.layer), closed = l.closed ? "1" : "0";
      const std::string count = std::to_string(l.points.rows());
      out += r12 ? "0\nPOLYLINE\n8\n" + layer + "\n66\n1\n10\n0\n20\n0\n30\n0\n70\n" + closed + "\n"
                 : "0\nLWPOLYLINE\n8\n" + layer + "\n90\n" + count + "\n70\n" + closed + "\n";
      for (Eigen::Index i = 0; i < l.points.rows(); ++i) {
        const std::string point = "10\n" + text(l.points(i, 0)) + "\n20\n" + text(l.points(i, 1)) + "\n";
        out += r12 ? "0\nVERTEX\n8\n" + layer + "\n" + point + "30\n0\n" : point;
      }
      if (r12) out += "0\nSEQEND\n8\n" + layer + "\n";
    }
    for (const DrawingText& t : content.drawings[0].texts)
      out += std::string("0\nTEXT\n8\n") + (t.is_name ? "TEXT" : "TEXT_EDGES") + "\n10\n" +
             text(t.at.x() - 5.0) + "\n20\n" + text(t.at.y() - 2.0) + "\n30\n0\n40\n4\n1\n" + t.text +
             "\n72\n1\n11\n" + text(t.at.x()) + "\n21\n" + text(t.at.y()) + "\n31\n0\n73\n2\n";
    return out + "0\nENDSEC\n0\nEOF\n";
  }

  std::string svg() const {
    const Drawing& d = content.drawings[0];
    const auto y = [&](double up) { return text(d.height - up); };
    std::string out =
        "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
        "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" width=\"" +
        text(d.width) + "mm\" height=\"" + text(d.height) + "mm\" viewBox=\"0 0 " + text(d.width) + " " +
        text(d.height) + "\">\n";
    for (const DrawingLayer layer : {DrawingLayer::Sheet, DrawingLayer::Cut, DrawingLayer::Engrave}) {
      out += "<g id=\"" + layer_of(layer) + "\" inkscape:label=\"" + layer_of(layer) +
             "\" inkscape:groupmode=\"layer\">\n";
      for (const DrawingLine& l : d.lines) {
        if (l.layer != layer) continue;
        out += l.closed ? "<polygon points=\"" : "<polyline points=\"";
        for (Eigen::Index i = 0; i < l.points.rows(); ++i)
          out += text(l.points(i, 0)) + "," + y(l.points(i, 1)) + " ";
        out += "\"/>\n";
      }
      out += "</g>\n";
    }
    for (const bool names : {true, false}) {
      const std::string layer = names ? "TEXT" : "TEXT_EDGES";
      out += "<g id=\"" + layer + "\" inkscape:label=\"" + layer + "\" inkscape:groupmode=\"layer\">\n";
      for (const DrawingText& t : d.texts)
        if (t.is_name == names)
          out += "<g data-panel=\"" + model.names[static_cast<size_t>(t.panel)] + "\"><text x=\"" +
                 text(t.at.x()) + "\" y=\"" + y(t.at.y()) + "\">" + t.text + "</text></g>\n";
      out += "</g>\n";
    }
    return out + "</svg>\n";
  }

  // Two pages, the drawing at 1:n; names are as high on paper as that makes them, those of panels at
  // least 1.7 mm up to 1:5. small: those along sides that should be left out are there.
  std::string pdf(double written = 2.0, double drawn = 2.0, bool small = false) const {
    const Drawing& d = content.drawings[0];
    const double point = 72.0 / 25.4;
    const auto paper = [&](double v) { return text(std::round((20.0 + v / drawn) * point * 256.0) / 256.0); };
    std::string page = "0.5 w\n";
    for (const DrawingLine& l : d.lines) {
      for (Eigen::Index i = 0; i < l.points.rows(); ++i)
        page += paper(l.points(i, 0)) + " " + paper(l.points(i, 1)) + (i == 0 ? " m " : " l ");
      page += l.closed ? "h S\n" : "S\n";
    }
    // Half an em wide, capitals 0.7 of one high.
    bool left_out = false;
    for (const DrawingText& t : d.texts) {
      const bool tiny = !t.is_name && t.height / drawn < 1.2;
      left_out = left_out || tiny;
      if (tiny && !small) continue;
      const double least = t.is_name && drawn == 5.0 ? 1.7 : 0.0;
      const double size = std::max(least, t.height / drawn) * point / 0.7;
      const double width = 0.5 * size * static_cast<double>(t.text.size());
      page += "BT " + text(size) + " 0 0 " + text(size) + " " +
              text((20.0 + t.at.x() / drawn) * point - 0.5 * width) + " " +
              text((20.0 + t.at.y() / drawn) * point - 0.35 * size) + " Tm /F1 1 Tf (" + t.text + ")Tj ET\n";
    }
    page += std::string("BT 9 0 0 9 700 20 Tm /F1 1 Tf (") +
            (left_out ? "Edge names are left out at this scale" : "Drawn by hand at this scale, or at an") +
            ")Tj ET\n";
    page += "BT 9 0 0 9 700 40 Tm /F1 1 Tf [(Scale )-20(1:" + text(written) + ")]TJ ET\n";
    return pdf_of({"BT 9 0 0 9 60 700 Tm /F1 1 Tf (Index)Tj ET\n", page});
  }

  std::string obj(bool solid) const {
    std::string out = "# units: mm\n";
    int first = 1;
    for (int p = 0; p < 3; ++p) {
      const ThickPanel& s = solids.panels[static_cast<size_t>(p)];
      if (solid || p == 0) out += vertices("v ", solid ? s.points : model.points);
      out += "g " + model.names[static_cast<size_t>(p)] + "\n";
      const int faces = solid ? s.faces.size() : 1;
      for (int f = 0; f < faces; ++f) {
        out += "f";
        for (const int c : solid ? s.faces[f] : model.panels[p]) out += " " + std::to_string(c + first);
        out += "\n";
      }
      if (solid) first += static_cast<int>(s.points.rows());
    }
    return out;
  }

  std::string ply(bool solid) const {
    std::string points, faces, names;
    int first = 0, count = 0;
    for (int p = 0; p < 3; ++p) {
      const ThickPanel& s = solids.panels[static_cast<size_t>(p)];
      names += "comment panel " + std::to_string(p) + " " + model.names[static_cast<size_t>(p)] + "\n";
      if (solid || p == 0) points += vertices("", solid ? s.points : model.points);
      for (int f = 0; f < (solid ? s.faces.size() : 1); ++f, ++count) {
        const auto corners = solid ? s.faces[f] : model.panels[p];
        faces += std::to_string(corners.size());
        for (const int c : corners) faces += " " + std::to_string(c + first);
        faces += " " + std::to_string(p) + "\n";
      }
      if (solid) first += static_cast<int>(s.points.rows());
    }
    return "ply\nformat ascii 1.0\ncomment units: mm\n" + names + "element vertex " +
           std::to_string(solid ? first : static_cast<int>(model.points.rows())) +
           "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
           std::to_string(count) +
           "\nproperty list uchar int vertex_indices\nproperty int panel\nend_header\n" + points + faces;
  }

  std::string stl(bool solid) const {
    std::string body;
    std::uint32_t count = 0;
    const auto add = [&](const Points& points, std::span<const int> face) {
      for (size_t k = 1; k + 1 < face.size(); ++k, ++count) {
        body.append(12, '\0');
        for (const size_t c : {size_t{0}, k, k + 1})
          for (int a = 0; a < 3; ++a) append(body, static_cast<float>(points(face[c], a)));
        body.append(2, '\0');
      }
    };
    for (int p = 0; p < 3; ++p) {
      const ThickPanel& s = solids.panels[static_cast<size_t>(p)];
      if (!solid) add(model.points, model.panels[p]);
      for (int f = 0; solid && f < s.faces.size(); ++f) add(s.points, s.faces[f]);
    }
    std::string out = "mm";
    out.resize(80, ' ');
    append(out, count);
    return out + body;
  }

  // Triangles, metres, y up; each panel a node at its own place.
  std::string gltf(bool solid) const {
    std::string bin, nodes, meshes, views, accessors, scene;
    for (int p = 0; p < 3; ++p) {
      const ThickPanel& s = solids.panels[static_cast<size_t>(p)];
      const Points& points = solid ? s.points : model.points;
      const size_t vertex_at = bin.size();
      std::string low, high;
      Eigen::Array3d least = Eigen::Array3d::Constant(1e9), most = -least;
      for (Eigen::Index i = 0; i < points.rows(); ++i) {
        const Eigen::Array3d at(points(i, 0) / 1000.0, points(i, 2) / 1000.0, -points(i, 1) / 1000.0);
        for (int a = 0; a < 3; ++a) append(bin, static_cast<float>(at[a]));
        least = least.min(at.cast<float>().cast<double>());
        most = most.max(at.cast<float>().cast<double>());
      }
      const size_t index_at = bin.size();
      std::uint32_t count = 0;
      for (int f = 0; f < (solid ? s.faces.size() : 1); ++f) {
        const auto face = solid ? s.faces[f] : model.panels[p];
        for (size_t k = 1; k + 1 < face.size(); ++k, count += 3)
          for (const size_t c : {size_t{0}, k, k + 1}) append(bin, static_cast<std::uint32_t>(face[c]));
      }
      const std::string i = std::to_string(p), comma = p > 0 ? "," : "";
      const auto list = [](const Eigen::Array3d& v) {
        return "[" + text(v[0]) + "," + text(v[1]) + "," + text(v[2]) + "]";
      };
      scene += comma + i;
      nodes += comma + R"({"name":")" + model.names[static_cast<size_t>(p)] + R"(","mesh":)" + i +
               R"(,"translation":)" +
               list({model.origin.x() / 1000.0, model.origin.z() / 1000.0, -model.origin.y() / 1000.0}) + "}";
      meshes += comma + R"({"primitives":[{"attributes":{"POSITION":)" + std::to_string(2 * p) +
                R"(},"indices":)" + std::to_string(2 * p + 1) + "}]}";
      views += comma + R"({"buffer":0,"byteOffset":)" + std::to_string(vertex_at) + R"(,"byteLength":)" +
               std::to_string(index_at - vertex_at) + R"(},{"buffer":0,"byteOffset":)" +
               std::to_string(index_at) + R"(,"byteLength":)" + std::to_string(bin.size() - index_at) + "}";
      accessors += comma + R"({"bufferView":)" + std::to_string(2 * p) +
                   R"(,"componentType":5126,"type":"VEC3","count":)" + std::to_string(points.rows()) +
                   R"(,"min":)" + list(least) + R"(,"max":)" + list(most) + R"(},{"bufferView":)" +
                   std::to_string(2 * p + 1) + R"(,"componentType":5125,"type":"SCALAR","count":)" +
                   std::to_string(count) + "}";
    }
    std::string json = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[)" + scene +
                       R"(]}],"nodes":[)" + nodes + R"(],"meshes":[)" + meshes + R"(],"bufferViews":[)" +
                       views + R"(],"accessors":[)" + accessors + R"(],"buffers":[{"byteLength":)" +
                       std::to_string(bin.size()) + "}]}";
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::string out = "glTF";
    append(out, std::uint32_t{2});
    append(out, static_cast<std::uint32_t>(28 + json.size() + bin.size()));
    append(out, static_cast<std::uint32_t>(json.size()));
    out += "JSON" + json;
    append(out, static_cast<std::uint32_t>(bin.size()));
    return out + std::string("BIN\0", 4) + bin;
  }

  // A package without compression.
  std::string three_mf(const std::string& unit = "millimeter") const {
    std::string objects, items;
    for (int p = 0; p < 3; ++p) {
      const ThickPanel& s = solids.panels[static_cast<size_t>(p)];
      const std::string id = std::to_string(p + 1);
      objects += "<object id=\"" + id + "\" name=\"" + model.names[static_cast<size_t>(p)] +
                 "\" type=\"model\"><mesh><vertices>";
      for (Eigen::Index i = 0; i < s.points.rows(); ++i)
        objects += "<vertex x=\"" + text(s.points(i, 0) + model.origin.x()) + "\" y=\"" +
                   text(s.points(i, 1) + model.origin.y()) + "\" z=\"" +
                   text(s.points(i, 2) + model.origin.z()) + "\"/>";
      objects += "</vertices><triangles>";
      for (int f = 0; f < s.faces.size(); ++f)
        for (int k = 1; k + 1 < s.faces.valence(f); ++k)
          objects += "<triangle v1=\"" + std::to_string(s.faces[f][0]) + "\" v2=\"" +
                     std::to_string(s.faces[f][static_cast<size_t>(k)]) + "\" v3=\"" +
                     std::to_string(s.faces[f][static_cast<size_t>(k) + 1]) + "\"/>";
      objects += "</triangles></mesh></object>";
      items += "<item objectid=\"" + id + "\"/>";
    }
    return package(
        {{"[Content_Types].xml",
          "<?xml version=\"1.0\"?><Types "
          "xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
          "<Default Extension=\"rels\" "
          "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
          "<Default Extension=\"model\" "
          "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>"},
         {"_rels/.rels",
          "<?xml version=\"1.0\"?><Relationships "
          "xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
          "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
          "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"},
         {"3D/3dmodel.model",
          "<?xml version=\"1.0\"?><model unit=\"" + unit +
              "\" xml:lang=\"en-US\" "
              "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"><resources>" +
              objects + "</resources><build>" + items + "</build></model>"}});
  }

  std::string panel_csv() const {
    std::string out =
        "name,number,class,mirrored,corners,area_m2,perimeter_mm,width_mm,height_mm,planarity_mm,"
        "distance_mm,weight_kg,sheet,verdict,failures\r\n";
    const std::string failures = "edge_min side 2: " + text(kSide) +
                                 " < 50; edge_min side 4: " + text(kSide) + " < 50; area_max: 0.5 > 0.25";
    for (const PanelPassport& p : passports)
      out += model.names[static_cast<size_t>(p.panel)] + "," + std::to_string(p.panel + 7) + ",1," +
             (p.panel == 2 ? "yes" : "no") + ",4," + text(p.area * 1e-6) + "," + text(p.perimeter) + "," +
             text(p.width) + "," + text(p.height) + ",0,," + text(*p.weight) + ",1," +
             (p.panel == 1 ? "fail," + failures : "pass,") + "\r\n";
    return out;
  }
  std::string edge_csv() const {
    std::string out = "panel,side,neighbour,length_mm,interior_deg,dihedral_deg,bevel_deg\r\n";
    for (const PanelPassport& p : passports)
      for (size_t k = 0; k < 4; ++k)
        out += model.names[static_cast<size_t>(p.panel)] + "," + std::to_string(k + 1) + "," +
               neighbour(p, k) + "," + text(p.sides[k].length) + ",90,180,0\r\n";
    return out;
  }
  std::string json() const {
    std::string panels, names, members, parts;
    const auto failure = [](const char* kind, const char* side, double measured, const char* limit) {
      return std::string(R"({"kind":")") + kind + R"(","side":)" + side + R"(,"measured":)" + text(measured) +
             R"(,"limit":)" + limit + "}";
    };
    const std::string failures = failure("edge_min", "2", kSide, "50") + "," +
                                 failure("edge_min", "4", kSide, "50") + "," +
                                 failure("area_max", "null", 0.5, "0.25");
    for (const PanelPassport& p : passports) {
      const std::string name = model.names[static_cast<size_t>(p.panel)], comma = p.panel > 0 ? "," : "";
      std::string sides, corners;
      for (size_t k = 0; k < 4; ++k) {
        const std::string other = neighbour(p, k);
        sides += std::string(k > 0 ? "," : "") + R"({"neighbour":)" +
                 (other.empty() ? "null" : "\"" + other + "\"") + R"(,"length_mm":)" +
                 text(p.sides[k].length) + R"(,"interior_deg":90,"dihedral_deg":180,"bevel_deg":0})";
        const Vector3d at = model.points.row(model.panels[p.panel][k]).transpose() + model.origin;
        corners += std::string(k > 0 ? "," : "") + "[" + text(at.x()) + "," + text(at.y()) + "," +
                   text(at.z()) + "]";
      }
      panels += comma + R"({"name":")" + name + R"(","number":)" + std::to_string(p.panel + 7) +
                R"(,"area_m2":)" + text(p.area * 1e-6) + R"(,"perimeter_mm":)" + text(p.perimeter) +
                R"(,"width_mm":)" + text(p.width) + R"(,"height_mm":)" + text(p.height) +
                R"(,"planarity_mm":0,"distance_mm":null,"weight_kg":)" + text(*p.weight) +
                R"(,"class":1,"mirrored":)" + (p.panel == 2 ? "true" : "false") +
                R"(,"sheet":1,"verdict":")" +
                (p.panel == 1 ? R"(fail","failures":[)" + failures : std::string(R"(pass","failures":[)")) +
                R"(],"sides":[)" + sides + R"(],"corners_mm":[)" + corners + "]}";
      members += comma + R"({"panel":")" + name + R"(","mirrored":)" + (p.panel == 2 ? "true" : "false") +
                 R"(,"shift":)" + std::to_string(p.panel) + R"(,"deviation_mm":0})";
      const Eigen::Vector2d at = place(p.panel).transpose();
      parts += comma + R"({"panel":")" + name + R"(","rotation_rad":0,"shift_mm":[)" + text(at.x()) + "," +
               text(at.y()) + "]}";
      names += comma + R"({"number":)" + std::to_string(p.panel + 7) + R"(,"name":")" + name + "\"}";
    }
    const std::string filled = text(3.0 * kSide * kSide / (150.0 * 60.0));
    return R"({"unit":"mm","passed":2,"failed":1,"classes":[[)" + members +
           R"(]],"nesting":{"width_mm":150,"height_mm":60,"filled":)" + filled +
           R"(,"unplaced":[],"sheets":[{"filled":)" + filled + R"(,"parts":[)" + parts +
           R"(]}]},"panels":[)" + panels + R"(],"names":[)" + names + "]}";
  }

  WorkshopModel model;
  std::vector<PanelPassport> passports;
  ToleranceVerdicts verdicts;
  std::vector<FlatPattern> patterns;
  ThickPanels solids;
  std::vector<CongruenceClass> classes;
  ExportContent content;
  std::filesystem::path folder;

 private:
  template <class T>
  static void append(std::string& out, T value) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    out.append(bytes, sizeof(T));
  }
  static std::string layer_of(DrawingLayer layer) {
    return layer == DrawingLayer::Cut ? "CUT" : layer == DrawingLayer::Engrave ? "ENGRAVE" : "SHEET";
  }
  std::string neighbour(const PanelPassport& p, size_t k) const {
    const int n = p.sides[k].neighbour;
    return n < 0 ? "" : model.names[static_cast<size_t>(n)];
  }
  std::string vertices(const std::string& before, const Points& points) const {
    std::string out;
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      out += before + text(points(i, 0) + model.origin.x()) + " " + text(points(i, 1) + model.origin.y()) +
             " " + text(points(i, 2) + model.origin.z()) + "\n";
    return out;
  }

  static std::string pdf_of(const std::vector<std::string>& pages) {
    std::vector<std::string> objects{
        "<</Type/Catalog/Pages 2 0 R>>", "",
        "<</Type/Font/Subtype/Type1/BaseFont/Helvetica/FirstChar 32/Widths[500]>>"};
    std::string kids;
    for (const std::string& page : pages) {
      kids += std::to_string(objects.size() + 1) + " 0 R ";
      objects.push_back("<</Type/Page/Parent 2 0 R/MediaBox[0 0 " + text(420.0 * 72.0 / 25.4) + " " +
                        text(297.0 * 72.0 / 25.4) + "]/Resources<</Font<</F1 3 0 R>>>>/Contents " +
                        std::to_string(objects.size() + 2) + " 0 R>>");
      objects.push_back("<</Length " + std::to_string(page.size()) + ">>\nstream\n" + page + "\nendstream");
    }
    objects[1] = "<</Type/Pages/Count " + std::to_string(pages.size()) + "/Kids[" + kids + "]>>";
    std::string out = "%PDF-1.5\n",
                table = "xref\n0 " + std::to_string(objects.size() + 1) + "\n0000000000 65535 f \n";
    for (size_t i = 0; i < objects.size(); ++i) {
      std::string at = std::to_string(out.size());
      table += std::string(10 - at.size(), '0') + at + " 00000 n \n";
      out += std::to_string(i + 1) + " 0 obj\n" + objects[i] + "\nendobj\n";
    }
    return out + table + "trailer\n<</Size " + std::to_string(objects.size() + 1) +
           "/Root 1 0 R>>\nstartxref\n" + std::to_string(out.size()) + "\n%%EOF\n";
  }

  static std::uint32_t crc(const std::string& bytes) {
    std::uint32_t c = ~0u;
    for (const char b : bytes) {
      c ^= static_cast<unsigned char>(b);
      for (int k = 0; k < 8; ++k) c = (c >> 1) ^ (c & 1 ? 0xEDB88320u : 0u);
    }
    return ~c;
  }
  static std::string package(const std::vector<std::pair<std::string, std::string>>& entries) {
    std::string out, directory;
    for (const auto& [name, bytes] : entries) {
      std::string head;  // from "version needed" to the lengths of name and extra field
      append(head, std::uint16_t{20});
      for (int k = 0; k < 4; ++k) append(head, std::uint16_t{0});
      append(head, crc(bytes));
      append(head, static_cast<std::uint32_t>(bytes.size()));
      append(head, static_cast<std::uint32_t>(bytes.size()));
      append(head, static_cast<std::uint16_t>(name.size()));
      append(head, std::uint16_t{0});
      directory += "PK\1\2";
      append(directory, std::uint16_t{20});
      directory += head + std::string(10, '\0');
      append(directory, static_cast<std::uint32_t>(out.size()));
      directory += name;
      out += "PK\3\4" + head + name + bytes;
    }
    std::string end = "PK\5\6" + std::string(4, '\0');
    append(end, static_cast<std::uint16_t>(entries.size()));
    append(end, static_cast<std::uint16_t>(entries.size()));
    append(end, static_cast<std::uint32_t>(directory.size()));
    append(end, static_cast<std::uint32_t>(out.size()));
    append(end, std::uint16_t{0});
    return out + directory + end;
  }

  void make_model() {
    model.title = "strip";
    model.origin = {1000.0, 2000.0, 500.0};
    model.points.resize(8, 3);
    for (int i = 0; i < 4; ++i) {
      model.points.row(i) << kSide * i, 0.0, 0.0;
      model.points.row(4 + i) << kSide * i, kSide, 0.0;
    }
    model.normals = Points::Zero(3, 3);
    model.normals.col(2).setOnes();
    model.plane_offsets = Vector::Zero(3);
    for (int p = 0; p < 3; ++p) {
      model.panels.push_back(std::vector{p, p + 1, p + 5, p + 4});
      model.numbers.push_back(p + 7);
      model.names.push_back("A-" + std::to_string(p + 1));
    }
    for (int p = 0; p < 3; ++p) {
      std::vector<int> edges;
      for (int k = 0; k < 4; ++k) {
        if (k == 3 && p > 0) {
          edges.push_back(static_cast<int>(4 * (p - 1) + 1 - (p > 1 ? 1 : 0)));
          continue;
        }
        const bool shared = k == 1 && p < 2;
        edges.push_back(static_cast<int>(model.edges.size()));
        model.edges.push_back({model.panels[p][static_cast<size_t>(k)],
                               model.panels[p][static_cast<size_t>((k + 1) % 4)], p, shared ? p + 1 : -1, k,
                               shared ? 3 : -1});
      }
      model.edges_of_panel.push_back(edges);
    }
  }

  void make_parts() {
    // The second fails.
    verdicts.passed = 2;
    verdicts.failed = 1;
    verdicts.failures = {{1, ToleranceKind::EdgeMin, 1, kSide, 50.0},
                         {1, ToleranceKind::EdgeMin, 3, kSide, 50.0},
                         {1, ToleranceKind::AreaMax, -1, 0.5, 0.25}};
    for (int p = 0; p < 3; ++p) {
      PanelPassport passport;
      passport.panel = p;
      passport.area = kSide * kSide;
      passport.perimeter = 4.0 * kSide;
      passport.width = passport.height = kSide;
      passport.weight = 0.3;
      for (int k = 0; k < 4; ++k) {
        const int n = k == 1 && p < 2 ? p + 1 : k == 3 && p > 0 ? p - 1 : -1;
        passport.sides.push_back({n, kSide, 90.0, 180.0, 0.0});
      }
      passports.push_back(passport);
      verdicts.pass.push_back(p != 1);
      FlatPattern pattern;
      pattern.panel = p;
      pattern.nominal.resize(4, 2);
      pattern.nominal << 0.0, 0.0, kSide, 0.0, kSide, kSide, 0.0, kSide;
      pattern.outer = pattern.inner = pattern.cut = pattern.nominal;
      pattern.side_of_segment = {0, 1, 2, 3};
      patterns.push_back(pattern);
      ThickPanel solid;
      solid.panel = p;
      solid.outer = 4;
      solid.points.resize(8, 3);
      for (int k = 0; k < 4; ++k) {
        solid.points.row(k) = model.points.row(model.panels[p][static_cast<size_t>(k)]);
        solid.points.row(4 + k) = solid.points.row(k) - Eigen::RowVector3d(0.0, 0.0, kThick);
      }
      solid.faces = {{0, 1, 2, 3}, {7, 6, 5, 4}, {1, 0, 4, 5}, {2, 1, 5, 6}, {3, 2, 6, 7}, {0, 3, 7, 4}};
      solid.side_of_face = {-1, -1, 0, 1, 2, 3};
      solids.panels.push_back(solid);
    }
  }

  static Eigen::RowVector2d place(int panel) { return {10.0 + panel * (kSide + 7.0 / 3.0), 10.0 + panel}; }
  Drawing drawing() const {
    Drawing d{"strip", 150.0, 60.0, {}, {}};
    Contour border(4, 2);
    border << 0.0, 0.0, 150.0, 0.0, 150.0, 60.0, 0.0, 60.0;
    d.lines.push_back({DrawingLayer::Sheet, border, true, -1});
    for (int p = 0; p < 3; ++p) {
      Contour cut = patterns[static_cast<size_t>(p)].cut.rowwise() + place(p);
      d.lines.push_back({DrawingLayer::Cut, cut, true, p});
      Contour mark(2, 2);
      mark << cut.row(0) + Eigen::RowVector2d(5.0, 5.0), cut.row(0) + Eigen::RowVector2d(5.0, 9.0);
      d.lines.push_back({DrawingLayer::Engrave, mark, false, p});
      const Eigen::Vector2d middle = cut.colwise().mean().transpose();
      d.texts.push_back({DrawingLayer::Text, model.names[static_cast<size_t>(p)], middle, 4.0, 0.0, p, true});
      for (const int n : {p - 1, p + 1})
        if (n >= 0 && n < 3)
          d.texts.push_back({DrawingLayer::Text, model.names[static_cast<size_t>(n)],
                             middle + Eigen::Vector2d(14.0 * (n - p), 0.0), 3.0, 0.0, p, false});
    }
    return d;
  }
};

}  // namespace planewright::sample
