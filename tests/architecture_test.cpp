// The directions in which folders may include each other, and who alone may include which library: read from
// the #include lines of the source itself (docs/architecture: "Directions").
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace planewright {
namespace {

namespace fs = std::filesystem;

struct Include {
  std::string file;  // below src/, "core/design/design.cpp"
  int line;
  std::string header;  // as written, without quotes or brackets
};

const std::vector<Include>& includes() {
  static const std::vector<Include> all = [] {
    std::vector<Include> found;
    const fs::path root = fs::path(PLANEWRIGHT_SOURCE_DIR) / "src";
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
      const std::string ending = entry.path().extension().string();
      if (ending != ".h" && ending != ".cpp" && ending != ".in") continue;
      std::ifstream in(entry.path());
      std::string text;
      for (int line = 1; std::getline(in, text); ++line) {
        const size_t hash = text.find_first_not_of(" \t");
        if (hash == std::string::npos || text[hash] != '#') continue;
        const size_t word = text.find_first_not_of(" \t", hash + 1);
        if (word == std::string::npos || text.compare(word, 7, "include") != 0) continue;
        const size_t open = text.find_first_of("\"<", word), close = text.find_first_of("\">", open + 1);
        if (open == std::string::npos || close == std::string::npos) continue;
        found.push_back({fs::relative(entry.path(), root).generic_string(), line,
                         text.substr(open + 1, close - open - 1)});
      }
    }
    return found;
  }();
  return all;
}

// "core/solve" of "core/solve/solver.h"; "ui/render" and "ui" are different folders, while folders inside one
// of the core's are parts of it.
std::string folder(const std::string& path) {
  const size_t slash = path.rfind('/');
  if (slash == std::string::npos) return "";
  const std::string whole = path.substr(0, slash), core = "core/";
  return whole.starts_with(core) ? whole.substr(0, whole.find('/', core.size())) : whole;
}

std::string place(const Include& include) {
  return "src/" + include.file + ":" + std::to_string(include.line) + " includes " + include.header;
}

bool starts_with_any(const std::string& text, const std::vector<std::string>& beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](const auto& b) { return text.starts_with(b); });
}

// What each folder may include of ours, itself apart.
const std::map<std::string, std::set<std::string>>& allowed() {
  static const std::map<std::string, std::set<std::string>> rules = [] {
    std::map<std::string, std::set<std::string>> r;
    r["core/base"] = {};
    r["core/mesh"] = {"core/base"};
    // Regions are made of a mesh alone; only the builder of complexes knows both.
    r["core/cluster"] = {"core/base", "core/mesh"};
    r["core/complex"] = {"core/base", "core/mesh", "core/cluster"};
    r["core/problem"] = {"core/base", "core/mesh", "core/complex"};
    r["core/solve"] = {"core/base", "core/mesh", "core/complex", "core/problem"};
    // Offsets and beams are made of finished states.
    r["core/layers"] = {"core/base", "core/mesh", "core/complex"};
    // Diagnosis measures complexes and states, whatever made them, and the beams between two.
    r["core/diagnose"] = {"core/base",    "core/mesh",  "core/complex",
                          "core/problem", "core/solve", "core/layers"};
    r["core/design"] = {"core/base",    "core/mesh",  "core/cluster",  "core/complex",
                        "core/problem", "core/solve", "core/diagnose", "core/layers"};
    // The workshop knows finished panels, whatever made them; not settings, solvers or documents.
    r["core/workshop"] = {"core/base", "core/mesh", "core/complex", "core/layers", "core/diagnose"};
    // A document has a unit and tolerances.
    r["core/edit"] = r["core/design"];
    r["core/edit"].insert({"core/design", "core/workshop"});
    r["core/advise"] = r["core/edit"];
    r["core/advise"].insert("core/edit");
    // Reports tell suggestions, too.
    r["core/export"] = r["core/advise"];
    r["core/export"].insert("core/advise");
    r["core/pattern"] = r["core/workshop"];
    r["core/pattern"].insert("core/workshop");
    r["core/writers"] = r["core/pattern"];
    r["core/writers"].insert("core/pattern");
    // Of the writers the certificate knows options alone (scale of a page), none of their code.
    r["core/certify"] = r["core/writers"];
    r["core/certify"].insert("core/writers");
    r["core/fabricate"] = r["core/certify"];
    r["core/fabricate"].insert("core/certify");
    const std::set<std::string> core = [&] {
      std::set<std::string> all = r["core/export"];
      all.insert(r["core/fabricate"].begin(), r["core/fabricate"].end());
      all.insert({"core/export", "core/fabricate"});
      return all;
    }();
    // The renderer draws polygons; it knows nothing of solving.
    r["ui/render"] = {"core/base", "core/mesh"};
    r["cli"] = core;
    r["cli"].insert("ui/render");
    r["ui"] = core;
    r["ui"].insert("ui/render");
    return r;
  }();
  return rules;
}

TEST(Architecture, TheSourceIsScanned) {
  EXPECT_GT(includes().size(), 300u);
  std::set<std::string> folders;
  for (const Include& include : includes()) folders.insert(folder(include.file));
  for (const auto& [name, may] : allowed()) EXPECT_TRUE(folders.contains(name)) << name;
}

TEST(Architecture, FoldersIncludeForwardsOnly) {
  for (const Include& include : includes()) {
    const std::string from = folder(include.file);
    ASSERT_TRUE(allowed().contains(from)) << "src/" << from << " has no rule; add one with its folder";
    if (!starts_with_any(include.header, {"core/", "ui/", "cli/"})) continue;
    const std::string to = folder(include.header);
    EXPECT_TRUE(to == from || allowed().at(from).contains(to)) << place(include);
  }
}

TEST(Architecture, OurHeadersAreNamedFromSrc) {
  for (const Include& include : includes()) {
    const fs::path beside =
        (fs::path(PLANEWRIGHT_SOURCE_DIR) / "src" / include.file).parent_path() / include.header;
    EXPECT_FALSE(include.header.find('/') == std::string::npos && fs::exists(beside)) << place(include);
    EXPECT_FALSE(include.header.starts_with("..")) << place(include);
  }
}

TEST(Architecture, CoreKnowsNoWindowAndNoGraphics) {
  const std::vector<std::string> graphics{"GL/",  "GLES", "EGL/",     "epoxy/", "GLFW/", "imgui",
                                          "glm/", "ft2",  "freetype", "stb",    "ui/",   "cli/"};
  for (const Include& include : includes()) {
    if (!include.file.starts_with("core/")) continue;
    EXPECT_FALSE(starts_with_any(include.header, graphics)) << place(include);
  }
}

TEST(Architecture, OnlyTheIpoptSolverIncludesIpopt) {
  int seen = 0;
  for (const Include& include : includes()) {
    if (!include.header.starts_with("Ip") && !include.header.starts_with("coin")) continue;
    EXPECT_EQ(include.file, "core/solve/ipopt_solver.cpp") << place(include);
    ++seen;
  }
  EXPECT_GT(seen, 0);
}

TEST(Architecture, OnlyTheFactorisationIncludesMumps) {
  for (const Include& include : includes()) {
    if (include.header.find("mumps_c.h") == std::string::npos) continue;
    EXPECT_EQ(include.file, "core/solve/mumps_cholesky.cpp") << place(include);
  }
}

// And of CGAL only the kernel, which is LGPL; most of its packages are GPL, which Ipopt's licence does not go
// with.
TEST(Architecture, OnlyExactPredicatesIncludeCgal) {
  const std::set<std::string> lgpl{"CGAL/Exact_predicates_inexact_constructions_kernel.h",
                                   "CGAL/Kernel/global_functions.h"};
  const std::set<std::string> may{"core/diagnose/crossings.cpp", "core/certify/exact_signs.cpp"};
  std::set<std::string> seen;
  for (const Include& include : includes()) {
    if (!include.header.starts_with("CGAL/")) continue;
    EXPECT_TRUE(may.contains(include.file)) << place(include);
    EXPECT_TRUE(lgpl.contains(include.header)) << place(include);
    seen.insert(include.file);
  }
  EXPECT_EQ(seen, may);
}

// The libraries that the certificate reads with are known to its readers alone: what wrote a file cannot be
// what reads it back.
TEST(Architecture, OnlyReadersOfTheCertificateIncludeTheirLibraries) {
  const std::map<std::string, std::set<std::string>> readers{
      {"dime/", {"core/certify/dxf_reader.cpp"}},
      {"libxml/", {"core/certify/svg_reader.cpp", "core/certify/package_reader.cpp"}},
      {"qpdf/", {"core/certify/pdf_reader.cpp", "core/certify/pdf_font.h", "core/certify/pdf_font.cpp"}},
      {"tiny_obj_loader", {"core/certify/obj_reader.cpp"}},
      {"assimp/", {"core/certify/scene_reader.cpp"}},
      {"minizip/", {"core/certify/package_reader.cpp"}}};
  std::set<std::string> seen;
  for (const Include& include : includes())
    for (const auto& [library, files] : readers) {
      if (!include.header.starts_with(library)) continue;
      EXPECT_TRUE(files.contains(include.file)) << place(include);
      seen.insert(library);
    }
  EXPECT_EQ(seen.size(), readers.size());
}

// And they share nothing with the writers but the options that a drawing is written with.
TEST(Architecture, TheCertificateKnowsNoWriter) {
  for (const Include& include : includes()) {
    if (folder(include.file) != "core/certify" || folder(include.header) != "core/writers") continue;
    EXPECT_EQ(include.header, "core/writers/drawing_writers.h") << place(include);
    EXPECT_EQ(include.file, "core/certify/certificate.h") << place(include);
  }
}

// Who alone may include a library of the workshop's writers: the folder, or the one file, and that somebody
// does.
TEST(Architecture, OnlyTheWritersIncludeTheirLibraries) {
  struct Rule {
    std::vector<std::string> headers;
    std::vector<std::string> files;
  };
  const std::vector<Rule> rules{
      {{"cairo"}, {"core/writers/pdf_pen.h", "core/writers/pdf_pen.cpp", "core/writers/pdf_writer.cpp"}},
      {{"pugixml"}, {"core/writers/svg_writer.cpp"}},
      {{"Model/COM/", "lib3mf"}, {"core/writers/threemf_writer.cpp"}},
      {{"tiny_gltf"}, {"core/writers/gltf_writer.cpp"}}};
  for (const Rule& rule : rules) {
    int seen = 0;
    for (const Include& include : includes()) {
      if (!starts_with_any(include.header, rule.headers)) continue;
      EXPECT_NE(std::find(rule.files.begin(), rule.files.end(), include.file), rule.files.end())
          << place(include);
      ++seen;
    }
    EXPECT_GT(seen, 0) << rule.headers[0];
  }
}

TEST(Architecture, OnlyTheMeshIncludesOpenMesh) {
  int seen = 0;
  for (const Include& include : includes()) {
    if (!include.header.starts_with("OpenMesh")) continue;
    EXPECT_EQ(folder(include.file), "core/mesh") << place(include);
    EXPECT_TRUE(include.file.ends_with(".cpp")) << place(include);
    ++seen;
  }
  EXPECT_GT(seen, 0);
}

TEST(Architecture, OnlyTheWindowIncludesGlfwAndImGui) {
  for (const Include& include : includes()) {
    if (!starts_with_any(include.header, {"GLFW/", "imgui", "misc/"})) continue;
    EXPECT_EQ(folder(include.file), "ui") << place(include);
  }
}

TEST(Architecture, HeadersBeginWithPragmaOnce) {
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(PLANEWRIGHT_SOURCE_DIR) / "src")) {
    if (entry.path().extension() != ".h") continue;
    std::ifstream in(entry.path());
    std::string line;
    bool once = false;
    while (!once && std::getline(in, line) &&
           (line.empty() || line.starts_with("//") || line == "#pragma once"))
      once = line == "#pragma once";
    EXPECT_TRUE(once) << entry.path();
  }
}

}  // namespace
}  // namespace planewright
