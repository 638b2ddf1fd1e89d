#include "ui/render/palette.h"

#include <cstdint>

namespace planewright::render {
namespace {

glm::vec3 rgb(std::uint32_t hex) {
  return glm::vec3(static_cast<float>(hex >> 16 & 255u), static_cast<float>(hex >> 8 & 255u),
                   static_cast<float>(hex & 255u)) /
         255.0f;
}

}  // namespace

const Palette& palette_of(const Theme& theme) {
  static const Palette light{
      .ground_top = rgb(0xf2efea),
      .ground_bottom = rgb(0xe3dfd8),
      .shadow = rgb(0x5a5146),
      .shadow_strength = 0.34f,
      .card = rgb(0xfbf8f2),
      .back_tint = {0.83f, 0.86f, 0.91f},
      .edge = rgb(0x4b443b),
      .other_card = rgb(0xdfd8ca),
      .back_card = rgb(0xe9e3d8),
      .beam = rgb(0x6f665a),
      .beam_edge = rgb(0x3d372f),
      .second_card = rgb(0xa9bfd6),
      .second_edge = rgb(0x6f88a3),
      .crossing_card = rgb(0xe79a8c),
      .ghost = rgb(0x3f78b8),
      .regions = {rgb(0xc9d6b8), rgb(0xe8c9b0), rgb(0xb9cde0), rgb(0xead9a6), rgb(0xd3c3de), rgb(0xb4d6cf),
                  rgb(0xe6bdbd), rgb(0xd2cabb)},
      .warning = rgb(0xe8960f),
      .error = rgb(0xcb3426),
      .selected = rgb(0x0f8f89),
      .outline = rgb(0xfdfbf7),
      .text = rgb(0x37322b),
      .faint_text = rgb(0x736c62),
  };
  static const Palette dark{
      .ground_top = rgb(0x302f2c),
      .ground_bottom = rgb(0x252422),
      .shadow = rgb(0x0c0b0a),
      .shadow_strength = 0.55f,
      .card = rgb(0xd9d4c9),
      .back_tint = {0.78f, 0.83f, 0.90f},
      .edge = rgb(0x26231f),
      .other_card = rgb(0xaaa498),
      .back_card = rgb(0xbdb7ab),
      .beam = rgb(0x5b544a),
      .beam_edge = rgb(0x1d1a17),
      .second_card = rgb(0x7089a3),
      .second_edge = rgb(0x4a6079),
      .crossing_card = rgb(0xc27264),
      .ghost = rgb(0x6aa2e2),
      .regions = {rgb(0x8d9f78), rgb(0xb38b6d), rgb(0x7893ad), rgb(0xb09d62), rgb(0x9483a6), rgb(0x6f9d94),
                  rgb(0xac7f7f), rgb(0x958c7e)},
      .warning = rgb(0xf2a93b),
      .error = rgb(0xe5574a),
      .selected = rgb(0x2fbdb4),
      .outline = rgb(0xf4f0e8),
      .text = rgb(0xe8e4dc),
      .faint_text = rgb(0xa39d93),
  };
  return theme.dark ? dark : light;
}

}  // namespace planewright::render
