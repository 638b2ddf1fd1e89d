#include "ui/render/text.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <cmath>
#include <cstdint>
#include <vector>

namespace planewright::render {
namespace {

constexpr char32_t kReplacement = 0xfffd;

// Code points of UTF-8 text.
std::vector<char32_t> decode(std::string_view text) {
  std::vector<char32_t> points;
  for (size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i++]);
    const int more = lead < 0x80   ? 0
                     : lead < 0xc2 ? -1
                     : lead < 0xe0 ? 1
                     : lead < 0xf0 ? 2
                     : lead < 0xf5 ? 3
                                   : -1;
    if (more < 0) {
      points.push_back(kReplacement);
      continue;
    }
    char32_t point = more == 0 ? lead : lead & (0x3fu >> more);
    int seen = 0;
    for (; seen < more && i < text.size() && (static_cast<unsigned char>(text[i]) & 0xc0u) == 0x80u;
         ++seen, ++i) {
      point = point << 6 | (static_cast<unsigned char>(text[i]) & 0x3fu);
    }
    points.push_back(seen == more ? point : kReplacement);
  }
  return points;
}

float from_26_6(FT_Pos value) {
  return static_cast<float>(value) / 64.0f;
}

}  // namespace

struct TextPen::Impl {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  explicit Impl(const std::filesystem::path& font) {
    if (FT_Init_FreeType(&library) != 0) {
      library = nullptr;
    } else if (FT_New_Face(library, font.c_str(), 0, &face) != 0) {
      face = nullptr;
    }
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    if (face != nullptr) FT_Done_Face(face);
    if (library != nullptr) FT_Done_FreeType(library);
  }

  // Calls put(glyph slot with an outline, x of its origin) for each letter; returns the width.
  template <class Put>
  float set(std::string_view text, float size, Put put) const {
    if (face == nullptr || FT_Set_Char_Size(face, 0, std::lround(64.0f * size), 72, 72) != 0) return 0.0f;
    float x = 0.0f;
    FT_UInt before = 0;
    for (const char32_t point : decode(text)) {
      const FT_UInt glyph = FT_Get_Char_Index(face, point);
      FT_Vector kerning{0, 0};
      if (before != 0 && glyph != 0 && FT_HAS_KERNING(face) &&
          FT_Get_Kerning(face, before, glyph, FT_KERNING_UNFITTED, &kerning) == 0) {
        x += from_26_6(kerning.x);
      }
      // Unhinted: letters keep their shape and place at any size.
      if (FT_Load_Glyph(face, glyph, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) != 0) continue;
      put(face->glyph, x);
      x += static_cast<float>(face->glyph->linearHoriAdvance) / 65536.0f;
      before = glyph;
    }
    return x;
  }
};

TextPen::TextPen(FontWeight weight) : TextPen(find_font(weight).value_or(std::filesystem::path{})) {}
TextPen::TextPen(const std::filesystem::path& font) : impl_(std::make_unique<Impl>(font)) {}
TextPen::TextPen(TextPen&&) noexcept = default;
TextPen& TextPen::operator=(TextPen&&) noexcept = default;
TextPen::~TextPen() = default;

bool TextPen::has_font() const {
  return impl_->face != nullptr;
}

float TextPen::width(std::string_view text, float size) const {
  return impl_->set(text, size, [](FT_GlyphSlot, float) {});
}

void TextPen::draw(Image& image, std::string_view text, float x, float baseline, float size,
                   const glm::vec3& colour) const {
  const float whole_baseline = std::round(baseline);
  impl_->set(text, size, [&](FT_GlyphSlot glyph, float offset) {
    const float at = x + offset, whole = std::floor(at);
    FT_Outline_Translate(&glyph->outline, std::lround(64.0f * (at - whole)), 0);
    if (FT_Render_Glyph(glyph, FT_RENDER_MODE_NORMAL) != 0) return;
    const FT_Bitmap& bitmap = glyph->bitmap;
    for (unsigned row = 0; row < bitmap.rows; ++row) {
      for (unsigned column = 0; column < bitmap.width; ++column) {
        const std::uint8_t cover =
            bitmap.buffer[static_cast<int>(row) * bitmap.pitch + static_cast<int>(column)];
        if (cover == 0) continue;
        image.blend(static_cast<int>(whole) + glyph->bitmap_left + static_cast<int>(column),
                    static_cast<int>(whole_baseline) - glyph->bitmap_top + static_cast<int>(row), colour,
                    static_cast<float>(cover) / 255.0f);
      }
    }
  });
}

}  // namespace planewright::render
