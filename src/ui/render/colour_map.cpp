#include "ui/render/colour_map.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <iterator>
#include <limits>

namespace planewright::render {
namespace {

// viridis at every tenth (its authors gave the map into the public domain, CC0).
constexpr std::uint32_t kAnchors[] = {0x440154, 0x482576, 0x414487, 0x35608d, 0x2a788e, 0x21908c,
                                      0x22a884, 0x43bf71, 0x7ad151, 0xbbdf27, 0xfde725};
constexpr int kSteps = 10;

// Severities at these places, colours between them by straight lines.
constexpr float kSeverities[] = {0.0f, 0.3f, 0.7f, 1.0f};
// Of verdicts: what keeps the limit, from far below to at it; what fails, from hardly to twice the limit and
// more.
constexpr std::uint32_t kKeeps[] = {0xe9f1ec, 0x5a9f97};
constexpr std::uint32_t kFails[] = {0xf2b14c, 0xb92a1e};

constexpr std::uint32_t kSeverityColours[] = {0xf5e6c4, 0xf2c15c, 0xdf7a26, 0xbf2d20};

glm::vec3 colour(std::uint32_t rgb) {
  return glm::vec3(static_cast<float>(rgb >> 16 & 255u), static_cast<float>(rgb >> 8 & 255u),
                   static_cast<float>(rgb & 255u)) /
         255.0f;
}

glm::vec3 anchor(int i) {
  return colour(kAnchors[std::clamp(i, 0, kSteps)]);
}

template <class Map>
ColourTable table_of(Map map) {
  ColourTable table{};
  for (int i = 0; i < 256; ++i) {
    const glm::vec3 c = map(static_cast<float>(i) / 255.0f);
    for (int k = 0; k < 3; ++k) table[4 * i + k] = static_cast<std::uint8_t>(std::lround(255.0f * c[k]));
    table[4 * i + 3] = 255;
  }
  return table;
}

}  // namespace

glm::vec3 viridis(float t) {
  const float x = kSteps * (t > 0.0f ? std::min(t, 1.0f) : 0.0f);
  const int i = std::min(static_cast<int>(x), kSteps - 1);
  const float s = x - static_cast<float>(i);
  // A Catmull-Rom curve through the anchors.
  const glm::vec3 p0 = anchor(i - 1), p1 = anchor(i), p2 = anchor(i + 1), p3 = anchor(i + 2);
  const glm::vec3 c =
      p1 +
      0.5f * s * (p2 - p0 + s * (2.0f * p0 - 5.0f * p1 + 4.0f * p2 - p3 + s * (3.0f * (p1 - p2) + p3 - p0)));
  return {std::clamp(c.x, 0.0f, 1.0f), std::clamp(c.y, 0.0f, 1.0f), std::clamp(c.z, 0.0f, 1.0f)};
}

glm::vec3 severity_colour(float t) {
  std::size_t i = 1;
  while (i + 1 < std::size(kSeverities) && t > kSeverities[i]) ++i;
  const float s = (t - kSeverities[i - 1]) / (kSeverities[i] - kSeverities[i - 1]);
  return glm::mix(colour(kSeverityColours[i - 1]), colour(kSeverityColours[i]),
                  s > 0.0f ? std::min(s, 1.0f) : 0.0f);
}

glm::vec3 verdict_colour(float t) {
  // Each side holds its end as far as the middle of the gap, so that no texture mixes the two.
  constexpr float kMiddle = 0.5f * (kBreakBelow + kBreakAbove);
  if (!(t > kMiddle))
    return glm::mix(colour(kKeeps[0]), colour(kKeeps[1]), t > 0.0f ? std::min(t / kBreakBelow, 1.0f) : 0.0f);
  return glm::mix(colour(kFails[0]), colour(kFails[1]),
                  std::clamp((t - kBreakAbove) / (1.0f - kBreakAbove), 0.0f, 1.0f));
}

ColourTable viridis_table() {
  return table_of(viridis);
}
ColourTable severity_table() {
  return table_of(severity_colour);
}
ColourTable verdict_table() {
  return table_of(verdict_colour);
}

MapScale map_scale(const ColourScale& scale) {
  const auto per_unit = [](double share, double length) {
    return length > 0.0 ? static_cast<float>(std::min(share / length, 1e37)) : 0.0f;
  };
  MapScale map;
  map.low = static_cast<float>(scale.low);
  if (!scale.tolerance) {
    map.tolerance = std::numeric_limits<float>::max();
    map.per_unit_below = per_unit(1.0, scale.high - scale.low);
    return map;
  }
  map.tolerance = static_cast<float>(*scale.tolerance);
  map.below_end = kBreakBelow;
  map.above_start = kBreakAbove;
  map.per_unit_below = per_unit(kBreakBelow, std::min(*scale.tolerance, scale.high) - scale.low);
  map.per_unit_above = per_unit(1.0 - kBreakAbove, scale.high - std::max(*scale.tolerance, scale.low));
  return map;
}

float map_position(const MapScale& scale, float value) {
  if (value > scale.tolerance) {
    const float above = (value - std::max(scale.tolerance, scale.low)) * scale.per_unit_above;
    return std::clamp(scale.above_start + above, scale.above_start, 1.0f);
  }
  return std::clamp((value - scale.low) * scale.per_unit_below, 0.0f, scale.below_end);
}

glm::vec3 colour_of(const ColourScale& scale, double value) {
  const float t = map_position(map_scale(scale), static_cast<float>(value));
  switch (scale.map) {
    case ColourScale::Map::Severity:
      return severity_colour(t);
    case ColourScale::Map::Verdict:
      return verdict_colour(t);
    case ColourScale::Map::Viridis:
      break;
  }
  return viridis(t);
}

}  // namespace planewright::render
