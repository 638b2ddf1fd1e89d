// Leaving a design: quitting, or opening another one. Changes that are not saved are asked about first.
//
// Threads: the window's.
#pragma once

#include <filesystem>

namespace planewright::ui {

class AppState;
struct WindowState;

struct Leaving {
  enum class What { Quit, Open, Sample };
  What what = What::Quit;
  std::filesystem::path where;  // the file, or the sample's name
  bool once_saved = false;      // the designer has said: save, and then
};

// At once where nothing would be lost; else it waits in `window` for an answer (draw_leaving() of panels.h).
void leave(WindowState& window, AppState& state, Leaving leaving);

}  // namespace planewright::ui
