// Measures of text that the parts of widgets.h share. Internal to them. Units: pixels.
#pragma once

#include <imgui.h>

#include <cfloat>
#include <string_view>

namespace planewright::ui {

inline const char* end_of(std::string_view text) {
  return text.data() + text.size();
}

inline ImVec2 text_size(ImFont* font, std::string_view text) {
  if (text.empty()) return {0.0f, font->FontSize};  // a null pointer would be read as a C string
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, text.data(), end_of(text));
}

}  // namespace planewright::ui
