#include "ui/render/font_file.h"

#include <fstream>
#include <system_error>

namespace planewright::render {

const std::vector<std::filesystem::path>& font_candidates(FontWeight weight) {
  static const std::vector<std::filesystem::path> regular{
      "/usr/share/fonts/opentype/inter/Inter-Regular.otf",
      "/usr/share/fonts/truetype/inter/Inter-Regular.ttf",
      "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Regular.ttf",
      "/usr/share/fonts/truetype/roboto/hinted/Roboto-Regular.ttf",
      "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
      "/usr/share/fonts/TTF/DejaVuSans.ttf",
  };
  static const std::vector<std::filesystem::path> medium{
      "/usr/share/fonts/opentype/inter/Inter-Medium.otf",
      "/usr/share/fonts/truetype/inter/Inter-Medium.ttf",
      "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Medium.ttf",
      "/usr/share/fonts/truetype/roboto/hinted/Roboto-Medium.ttf",
      "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
      "/usr/share/fonts/TTF/DejaVuSans.ttf",
  };
  return weight == FontWeight::Medium ? medium : regular;
}

std::optional<std::filesystem::path> find_font(FontWeight weight) {
  return first_readable(font_candidates(weight));
}

std::optional<std::filesystem::path> first_readable(const std::vector<std::filesystem::path>& candidates) {
  for (const auto& path : candidates) {
    std::error_code error;
    if (std::filesystem::is_regular_file(path, error) && std::ifstream(path, std::ios::binary).good())
      return path;
  }
  return std::nullopt;
}

}  // namespace planewright::render
