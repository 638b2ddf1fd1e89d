#include "ui/render/sheet.h"

#include <algorithm>

#include "ui/render/palette.h"
#include "ui/render/text.h"

namespace planewright::render {
namespace {

constexpr float kLetters = 15.0f, kStrip = 32.0f, kIndent = 10.0f;  // in a sheet of 1000 pixels

float scale_of(const SheetLayout& layout) {
  return std::max(1.0f, static_cast<float>(layout.width) / 1000.0f);
}

}  // namespace

int SheetLayout::gap() const {
  return std::max(2, width / 250);
}

int SheetLayout::caption_height() const {
  return captions ? static_cast<int>(kStrip * scale_of(*this)) : 0;
}

Image make_sheet(const std::vector<Cell>& cells, const SheetLayout& layout, const Theme& theme) {
  if (cells.empty()) return {};
  const int columns = layout.columns, gap = layout.gap();
  const int width = cells.front().image.width, picture = cells.front().image.height;
  const int height = picture + layout.caption_height();
  const int rows = (static_cast<int>(cells.size()) + columns - 1) / columns;
  const Palette& palette = palette_of(theme);
  Image sheet{columns * width + (columns - 1) * gap, rows * height + (rows - 1) * gap, {}};
  sheet.rgba.assign(static_cast<size_t>(sheet.width) * static_cast<size_t>(sheet.height) * 4, 255);
  sheet.fill_rectangle(0.0f, 0.0f, static_cast<float>(sheet.width), static_cast<float>(sheet.height),
                       theme.dark ? palette.ground_bottom : palette.outline, 1.0f);

  const TextPen pen;
  const float scale = scale_of(layout), letters = kLetters * scale;
  const auto row_bytes = static_cast<std::ptrdiff_t>(width) * 4;
  for (size_t i = 0; i < cells.size(); ++i) {
    const int left = static_cast<int>(i) % columns * (width + gap);
    const int top = static_cast<int>(i) / columns * (height + gap);
    const auto& rgba = cells[i].image.rgba;
    for (int y = 0; y < picture; ++y)
      std::copy_n(rgba.begin() + y * row_bytes, row_bytes,
                  sheet.rgba.begin() + (static_cast<std::ptrdiff_t>(top + y) * sheet.width + left) * 4);
    const float strip = static_cast<float>(layout.caption_height());
    pen.draw(sheet, cells[i].caption, static_cast<float>(left) + kIndent * scale,
             static_cast<float>(top + picture) + 0.5f * strip + 0.35f * letters, letters, palette.text);
  }
  return sheet;
}

}  // namespace planewright::render
