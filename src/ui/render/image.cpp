#include "ui/render/image.h"

#include <algorithm>
#include <cmath>

namespace planewright::render {

void Image::blend(int x, int y, const glm::vec3& colour, float alpha) {
  if (x < 0 || y < 0 || x >= width || y >= height) return;
  std::uint8_t* pixel = rgba.data() + 4 * (static_cast<size_t>(y) * width + x);
  for (int k = 0; k < 3; ++k) {
    const float mixed = (1.0f - alpha) * pixel[k] + alpha * 255.0f * colour[k];
    pixel[k] = static_cast<std::uint8_t>(std::lround(std::clamp(mixed, 0.0f, 255.0f)));
  }
}

void Image::fill_rectangle(float x, float y, float width_of, float height_of, const glm::vec3& colour,
                           float alpha, float radius) {
  const float cx = x + 0.5f * width_of, cy = y + 0.5f * height_of;
  const int last_x = static_cast<int>(std::ceil(x + width_of)),
            last_y = static_cast<int>(std::ceil(y + height_of));
  for (int py = static_cast<int>(std::floor(y)); py < last_y; ++py) {
    for (int px = static_cast<int>(std::floor(x)); px < last_x; ++px) {
      const float dx = std::abs(static_cast<float>(px) + 0.5f - cx) - 0.5f * width_of + radius;
      const float dy = std::abs(static_cast<float>(py) + 0.5f - cy) - 0.5f * height_of + radius;
      const float outside =
          std::hypot(std::max(dx, 0.0f), std::max(dy, 0.0f)) + std::min(std::max(dx, dy), 0.0f);
      const float cover = std::clamp(0.5f - (outside - radius), 0.0f, 1.0f);
      if (cover > 0.0f) blend(px, py, colour, alpha * cover);
    }
  }
}

}  // namespace planewright::render
