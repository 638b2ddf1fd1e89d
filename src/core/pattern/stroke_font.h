// A font of single strokes, for engraving: A-Z, a-z (small capitals), 0-9 (a zero has a stroke through it),
// - _ . / and the space. Every other character is an empty box. Threads: pure.
#pragma once

#include <string_view>
#include <vector>

#include "core/pattern/flat_pattern.h"

namespace planewright {

// Width of a text whose capitals are `height` high, mm. All characters are equally wide.
double stroke_width(std::string_view text, double height);

// Open polylines, mm; the text's lower left corner is (0, 0).
std::vector<Contour> text_strokes(std::string_view text, double height);

}  // namespace planewright
