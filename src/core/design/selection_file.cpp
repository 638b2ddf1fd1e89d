#include "core/design/selection_file.h"

#include <algorithm>
#include <utility>

#include "core/mesh/text_scanner.h"

namespace planewright {
namespace {

constexpr const char* kForm =
    "Write 'name: vertices 1 2 4-9; faces 3; edges 12 7/8', with any of the three kinds";

// Which list of a selection is being filled.
struct Kind {
  std::vector<int> Selection::*list = nullptr;
  const char* name = "";
  int count = 0;
};

Result<Kind> read_kind(const TextScanner& scanner, std::string_view word, const PolygonMesh& mesh) {
  if (word == "vertices") return Kind{&Selection::vertices, "vertex", mesh.vertex_count()};
  if (word == "edges") return Kind{&Selection::edges, "edge", mesh.edge_count()};
  if (word == "faces") return Kind{&Selection::faces, "face", mesh.face_count()};
  return scanner.error(in_quotes(word) + " is none of vertices, edges, faces, and no number", kForm);
}

Result<int> read_number(const TextScanner& scanner, std::string_view token, std::string_view whole,
                        const char* name, int count) {
  const auto number = to_integer(token);
  if (!number) return scanner.error(in_quotes(whole) + " is neither a number nor a range", kForm);
  if (*number < 0 || *number >= count)
    return scanner.error("there is no " + std::string(name) + " " + std::to_string(*number),
                         count > 0 ? "Numbers go from 0 to " + std::to_string(count - 1) : std::string());
  return static_cast<int>(*number);
}

// "7", "4-9", "7/8" (edges)
Result<void> add_elements(const TextScanner& scanner, std::string_view token, const Kind& kind,
                          const PolygonMesh& mesh, std::vector<int>& list) {
  const size_t slash = token.find('/'), dash = token.find('-', 1);
  if (slash != std::string_view::npos && kind.list == &Selection::edges) {
    const auto a = read_number(scanner, token.substr(0, slash), token, "vertex", mesh.vertex_count());
    if (!a) return tl::unexpected(a.error());
    const auto b = read_number(scanner, token.substr(slash + 1), token, "vertex", mesh.vertex_count());
    if (!b) return tl::unexpected(b.error());
    const int edge = mesh.find_edge(*a, *b);
    if (edge < 0)
      return scanner.error("no edge joins the vertices of " + in_quotes(token),
                           "Name two vertices of one edge");
    list.push_back(edge);
    return {};
  }
  const auto first = read_number(scanner, token.substr(0, dash), token, kind.name, kind.count);
  if (!first) return tl::unexpected(first.error());
  auto last = first;
  if (dash != std::string_view::npos)
    last = read_number(scanner, token.substr(dash + 1), token, kind.name, kind.count);
  if (!last) return tl::unexpected(last.error());
  if (*last < *first) return scanner.error("the range " + in_quotes(token) + " runs backwards", kForm);
  for (int element = *first; element <= *last; ++element) list.push_back(element);
  return {};
}

Selection& named(std::vector<Selection>& selections, std::string_view name) {
  for (Selection& selection : selections)
    if (selection.name == name) return selection;
  return selections.emplace_back(Selection{std::string(name), {}, {}, {}});
}

}  // namespace

Result<std::vector<Selection>> parse_selection_file(std::string_view content, const std::string& name,
                                                    const PolygonMesh& mesh) {
  std::string text(content);
  // Inside comments it does no harm.
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == ',' || c == ';'; }, ' ');
  std::vector<Selection> selections;
  TextScanner scanner(text, name, {.hash_comments = true});
  while (!scanner.at_end()) {
    const std::string_view word = scanner.token_in_line();
    if (word.size() < 2 || word.back() != ':' || word.find('@') != std::string_view::npos)
      return scanner.error("a line begins with the selection's name and a colon, not with " + in_quotes(word),
                           kForm);
    Selection& selection = named(selections, word.substr(0, word.size() - 1));
    Kind kind;
    bool any = false;
    for (auto token = scanner.token_in_line(); !token.empty(); token = scanner.token_in_line()) {
      if (token[0] < '0' || token[0] > '9') {
        const auto read = read_kind(scanner, token, mesh);
        if (!read) return tl::unexpected(read.error());
        kind = *read;
        continue;
      }
      if (!kind.list) return scanner.error("a number before one of vertices, edges, faces", kForm);
      if (auto added = add_elements(scanner, token, kind, mesh, selection.*kind.list); !added)
        return tl::unexpected(added.error());
      any = true;
    }
    if (!any) return scanner.error("the selection '" + selection.name + "' names nothing", kForm);
    scanner.skip_line();
  }
  for (Selection& selection : selections)
    for (auto list : {&Selection::vertices, &Selection::edges, &Selection::faces}) {
      auto& elements = selection.*list;
      std::sort(elements.begin(), elements.end());
      elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
    }
  return selections;
}

}  // namespace planewright
