// Actions: everything that the window can be told to do, with its name, shortcut and whether it can be done
// now. Menus, buttons and keys all go through here, so they agree. Requests are gathered while a frame is
// drawn and applied at its end.
//
// Threads: the window's.
#pragma once

#include <string>
#include <vector>

#include "ui/action_list.h"
#include "ui/app_state.h"
#include "ui/window_state.h"

namespace planewright::ui {

class Actions {
 public:
  Actions(AppState& state, WindowState& window) : state_(state), window_(window) {}

  bool enabled(Action action) const;
  bool checked(Action action) const;
  std::string label(Action action) const;  // "Undo flip edge 12"
  void request(Action action) { requested_.push_back(action); }
  // Requests what the key stands for; false if it stands for nothing.
  bool press(const KeyPress& key);
  void apply_requested();

 private:
  void run(Action action);
  bool rests(Action action) const;
  void change_selection(Action action);
  void set_mode(ComplexKind mode);
  void take_tool(Tool tool);

  AppState& state_;
  WindowState& window_;
  std::vector<Action> requested_;
};

// Selects what an element of the shown panels is and looks at it. Elements that the shown panels do not have
// are left alone.
void show_element(AppState& state, WindowState& window, const ElementRef& element);

}  // namespace planewright::ui
