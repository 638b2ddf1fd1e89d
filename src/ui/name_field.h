// A name that is typed in place. Threads: the window's, inside a Dear ImGui frame.
#pragma once

#include <string>
#include <string_view>

#include "ui/widgets.h"

namespace planewright::ui {

// What is being typed; one field at a time.
struct NameTyping {
  std::string field;  // record name; empty: none
  std::string text;
  bool begins = false;
};

void begin_typing_name(NameTyping& typing, std::string_view field, const std::string& name);
// While `field` is being typed in: draws the text field at the cursor and returns true when the typing is
// over. `name` is the new name then, or stays what it was (Escape, or an empty text).
bool typing_name(Ui& ui, NameTyping& typing, std::string_view field, std::string& name, float width);

}  // namespace planewright::ui
