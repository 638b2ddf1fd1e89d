#include "ui/file_browser.h"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "core/edit/project_file.h"
#include "core/mesh/mesh_io.h"
#include "ui/format.h"
#include "ui/typed_path.h"

namespace planewright::ui {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSheetEnding = ".json";
constexpr std::array<const char*, 4> kEndings = {".obj", ".off", ".ply", ".stl"};

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool has_ending(const fs::path& path, std::string_view ending) {
  return lower(path.extension().string()) == ending;
}

// That a new file of a purpose gets where its name has none; empty: that of its format.
std::string_view ending_of(FileBrowser::Purpose purpose) {
  if (purpose == FileBrowser::Purpose::SaveProject) return kProjectEnding;
  return purpose == FileBrowser::Purpose::SaveTolerances ? kSheetEnding : std::string_view();
}

// What is listed: what can be opened, or what a new file could take the place of.
bool is_listed(FileBrowser::Purpose purpose, const fs::path& path) {
  switch (purpose) {
    case FileBrowser::Purpose::Open:
      return has_ending(path, kProjectEnding) || format_of(path).has_value();
    case FileBrowser::Purpose::SaveProject:
      return has_ending(path, kProjectEnding);
    case FileBrowser::Purpose::OpenTolerances:
    case FileBrowser::Purpose::SaveTolerances:
      return has_ending(path, kSheetEnding);
    case FileBrowser::Purpose::ExportPanels:
      return format_of(path).has_value();
    case FileBrowser::Purpose::ChooseFolder:
      break;
  }
  return false;
}

// The words of each purpose.
struct Words {
  const char *title, *empty, *hint, *name_hint, *accept;
};
Words words_of(FileBrowser::Purpose purpose) {
  switch (purpose) {
    case FileBrowser::Purpose::Open:
      return {"Open a project or a mesh###files",
              "No folders, projects or meshes (.planewright .obj .off .ply .stl) here.",
              "Arrow keys choose, Enter opens, Escape closes. Or drop a file on the window.", "name or path",
              "Open"};
    case FileBrowser::Purpose::SaveProject:
      return {"Save the project###files", "No folders and no projects here.",
              "The design with its settings, names and solved panels. Undo steps are not kept.",
              "name of the project", "Save"};
    case FileBrowser::Purpose::OpenTolerances:
      return {"Load a tolerance sheet###files", "No folders and no sheets (.json) here.",
              "Its limits take the place of those that are set. One step of undo.", "name or path", "Load"};
    case FileBrowser::Purpose::SaveTolerances:
      return {"Save the tolerance sheet###files", "No folders and no sheets (.json) here.",
              "For other designs, and for --tolerances of the command line.", "name of the sheet", "Save"};
    case FileBrowser::Purpose::ExportPanels:
      return {"Save panels as mesh###files", "No folders and no meshes (.obj .off .ply .stl) here.",
              "The ending picks the format: .obj, .off, .ply or .stl.", "name of the new file", "Save"};
    case FileBrowser::Purpose::ChooseFolder:
      break;
  }
  return {"Choose a folder###files", "No folders here.",
          "A double click goes into a folder. The name can be that of a new one.", "name of a folder here",
          "Choose"};
}

}  // namespace

void FileBrowser::open(Purpose purpose, const fs::path& folder, std::string name) {
  purpose_ = purpose;
  is_open_ = appearing_ = true;
  name_ = std::move(name);
  format_ = 0;
  overwrite_.reset();
  std::error_code error;
  enter(!folder.empty() && fs::is_directory(folder, error) ? folder : fs::current_path(error));
}

void FileBrowser::enter(const fs::path& folder) {
  std::error_code error;
  fs::path full = fs::weakly_canonical(folder, error);
  if (error) full = folder;
  std::vector<Entry> entries;
  fs::directory_iterator it(full, fs::directory_options::skip_permission_denied, error);
  if (error) {
    trouble_ = "This folder cannot be read: " + error.message();
    return;
  }
  for (; it != fs::directory_iterator(); it.increment(error)) {
    if (error) break;
    const fs::directory_entry& item = *it;
    Entry entry;
    entry.name = item.path().filename().string();
    if (entry.name.empty() || entry.name.front() == '.') continue;
    std::error_code ignored;  // a file that vanishes meanwhile is simply not listed
    entry.is_folder = item.is_directory(ignored);
    if (!entry.is_folder) {
      if (!is_listed(purpose_, item.path()) || !item.is_regular_file(ignored)) continue;
      entry.size = item.file_size(ignored);
      if (ignored) continue;
    }
    entries.push_back(std::move(entry));
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.is_folder != b.is_folder ? a.is_folder : lower(a.name) < lower(b.name);
  });
  folder_ = full;
  entries_ = std::move(entries);
  selected_ = -1;
  scroll_to_selected_ = true;
  trouble_.clear();
  overwrite_.reset();
}

void FileBrowser::move_selection(int by) {
  if (entries_.empty()) return;
  const int last = static_cast<int>(entries_.size()) - 1;
  selected_ = std::clamp(selected_ + by, 0, last);
  const Entry& entry = entries_[static_cast<std::size_t>(selected_)];
  if (!saving() || !entry.is_folder) name_ = entry.name;
  scroll_to_selected_ = true;
}

std::optional<fs::path> FileBrowser::accept() {
  trouble_.clear();
  std::string name = name_;
  if (name.empty() && selected_ >= 0) name = entries_[static_cast<std::size_t>(selected_)].name;
  if (name.empty() && choosing_folder()) {
    is_open_ = false;
    return folder_;
  }
  if (name.empty()) {
    trouble_ = saving() ? "Give the file a name." : "Choose a file, or type its name.";
    return std::nullopt;
  }
  fs::path path = folder_ / typed_path(name);
  std::error_code error;
  if (choosing_folder()) {
    if (fs::exists(path, error) && !fs::is_directory(path, error)) {
      trouble_ = path.filename().string() + " is a file. Choose a folder, or give a new one a name.";
      return std::nullopt;
    }
    is_open_ = false;
    return path.lexically_normal();
  }
  if (fs::is_directory(path, error)) {
    enter(path);
    if (!saving()) name_.clear();
    return std::nullopt;
  }
  if (!saving()) {
    if (!fs::exists(path, error)) {
      trouble_ = "There is no file " + path.filename().string() + " in " + path.parent_path().string() + ".";
      return std::nullopt;
    }
    is_open_ = false;
    return path;
  }
  if (const std::string_view ending = ending_of(purpose_); !ending.empty()) {
    if (!has_ending(path, ending)) path += ending;
  } else if (!path.has_extension()) {
    path += kEndings[static_cast<std::size_t>(format_)];
  }
  if (const auto format = format_of(path); has_formats() && !format) {
    trouble_ = format.error().text();
    return std::nullopt;
  }
  if (!fs::is_directory(path.parent_path(), error)) {
    trouble_ = "There is no folder " + path.parent_path().string() + ".";
    return std::nullopt;
  }
  if (fs::exists(path, error) && overwrite_ != path) {
    overwrite_ = path;
    return std::nullopt;
  }
  is_open_ = false;
  return path;
}

void FileBrowser::draw_places(Ui& ui) {
  ButtonLook look;
  look.quiet = true;
  look.has_icon = true;
  look.icon = Icon::Up;
  look.tooltip = "To the folder above (Backspace in the list)";
  if (ui.button("up", ui.theme().has_icons() ? "" : "Up", look) && folder_.has_parent_path()) {
    enter(folder_.parent_path());
  }
  ImGui::SameLine(0, ui.px(2));
  look.icon = Icon::Home;
  look.tooltip = "To your own folder";
  if (ui.button("home", ui.theme().has_icons() ? "" : "Home", look)) enter(home_folder());
  // The path as buttons, shortened from the left.
  std::vector<fs::path> parts;
  for (fs::path at = folder_;; at = at.parent_path()) {
    parts.push_back(at);
    if (at == at.parent_path()) break;
  }
  std::reverse(parts.begin(), parts.end());
  const auto label_of = [](const fs::path& p) {
    return p.filename().empty() ? p.string() : p.filename().string();
  };
  float room = ImGui::GetContentRegionAvail().x - ui.px(120);
  std::size_t first = parts.size();
  while (first > 0) {
    room -= ImGui::CalcTextSize(label_of(parts[first - 1]).c_str()).x + ui.px(26);
    if (room < 0 && first < parts.size()) break;
    --first;
  }
  std::optional<fs::path> chosen;
  for (std::size_t i = first; i < parts.size(); ++i) {
    ImGui::SameLine(0, ui.px(2));
    ButtonLook part;
    part.quiet = true;
    const std::string label = label_of(parts[i]);
    if (ui.button("path " + std::to_string(i), label, part)) chosen = parts[i];
    if (i + 1 < parts.size()) {
      ImGui::SameLine(0, 0);
      ImGui::AlignTextToFramePadding();
      ui.text(label == "/" ? "" : "/", ui.colours().ink_faint);
    }
  }
  if (chosen) enter(*chosen);
}

bool FileBrowser::draw_entries(Ui& ui, float height) {
  bool accepted = false;
  ImGui::PushStyleColor(ImGuiCol_ChildBg, to_vec4(ui.colours().raised));
  ImGui::BeginChild("entries", ImVec2(0, height), true);
  const float row = ImGui::GetTextLineHeight() + ui.px(8);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  std::optional<std::size_t> opened;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Entry& entry = entries_[i];
    ImGui::PushID(static_cast<int>(i));
    const bool selected = selected_ == static_cast<int>(i);
    const ImVec2 min = ImGui::GetCursorScreenPos();
    if (ImGui::Selectable("##entry", selected, ImGuiSelectableFlags_AllowDoubleClick,
                          ImVec2(0, row - ui.px(6)))) {
      selected_ = static_cast<int>(i);
      if (!saving() || !entry.is_folder) name_ = entry.name;
      overwrite_.reset();
      if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) opened = i;
    }
    const ImVec2 max = ImGui::GetItemRectMax();
    ui.record_item(entry.name);
    if (selected && scroll_to_selected_) ImGui::SetScrollHereY();
    const float icon = ui.px(26);
    draw_text_aligned(draw, ui.theme().regular(), min, ImVec2(min.x + icon, max.y), 0.3f,
                      entry.is_folder ? ui.colours().accent : ui.colours().ink_faint,
                      ui.theme().icon(entry.is_folder ? Icon::Folder : Icon::File));
    draw_text_aligned(draw, ui.theme().regular(), ImVec2(min.x + icon, min.y), max, 0.0f, ui.colours().ink,
                      entry.is_folder ? entry.name + "/" : entry.name);
    if (!entry.is_folder) {
      draw_text_aligned(draw, ui.theme().small(), min, ImVec2(max.x - ui.px(6), max.y), 1.0f,
                        ui.colours().ink_faint, format_bytes(entry.size));
    }
    ImGui::PopID();
  }
  scroll_to_selected_ = false;
  if (entries_.empty()) ui.small_text(words_of(purpose_).empty);
  if (ImGui::IsWindowFocused() && !ImGui::IsAnyItemActive()) {
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Backspace)) && folder_.has_parent_path()) {
      enter(folder_.parent_path());
    }
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();
  if (opened && *opened < entries_.size()) {
    const Entry entry = entries_[*opened];
    if (entry.is_folder) {
      enter(folder_ / entry.name);
      if (!saving()) name_.clear();  // of what was entered
    } else {
      accepted = true;
    }
  }
  return accepted;
}

std::optional<fs::path> FileBrowser::draw(Ui& ui) {
  if (!is_open_) return std::nullopt;
  std::optional<fs::path> result;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 size(std::min(ui.px(720), screen.x - ui.px(20)), std::min(ui.px(520), screen.y - ui.px(20)));
  if (appearing_) {
    ImGui::SetNextWindowPos(ImVec2(0.5f * screen.x, 0.46f * screen.y), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowSize(size);
    ImGui::SetNextWindowFocus();
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(6));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(16), ui.px(14)));
  const Words words = words_of(purpose_);
  bool keep_open = true;
  ImGui::Begin(words.title, &keep_open,
               ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoScrollbar |
                   ImGuiWindowFlags_NoScrollWithMouse);
  {
    const Ui::Scope scope(ui, "Files");
    draw_places(ui);
    const float frame = ImGui::GetFrameHeightWithSpacing();
    const float below = frame + std::max(frame, ImGui::GetTextLineHeightWithSpacing()) + ui.px(2);
    bool wants = draw_entries(ui, std::max(ImGui::GetContentRegionAvail().y - below, ui.px(60)));

    if (overwrite_) {
      ImGui::AlignTextToFramePadding();
      ui.text(overwrite_->filename().string() + " exists already.", ui.colours().warning);
      ImGui::SameLine();
      if (ui.button("replace", "Replace it")) result = accept();
      ImGui::SameLine();
      if (ui.button("keep", "Keep it")) overwrite_.reset();
    } else if (!trouble_.empty()) {
      ui.wrapped(trouble_, ui.colours().error);
    } else {
      ui.small_text(words.hint);
    }

    // The name and what to do with it.
    const float button = ui.px(110), format = has_formats() ? ui.px(90) : 0;
    const float space = ImGui::GetStyle().ItemSpacing.x;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 2 * button - 2 * space -
                            (has_formats() ? format + space : 0));
    if (appearing_) ImGui::SetKeyboardFocusHere();
    if (ImGui::InputTextWithHint("##name", words.name_hint, &name_,
                                 ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll)) {
      wants = true;
    }
    const bool typing = ImGui::IsItemActive();
    ui.record_item("name");
    if (has_formats()) {
      ImGui::SameLine();
      ImGui::SetNextItemWidth(format);
      const fs::path named(name_);
      if (const auto named_format = format_of(named)) format_ = static_cast<int>(*named_format);
      if (ImGui::BeginCombo("##format", kEndings[static_cast<std::size_t>(format_)])) {
        for (std::size_t i = 0; i < kEndings.size(); ++i) {
          if (ImGui::Selectable(kEndings[i], format_ == static_cast<int>(i))) {
            format_ = static_cast<int>(i);
            name_ = fs::path(name_).replace_extension(kEndings[i]).string();
          }
          ui.record_item(std::string("format/") + kEndings[i]);
        }
        ImGui::EndCombo();
      }
      ui.record_item("format");
    }
    ImGui::SameLine();
    ButtonLook look;
    look.width = button;
    if (ui.button("cancel", "Cancel", look)) keep_open = false;
    ImGui::SameLine();
    look.primary = true;
    if (ui.button("accept", words.accept, look)) wants = true;

    if (ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows)) {
      if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_DownArrow))) move_selection(1);
      if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_UpArrow))) move_selection(-1);
      if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_PageDown))) move_selection(10);
      if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_PageUp))) move_selection(-10);
      if (!typing && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter))) wants = true;
      if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) keep_open = false;
    }
    if (wants && !result) result = accept();
  }
  ImGui::End();
  ImGui::PopStyleVar(3);
  appearing_ = false;
  if (!keep_open) is_open_ = false;
  return result;
}

}  // namespace planewright::ui
