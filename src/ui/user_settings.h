// UserSettings: what the window remembers between starts. A small JSON file under the XDG configuration
// folder.
//
// A missing or damaged file means the defaults; unknown keys are ignored and values out of range are brought
// back. Units: window sizes in screen coordinates, panel sizes in pixels at scale 1. Threads: plain value.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "ui/export_choice.h"

namespace planewright::ui {

struct UserSettings {
  int window_width = 1440, window_height = 900;
  float left_width = 316, right_width = 300, bottom_height = 190;
  float schedule_height = 290;   // of the panel below the model while it shows the schedule
  bool convergence_open = true;  // the panel below the model is open, whichever of its tabs it shows
  bool schedule_tab = false;     // it shows the schedule, not the convergence
  bool dark = false;
  std::string unit = "m";  // what one unit of a model is called
  bool show_ghost = true;
  bool show_hint = true;                              // the three lines of what to try
  bool auto_solve = true;                             // solve at every change
  bool polish_automatically = false;                  // Ipopt confirms what the tangent solver has finished
  std::map<std::string, double> finding_limits = {};  // finding_limits.h
  std::string last_folder = {};
  ExportChoice workshop_export = {};

  bool operator==(const UserSettings&) const = default;
};

// $XDG_CONFIG_HOME/planewright/window.json, or ~/.config/...; nothing where neither variable is set.
std::optional<std::filesystem::path> user_settings_path();

// The settings in a file's text. Fails with ErrorCode::Unreadable where it is no JSON object.
Result<UserSettings> parse_user_settings(const std::string& text);
std::string format_user_settings(const UserSettings& settings);

}  // namespace planewright::ui
