// The legend of a colour map and the title, drawn into a picture. No OpenGL.
#pragma once

#include <string>

#include "ui/render/image.h"
#include "ui/render/renderer.h"

namespace planewright::render {

// A number as legends and read-outs show it: three significant digits, "1.85", "240", "2.1 × 10⁻¹⁰"; UTF-8.
std::string short_number(double value);

// Bottom left: the quantity, a bar from low to high, its ends with unit, the tolerance. `scale`: pixels per
// point.
void draw_legend(Image& image, const ColourScale& colours, const Theme& theme, float scale);

// Top left.
void draw_title(Image& image, const std::string& title, const Theme& theme, float scale);

}  // namespace planewright::render
