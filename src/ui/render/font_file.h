// Finding a font on this machine: the window's text and that of pictures use the same. No OpenGL.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace planewright::render {

enum class FontWeight { Regular, Medium };

// Where Debian and its relatives put Inter, Roboto and DejaVu Sans, best first.
const std::vector<std::filesystem::path>& font_candidates(FontWeight weight);

// The first candidate that is a readable file; nothing when the machine has none.
std::optional<std::filesystem::path> find_font(FontWeight weight = FontWeight::Regular);
std::optional<std::filesystem::path> first_readable(const std::vector<std::filesystem::path>& candidates);

}  // namespace planewright::render
