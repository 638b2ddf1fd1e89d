// Text in pictures, set with FreeType. No OpenGL.
//
// Where the machine has no font (or it cannot be read) everything works and draws nothing. Threads: one at a
// time.
#pragma once

#include <memory>
#include <string_view>

#include "ui/render/font_file.h"
#include "ui/render/image.h"

namespace planewright::render {

class TextPen {
 public:
  explicit TextPen(FontWeight weight = FontWeight::Regular);
  explicit TextPen(const std::filesystem::path& font);
  TextPen(TextPen&&) noexcept;
  TextPen& operator=(TextPen&&) noexcept;
  ~TextPen();

  bool has_font() const;
  // In pixels; text is UTF-8, what is not valid shows as a replacement sign. Width 0 without a font.
  float width(std::string_view text, float size) const;
  // x: left end; baseline: y of the line the letters stand on.
  void draw(Image& image, std::string_view text, float x, float baseline, float size,
            const glm::vec3& colour) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace planewright::render
