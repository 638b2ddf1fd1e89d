#include "core/design/region_file.h"

#include <algorithm>
#include <optional>

#include "core/mesh/text_scanner.h"

namespace planewright {
namespace {

constexpr std::string_view kHeading = "face,region";
constexpr const char* kForm = "Write 'face,region' and a line such as '17,3' for each face";

}  // namespace

std::string region_csv(std::span<const int> region_of_face) {
  std::string text(kHeading);
  text += '\n';
  for (size_t f = 0; f < region_of_face.size(); ++f)
    text.append(std::to_string(f)).append(",").append(std::to_string(region_of_face[f])) += '\n';
  return text;
}

Result<std::vector<int>> parse_region_csv(std::string_view content, const std::string& name, int faces) {
  TextScanner scanner(content, name);
  if (scanner.token() != kHeading) return scanner.error("the first line is not 'face,region'", kForm);
  std::vector<int> region_of_face(static_cast<size_t>(faces), -1);
  for (std::string_view line = scanner.token(); !line.empty(); line = scanner.token()) {
    const size_t comma = line.find(',');
    const auto face = to_integer(line.substr(0, comma));
    const auto region =
        comma == std::string_view::npos ? std::optional<long long>() : to_integer(line.substr(comma + 1));
    if (!face || !region) return scanner.error(in_quotes(line) + " is not a face and its region", kForm);
    if (*face < 0 || *face >= faces)
      return scanner.error("the mesh has no face " + std::to_string(*face),
                           "It has " + std::to_string(faces) + " faces");
    if (*region < 0 || *region >= faces)
      return scanner.error("there is no region " + std::to_string(*region),
                           "Number the regions from 0; there are not more of them than faces");
    int& of_face = region_of_face[static_cast<size_t>(*face)];
    if (of_face >= 0) return scanner.error("face " + std::to_string(*face) + " is listed twice", kForm);
    of_face = static_cast<int>(*region);
  }
  const auto missing = std::find(region_of_face.begin(), region_of_face.end(), -1);
  if (missing != region_of_face.end())
    return scanner.error("face " + std::to_string(missing - region_of_face.begin()) + " has no region",
                         kForm);
  return region_of_face;
}

}  // namespace planewright
