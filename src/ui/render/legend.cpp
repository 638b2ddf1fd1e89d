#include "ui/render/legend.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "ui/render/colour_map.h"
#include "ui/render/palette.h"
#include "ui/render/text.h"

namespace planewright::render {
namespace {

constexpr float kMargin = 28.0f, kPadding = 14.0f, kBarWidth = 260.0f, kBarHeight = 12.0f;
constexpr float kTitleSize = 22.0f, kQuantitySize = 14.0f, kNumberSize = 12.5f;
constexpr float kTick = 5.0f;

std::string digits(double value, std::chars_format format, int precision) {
  std::array<char, 64> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, precision).ptr;
  return {buffer.data(), end};
}

void drop_trailing_zeros(std::string& number) {
  if (number.find('.') == std::string::npos) return;
  while (number.back() == '0') number.pop_back();
  if (number.back() == '.') number.pop_back();
}

std::string superscript(int exponent) {
  constexpr std::string_view kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "⁻" : "";
  for (char c : std::to_string(std::abs(exponent))) text += kDigits[c - '0'];
  return text;
}

std::string with_unit(double value, const std::string& unit) {
  return unit.empty() ? short_number(value) : short_number(value) + " " + unit;
}

}  // namespace

std::string short_number(double value) {
  if (std::isnan(value)) return "–";
  if (std::isinf(value)) return value < 0.0 ? "−∞" : "∞";
  const double size = std::abs(value);
  std::string text;
  if (size == 0.0) {
    text = "0";
  } else if (size >= 1e-3 && size < 1e5) {
    const int before_point = static_cast<int>(std::floor(std::log10(size))) + 1;
    text = digits(size, std::chars_format::fixed, std::clamp(3 - before_point, 0, 5));
    drop_trailing_zeros(text);
  } else {
    const std::string scientific = digits(size, std::chars_format::scientific, 1);  // "2.1e-10"
    const size_t e = scientific.find('e');
    std::string mantissa = scientific.substr(0, e);
    drop_trailing_zeros(mantissa);
    text =
        (mantissa == "1" ? "" : mantissa + " × ") + "10" + superscript(std::stoi(scientific.substr(e + 1)));
  }
  return value < 0.0 ? "−" + text : text;
}

void draw_legend(Image& image, const ColourScale& colours, const Theme& theme, float scale) {
  const Palette& palette = palette_of(theme);
  const TextPen regular(FontWeight::Regular), medium(FontWeight::Medium);
  const float bar_width = kBarWidth * scale, bar_height = kBarHeight * scale, padding = kPadding * scale;
  const float quantity_size = kQuantitySize * scale, number_size = kNumberSize * scale;
  const float above = medium.has_font() ? 1.7f * quantity_size : 0.0f;
  const float below = regular.has_font() ? 1.6f * number_size : 0.0f;

  const float x = kMargin * scale + padding;
  const float bar_top = static_cast<float>(image.height) - kMargin * scale - padding - below - bar_height;
  const float box_height = above + bar_height + below + 2.0f * padding;
  image.fill_rectangle(x - padding, bar_top - above - padding, bar_width + 2.0f * padding, box_height,
                       theme.dark ? palette.ground_top : palette.outline, 0.72f, 6.0f * scale);

  const float range = static_cast<float>(colours.high - colours.low);
  const int left = static_cast<int>(std::lround(x)), columns = static_cast<int>(std::lround(bar_width));
  for (int i = 0; i < columns; ++i) {
    const double value = colours.low + (i + 0.5) / columns * static_cast<double>(range);
    image.fill_rectangle(static_cast<float>(left + i), bar_top, 1.0f, bar_height, colour_of(colours, value),
                         1.0f);
  }

  const float numbers_at = bar_top + bar_height + 1.35f * number_size;
  const std::string low = with_unit(colours.low, colours.unit), high = with_unit(colours.high, colours.unit);
  const float high_width = regular.width(high, number_size);
  medium.draw(image, colours.quantity, x, bar_top - 0.75f * quantity_size, quantity_size, palette.text);
  regular.draw(image, low, x, numbers_at, number_size, palette.faint_text);
  regular.draw(image, high, x + bar_width - high_width, numbers_at, number_size, palette.faint_text);

  if (!colours.tolerance || !std::isfinite(*colours.tolerance)) return;
  const std::string limit = "tolerance " + with_unit(*colours.tolerance, colours.unit);
  const float limit_width = regular.width(limit, number_size);
  const bool inside = *colours.tolerance >= colours.low && *colours.tolerance <= colours.high && range > 0.0f;
  if (inside) {
    const float tick =
        x + static_cast<float>((*colours.tolerance - colours.low) / static_cast<double>(range)) * bar_width;
    image.fill_rectangle(std::round(tick - 0.75f * scale), bar_top - kTick * scale, std::round(1.5f * scale),
                         bar_height + 2.0f * kTick * scale, palette.text, 1.0f);
  }
  // Beside the quantity, where it cannot run into the numbers of the ends.
  regular.draw(image, limit, x + bar_width - limit_width, bar_top - 0.75f * quantity_size, number_size,
               palette.faint_text);
}

void draw_title(Image& image, const std::string& title, const Theme& theme, float scale) {
  const TextPen pen(FontWeight::Medium);
  pen.draw(image, title, kMargin * scale, (kMargin + 0.75f * kTitleSize) * scale, kTitleSize * scale,
           palette_of(theme).text);
}

}  // namespace planewright::render
