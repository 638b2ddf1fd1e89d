// The workshop in the right panel.
#include "ui/format.h"
#include "ui/panels.h"

namespace planewright::ui {

void draw_workshop(Desk& desk) {
  Ui& ui = desk.ui;
  if (desk.state.document().empty()) {
    ui.small_text("No design yet.");
    return;
  }
  if (ui.section("terms", "Terms")) draw_contract(desk);
}

}  // namespace planewright::ui
