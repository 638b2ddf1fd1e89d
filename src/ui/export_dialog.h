// The export dialog: formats, sheets with a preview, the folder, progress, and what the certificate says. A
// large card over the window; what goes on in it goes on when it is closed.
//
// Threads: the window's, inside a Dear ImGui frame. Units: mm.
#pragma once

#include <cstdint>
#include <string>

#include "core/workshop/contract.h"
#include "ui/sheet_preview.h"

namespace planewright::ui {

struct Desk;

// What it knows besides the settings that are remembered (UserSettings::workshop_export).
struct ExportDialog {
  bool open = false;
  bool appearing = false;
  std::uint64_t design = 0;  // AppState::opened_count() that folder, project and note are of
  std::string folder;
  bool overwrite = false;
  WorkshopContract contract;     // as it was in the newest frame
  int sheet = 0;                 // that is seen
  bool scroll_to_sheet = false;  // in the row of all
  SheetPreview preview;
};

// Opens it, for another design with another folder, project and note.
void open_export_dialog(Desk& desk);
void draw_export_dialog(Desk& desk);

// Its halves, one file each: what is chosen, and what comes of it.
void draw_export_form(Desk& desk);
void draw_export_sheets(Desk& desk);

}  // namespace planewright::ui
