// WindowState: what the window itself knows besides the design: settings, open cards, wishes to the viewport.
//
// Threads: a plain value of the window's thread.
#pragma once

#include <optional>
#include <string>

#include "core/base/geometry.h"
#include "ui/file_browser.h"
#include "ui/user_settings.h"

namespace planewright::ui {

struct LookAt {
  Vector3d point;  // scene coordinates
  double radius;   // of what should fill the view
};

struct WindowState {
  UserSettings settings;
  FileBrowser browser;
  bool show_keys = false;
  bool show_timings = false;
  bool show_about = false;
  int right_tab = 0;  // findings, report
  bool tab_wanted = false;
  bool fit_wanted = false, reset_view_wanted = false;
  std::optional<LookAt> look_at;
  bool quit = false;
};

}  // namespace planewright::ui
