// Theme: the look of a drawing office. Warm greys, one ink, one accent (teal: selection), amber and red for
// findings.
//
// Fonts are the system's (Inter, then Roboto, then DejaVu Sans, then the built-in one), with FontAwesome's
// icons merged in where it is installed. Sizes are in pixels at scale 1 and are multiplied by the monitor's
// scale. Threads: the window's; needs a Dear ImGui context.
#pragma once

#include <imgui.h>

#include <string>

namespace planewright::ui {

enum class Icon {
  Open,
  Export,
  Undo,
  Redo,
  Play,
  Stop,
  Fit,
  Ghost,
  Colours,
  Warning,
  Error,
  Info,
  Done,
  Close,
  Folder,
  File,
  Up,
  Home,
  Help,
  ChevronDown,
  ChevronRight,
  Restart,
  Target,
  Hidden,
  Add,
  Copy,
  Remove,
  Pin,
};

struct Palette {
  ImU32 ground;  // behind everything
  ImU32 panel;   // side panels, bars
  ImU32 raised;  // buttons, fields
  ImU32 hovered, pressed;
  ImU32 line;                      // separators, frames
  ImU32 ink, ink_soft, ink_faint;  // text: main, labels, hints
  ImU32 accent, accent_soft, on_accent;
  ImU32 warning, error, good;
  ImU32 objective, infeasibility;  // curves
  ImU32 overlay;                   // cards over the model
  ImU32 shadow;
};

class Theme {
 public:
  // Loads the fonts into the current context's atlas and sets the style. `scale`: 1 for a plain monitor.
  Theme(float scale, bool dark);

  void set_dark(bool dark);
  bool dark() const { return dark_; }
  float scale() const { return scale_; }
  float px(float at_scale_one) const { return at_scale_one * scale_; }
  const Palette& colours() const { return palette_; }

  ImFont* regular() const { return regular_; }
  ImFont* bold() const { return bold_; }
  ImFont* small() const { return small_; }
  // The icon's UTF-8 text, or empty where no icon font is installed: then buttons say it in words.
  const char* icon(Icon icon) const;
  bool has_icons() const { return has_icons_; }
  const std::string& font_name() const { return font_name_; }

 private:
  void load_fonts();
  void apply_style() const;

  float scale_ = 1.0f;
  bool dark_ = false;
  bool has_icons_ = false;
  Palette palette_{};
  ImFont* regular_ = nullptr;
  ImFont* bold_ = nullptr;
  ImFont* small_ = nullptr;
  std::string font_name_;
};

ImVec4 to_vec4(ImU32 colour);
ImU32 with_alpha(ImU32 colour, float alpha);

}  // namespace planewright::ui
