#include "ui/theme.h"

#include <imgui_freetype.h>

#include <cmath>
#include <optional>

#include "ui/render/font_file.h"

namespace planewright::ui {
namespace {

namespace fs = std::filesystem;

constexpr ImU32 rgb(unsigned hex) {
  return IM_COL32((hex >> 16) & 0xff, (hex >> 8) & 0xff, hex & 0xff, 0xff);
}

constexpr Palette kLight = {
    .ground = rgb(0xE4E1DB),
    .panel = rgb(0xF3F1ED),
    .raised = rgb(0xFCFBF9),
    .hovered = rgb(0xE9E6E0),
    .pressed = rgb(0xDDD9D1),
    .line = rgb(0xD3CEC5),
    .ink = rgb(0x2C2A27),
    .ink_soft = rgb(0x625D56),
    .ink_faint = rgb(0x938D84),
    .accent = rgb(0x137A78),
    .accent_soft = rgb(0xCFE3E0),
    .on_accent = rgb(0xFFFFFF),
    .warning = rgb(0xB4700B),
    .error = rgb(0xB3352B),
    .good = rgb(0x3F7D4E),
    .objective = rgb(0x2C2A27),
    .infeasibility = rgb(0x3F78B5),
    .overlay = rgb(0xFBFAF8),
    .shadow = IM_COL32(40, 34, 24, 26),
};

constexpr Palette kDark = {
    .ground = rgb(0x1E1D1B),
    .panel = rgb(0x2A2926),
    .raised = rgb(0x37352F),
    .hovered = rgb(0x423F39),
    .pressed = rgb(0x4D4A43),
    .line = rgb(0x45423B),
    .ink = rgb(0xE9E5DD),
    .ink_soft = rgb(0xB1AB9F),
    .ink_faint = rgb(0x857F74),
    .accent = rgb(0x35A8A2),
    .accent_soft = rgb(0x21494A),
    .on_accent = rgb(0x0F1413),
    .warning = rgb(0xE0A23D),
    .error = rgb(0xE0685C),
    .good = rgb(0x74B883),
    .objective = rgb(0xE9E5DD),
    .infeasibility = rgb(0x6EA6DE),
    .overlay = rgb(0x2F2E2A),
    .shadow = IM_COL32(0, 0, 0, 70),
};

// Headings are a step heavier than the text; what the machine lacks falls back to the text's own font.
std::optional<fs::path> find_heading_font() {
  const auto heavier = render::first_readable({"/usr/share/fonts/opentype/inter/Inter-SemiBold.otf",
                                               "/usr/share/fonts/truetype/inter/Inter-SemiBold.ttf"});
  return heavier ? heavier : render::find_font(render::FontWeight::Medium);
}

std::optional<fs::path> find_icon_font() {
  return render::first_readable({"/usr/share/fonts/truetype/font-awesome/fontawesome-webfont.ttf",
                                 "/usr/share/fonts/opentype/font-awesome/FontAwesome.otf",
                                 "/usr/share/fonts-font-awesome/fonts/fontawesome-webfont.ttf"});
}

// Latin, Greek for formulas, and the punctuation, arrows and signs that the texts use.
constexpr ImWchar kTextRanges[] = {0x0020, 0x00FF, 0x0370, 0x03FF, 0x2010, 0x2027, 0x2032,
                                   0x2033, 0x2070, 0x209C, 0x2190, 0x2193, 0x2212, 0x2212,
                                   0x221E, 0x221E, 0x2248, 0x2248, 0x2264, 0x2265, 0};
// FontAwesome 4.7, the icons below.
constexpr ImWchar kIconRanges[] = {0xF00C, 0xF00D, 0xF015, 0xF016, 0xF019, 0xF01E, 0xF021, 0xF021, 0xF043,
                                   0xF043, 0xF04B, 0xF04D, 0xF057, 0xF05B, 0xF065, 0xF071, 0xF07B, 0xF07C,
                                   0xF08D, 0xF08D, 0xF093, 0xF093, 0xF0C5, 0xF0C5, 0xF0E2, 0xF0E2, 0xF105,
                                   0xF107, 0xF148, 0xF148, 0xF1F8, 0xF1F8, 0};

const char* icon_text(Icon icon) {
  switch (icon) {
    case Icon::Open:
      return "\uF07C";
    case Icon::Export:
      return "\uF093";
    case Icon::Undo:
      return "\uF0E2";
    case Icon::Redo:
      return "\uF01E";
    case Icon::Play:
      return "\uF04B";
    case Icon::Stop:
      return "\uF04D";
    case Icon::Fit:
      return "\uF065";
    case Icon::Ghost:
      return "\uF06E";
    case Icon::Colours:
      return "\uF043";
    case Icon::Warning:
      return "\uF071";
    case Icon::Error:
      return "\uF057";
    case Icon::Info:
      return "\uF05A";
    case Icon::Done:
      return "\uF058";
    case Icon::Close:
      return "\uF00D";
    case Icon::Folder:
      return "\uF07B";
    case Icon::File:
      return "\uF016";
    case Icon::Up:
      return "\uF148";
    case Icon::Home:
      return "\uF015";
    case Icon::Help:
      return "\uF059";
    case Icon::ChevronDown:
      return "\uF107";
    case Icon::ChevronRight:
      return "\uF105";
    case Icon::Restart:
      return "\uF021";
    case Icon::Target:
      return "\uF05B";
    case Icon::Hidden:
      return "\uF070";
    case Icon::Add:
      return "\uF067";
    case Icon::Copy:
      return "\uF0C5";
    case Icon::Remove:
      return "\uF1F8";
    case Icon::Pin:
      return "\uF08D";
  }
  return "";
}

}  // namespace

ImVec4 to_vec4(ImU32 colour) {
  return ImGui::ColorConvertU32ToFloat4(colour);
}

ImU32 with_alpha(ImU32 colour, float alpha) {
  const auto a = static_cast<ImU32>(alpha * 255.0f + 0.5f);
  return (colour & ~IM_COL32_A_MASK) | (a << IM_COL32_A_SHIFT);
}

Theme::Theme(float scale, bool dark) : scale_(scale) {
  load_fonts();
  set_dark(dark);
}

void Theme::set_dark(bool dark) {
  dark_ = dark;
  palette_ = dark ? kDark : kLight;
  apply_style();
}

const char* Theme::icon(Icon icon) const {
  return has_icons_ ? icon_text(icon) : "";
}

void Theme::load_fonts() {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;

  const auto text = render::find_font(render::FontWeight::Regular);
  const auto heading = find_heading_font();
  const auto icons = find_icon_font();
  font_name_ = text ? text->stem().string() : "built-in";
  has_icons_ = icons.has_value();

  const auto add = [&](const std::optional<fs::path>& file, float size) -> ImFont* {
    ImFontConfig config;
    ImFont* font = nullptr;
    if (file) {
      font = atlas.AddFontFromFileTTF(file->c_str(), size, &config, kTextRanges);
    } else {
      config.SizePixels = size;
      font = atlas.AddFontDefault(&config);
    }
    if (icons) {
      ImFontConfig merged;
      merged.MergeMode = true;
      merged.GlyphMinAdvanceX = 1.15f * size;  // icons of one width line up
      merged.GlyphOffset = ImVec2(0, 0.04f * size);
      atlas.AddFontFromFileTTF(icons->c_str(), 0.95f * size, &merged, kIconRanges);
    }
    return font;
  };
  // Whole pixels: else every second line of a paragraph would be blurred.
  regular_ = add(text, std::round(px(15.5f)));
  bold_ = add(heading ? heading : text, std::round(px(15.5f)));
  small_ = add(text, std::round(px(13.6f)));
  ImGui::GetIO().FontDefault = regular_;
}

void Theme::apply_style() const {
  ImGuiStyle style;  // from the defaults each time, so that scaling does not add up
  style.WindowPadding = ImVec2(12, 10);
  style.FramePadding = ImVec2(9, 5);
  style.ItemSpacing = ImVec2(8, 6);
  style.ItemInnerSpacing = ImVec2(6, 4);
  style.CellPadding = ImVec2(4, 3);
  style.IndentSpacing = 14;
  style.ScrollbarSize = 11;
  style.GrabMinSize = 12;
  style.WindowBorderSize = 0;
  style.ChildBorderSize = 1;
  style.PopupBorderSize = 1;
  style.FrameBorderSize = 1;
  style.WindowRounding = 0;
  style.ChildRounding = 4;
  style.FrameRounding = 4;
  style.PopupRounding = 5;
  style.ScrollbarRounding = 6;
  style.GrabRounding = 4;
  style.TabRounding = 4;
  style.WindowMinSize = ImVec2(1, 1);
  style.ScaleAllSizes(scale_);
  style.AntiAliasedLinesUseTex = true;

  const Palette& p = palette_;
  const auto set = [&](ImGuiCol index, ImU32 colour) { style.Colors[index] = to_vec4(colour); };
  set(ImGuiCol_Text, p.ink);
  set(ImGuiCol_TextDisabled, p.ink_faint);
  set(ImGuiCol_WindowBg, p.panel);
  set(ImGuiCol_ChildBg, IM_COL32(0, 0, 0, 0));
  set(ImGuiCol_PopupBg, p.overlay);
  set(ImGuiCol_Border, p.line);
  set(ImGuiCol_BorderShadow, IM_COL32(0, 0, 0, 0));
  set(ImGuiCol_FrameBg, p.raised);
  set(ImGuiCol_FrameBgHovered, p.hovered);
  set(ImGuiCol_FrameBgActive, p.pressed);
  set(ImGuiCol_TitleBg, p.panel);
  set(ImGuiCol_TitleBgActive, p.panel);
  set(ImGuiCol_TitleBgCollapsed, p.panel);
  set(ImGuiCol_MenuBarBg, p.panel);
  set(ImGuiCol_ScrollbarBg, IM_COL32(0, 0, 0, 0));
  set(ImGuiCol_ScrollbarGrab, p.line);
  set(ImGuiCol_ScrollbarGrabHovered, p.ink_faint);
  set(ImGuiCol_ScrollbarGrabActive, p.ink_faint);
  set(ImGuiCol_CheckMark, p.accent);
  set(ImGuiCol_SliderGrab, p.ink_soft);
  set(ImGuiCol_SliderGrabActive, p.accent);
  set(ImGuiCol_Button, p.raised);
  set(ImGuiCol_ButtonHovered, p.hovered);
  set(ImGuiCol_ButtonActive, p.pressed);
  set(ImGuiCol_Header, p.accent_soft);
  set(ImGuiCol_HeaderHovered, p.hovered);
  set(ImGuiCol_HeaderActive, p.pressed);
  set(ImGuiCol_Separator, p.line);
  set(ImGuiCol_SeparatorHovered, p.accent);
  set(ImGuiCol_SeparatorActive, p.accent);
  set(ImGuiCol_ResizeGrip, IM_COL32(0, 0, 0, 0));
  set(ImGuiCol_ResizeGripHovered, p.line);
  set(ImGuiCol_ResizeGripActive, p.accent);
  set(ImGuiCol_Tab, p.panel);
  set(ImGuiCol_TabHovered, p.hovered);
  set(ImGuiCol_TabActive, p.raised);
  set(ImGuiCol_TabUnfocused, p.panel);
  set(ImGuiCol_TabUnfocusedActive, p.raised);
  set(ImGuiCol_TableHeaderBg, p.panel);
  set(ImGuiCol_TableBorderStrong, p.line);
  set(ImGuiCol_TableBorderLight, p.line);
  set(ImGuiCol_TableRowBg, IM_COL32(0, 0, 0, 0));
  set(ImGuiCol_TableRowBgAlt, IM_COL32(0, 0, 0, 0));
  set(ImGuiCol_TextSelectedBg, p.accent_soft);
  set(ImGuiCol_NavHighlight, p.accent);
  set(ImGuiCol_ModalWindowDimBg, p.shadow);
  ImGui::GetStyle() = style;
}

}  // namespace planewright::ui
