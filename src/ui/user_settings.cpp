#include "ui/user_settings.h"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "ui/export_choice_json.h"

namespace planewright::ui {
namespace {

template <class T>
void read(const nlohmann::json& json, const char* key, T& value) {
  const auto found = json.find(key);
  if (found == json.end()) return;
  if constexpr (std::is_same_v<T, bool>) {
    if (found->is_boolean()) value = found->template get<bool>();
  } else if constexpr (std::is_same_v<T, std::string>) {
    if (found->is_string()) value = found->template get<std::string>();
  } else {
    if (found->is_number()) value = static_cast<T>(found->template get<double>());
  }
}

}  // namespace

std::optional<std::filesystem::path> user_settings_path() {
  if (const char* folder = std::getenv("XDG_CONFIG_HOME"); folder != nullptr && *folder != '\0') {
    return std::filesystem::path(folder) / "planewright" / "window.json";
  }
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0') {
    return std::filesystem::path(home) / ".config" / "planewright" / "window.json";
  }
  return std::nullopt;
}

Result<UserSettings> parse_user_settings(const std::string& text) {
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object()) return fail(ErrorCode::Unreadable, "the window's settings are not a JSON object");
  UserSettings s;
  read(json, "window_width", s.window_width);
  read(json, "window_height", s.window_height);
  read(json, "left_width", s.left_width);
  read(json, "right_width", s.right_width);
  read(json, "bottom_height", s.bottom_height);
  read(json, "schedule_height", s.schedule_height);
  read(json, "convergence_open", s.convergence_open);
  read(json, "schedule_tab", s.schedule_tab);
  read(json, "dark", s.dark);
  read(json, "unit", s.unit);
  read(json, "show_ghost", s.show_ghost);
  read(json, "show_hint", s.show_hint);
  read(json, "auto_solve", s.auto_solve);
  read(json, "polish_automatically", s.polish_automatically);
  read(json, "last_folder", s.last_folder);
  if (const auto limits = json.find("finding_limits"); limits != json.end() && limits->is_object()) {
    for (const auto& [name, limit] : limits->items())
      if (limit.is_number()) s.finding_limits[name] = limit.get<double>();
  }
  if (const auto choice = json.find("workshop_export"); choice != json.end())
    s.workshop_export = read_export_choice(*choice);
  s.window_width = std::clamp(s.window_width, 640, 16384);
  s.window_height = std::clamp(s.window_height, 480, 16384);
  s.left_width = std::clamp(s.left_width, 240.0f, 800.0f);
  s.right_width = std::clamp(s.right_width, 220.0f, 800.0f);
  s.bottom_height = std::clamp(s.bottom_height, 110.0f, 800.0f);
  s.schedule_height = std::clamp(s.schedule_height, 110.0f, 800.0f);
  if (s.unit.size() > 12) s.unit = UserSettings().unit;
  return s;
}

std::string format_user_settings(const UserSettings& s) {
  const nlohmann::ordered_json json = {
      {"window_width", s.window_width},
      {"window_height", s.window_height},
      {"left_width", s.left_width},
      {"right_width", s.right_width},
      {"bottom_height", s.bottom_height},
      {"schedule_height", s.schedule_height},
      {"convergence_open", s.convergence_open},
      {"schedule_tab", s.schedule_tab},
      {"dark", s.dark},
      {"unit", s.unit},
      {"show_ghost", s.show_ghost},
      {"show_hint", s.show_hint},
      {"auto_solve", s.auto_solve},
      {"polish_automatically", s.polish_automatically},
      {"finding_limits", s.finding_limits},
      {"last_folder", s.last_folder},
      {"workshop_export", to_json(s.workshop_export)},
  };
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace planewright::ui
