// WindowState: what the window itself knows besides the design: settings, open cards, wishes to the viewport.
//
// Threads: a plain value of the window's thread.
#pragma once

#include <optional>
#include <string>

#include "ui/edit_choices.h"
#include "ui/export_dialog.h"
#include "ui/file_browser.h"
#include "ui/leaving.h"
#include "ui/look_at.h"
#include "ui/name_field.h"
#include "ui/schedule_view.h"
#include "ui/user_settings.h"

namespace planewright::ui {

struct WindowState {
  UserSettings settings;
  FileBrowser browser;
  ExportDialog export_dialog;
  bool export_dialog_wanted = false;
  bool show_keys = false;
  bool show_timings = false;
  bool show_about = false;
  bool own_metric = false;  // the weights of the clusters' measure are shown, whatever they are
  int right_tab = 0;        // findings, report, workshop
  bool tab_wanted = false;
  std::optional<int> listed_finding, listed_suggestion,
      listed_failure;  // that a list has last brought into sight
  ScheduleView schedule;
  std::optional<int> listed_panel;            // that the schedule has last brought into sight
  std::optional<MeshEdit> suggestion_wanted;  // that was clicked in the list
  bool fit_wanted = false, reset_view_wanted = false;
  std::optional<LookAt> look_at;
  EditTarget context_target;  // of the menu that the right button opened
  NameTyping typing;
  std::optional<Leaving> leaving;  // that waits for the designer to say what becomes of unsaved changes
  bool quit = false;
};

}  // namespace planewright::ui
