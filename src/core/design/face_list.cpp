#include "core/design/face_list.h"

#include <algorithm>
#include <optional>

#include "core/mesh/text_scanner.h"

namespace planewright {
namespace {

constexpr const char* kForm = "Write numbers and ranges, as in 3,17,40-44";

}  // namespace

Result<std::vector<int>> parse_face_list(std::string_view content, const std::string& name, int faces) {
  std::string text(content);
  std::replace(text.begin(), text.end(), ',', ' ');
  TextScanner scanner(text, name, {.hash_comments = true});
  std::vector<int> list;
  std::vector<char> listed(static_cast<size_t>(faces), 0);
  for (std::string_view token = scanner.token(); !token.empty(); token = scanner.token()) {
    const size_t dash = token.find('-', 1);  // a sign is none
    const auto first = to_integer(token.substr(0, dash));
    const auto last = dash == std::string_view::npos ? first : to_integer(token.substr(dash + 1));
    if (!first || !last) return scanner.error(in_quotes(token) + " is no face and no range of faces", kForm);
    if (*last < *first) return scanner.error("the range " + in_quotes(token) + " runs backwards", kForm);
    for (const long long face : {*first, *last})
      if (face < 0 || face >= faces)
        return scanner.error("the mesh has no face " + std::to_string(face),
                             "It has " + std::to_string(faces) + " faces, numbered from 0");
    for (int face = static_cast<int>(*first); face <= *last; ++face) {
      if (listed[static_cast<size_t>(face)]++)
        return scanner.error("face " + std::to_string(face) + " is listed twice", kForm);
      list.push_back(face);
    }
  }
  if (list.empty()) return scanner.error("no face is listed", kForm);
  return list;
}

}  // namespace planewright
