// Ui: a thin layer over Dear ImGui. Every control of the window goes through it, so that all look alike, and
// so that a test can find each by a path ("Design/weight fairing") with its rectangle of the present frame.
//
// Threads: the window's. Units: pixels of the window, (0, 0) top left.
#pragma once

#include <imgui.h>

#include <map>
#include <span>
#include <string>
#include <string_view>

#include "ui/theme.h"

namespace planewright::ui {

// Where a control stood when it was last drawn.
struct UiRecord {
  ImVec2 min, max;
  float travel_left = 0, travel_right = 0, knob = 0;  // x of a slider's knob and its range; 0 for others
  bool clickable = false;                             // its middle is inside the visible part of its window
  bool enabled = true;
  int frame = -1;
  ImVec2 middle() const { return {0.5f * (min.x + max.x), 0.5f * (min.y + max.y)}; }
};

struct Edit {
  bool changed = false;   // the value is another one
  bool finished = false;  // the gesture (drag, wheel, typing) is over
};

// How a number is entered (Ui::quantity).
struct QuantityLook {
  std::string_view prefix = {};  // "from": faint, inside the field
  std::string_view unit = {};
  double per_pixel = 0.01;   // of a drag
  double reset_value = 0.0;  // of a double click
  double least = -1e300;     // smaller entries become this
  double none = 0.0;         // what an emptied field means; 0: a field cannot be empty
  double from_none = 0.0;    // where a drag or the wheel begins while there is no limit
  float width = 0;           // pixels; 0: as wide as there is room
  std::string_view tooltip = {};
};

// A number of things on a logarithmic slider (Ui::count), see count_scale.h.
struct CountLook {
  int least = 1, most = 100;
  std::string_view tooltip = {};
};

// What a weight's row shows besides the weight (Ui::weight).
struct WeightLook {
  double reset_value = 0.0;
  double value = -1;  // what the energy adds to the objective; < 0: not known
  double share = -1;  // 0..1 of the objective; < 0: not known
  std::string_view tooltip = {};
};

struct ButtonLook {
  Icon icon{};
  bool has_icon = false;
  bool primary = false;  // filled with the accent
  bool active = false;   // a toggle that is on
  bool enabled = true;
  bool quiet = false;  // no frame until hovered
  bool small = false;  // a square as high as a line of text, its icon faint
  float width = 0;     // pixels; 0: as wide as its text; < 0: as wide as there is room
  std::string tooltip;
};

class Ui {
 public:
  explicit Ui(const Theme& theme) : theme_(theme) {}

  const Theme& theme() const { return theme_; }
  const Palette& colours() const { return theme_.colours(); }
  float px(float at_scale_one) const { return theme_.px(at_scale_one); }

  // --- Frames and records.
  void begin_frame(int frame);
  const std::map<std::string, UiRecord, std::less<>>& records() const { return records_; }
  // The record of the present frame, or null.
  const UiRecord* find(std::string_view path) const;
  // Scrolls the control of that path into view when it is drawn next.
  void want_visible(std::string path) { wanted_ = std::move(path); }
  // A gesture waits for time to pass (the wheel over a slider): the window must not sleep for long.
  bool waiting() const { return wheel_id_ != 0; }

  // The part of the path before the name: one per panel.
  class Scope {
   public:
    Scope(Ui& ui, std::string_view name) : ui_(ui), previous_(ui.prefix_) {
      ui.prefix_ = std::string(name) + "/";
    }
    ~Scope() { ui_.prefix_ = previous_; }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    Ui& ui_;
    std::string previous_;
  };
  void record(std::string_view name, ImVec2 min, ImVec2 max, bool enabled = true, float travel_left = 0,
              float travel_right = 0, float knob = 0);
  void record_item(std::string_view name, bool enabled = true);

  // --- Controls. `name` is the record's name and the identity; `label` is what is read.
  bool button(std::string_view name, std::string_view label, const ButtonLook& look = {});
  bool segmented(std::string_view name, std::span<const std::string> labels, int& current,
                 std::span<const std::string> tooltips = {});
  bool checkbox(std::string_view name, std::string_view label, bool& value, std::string_view tooltip = {});
  // A box with a dash: some of what it stands for is on, some is not. A press asks for all.
  bool checkbox_mixed(std::string_view name, std::string_view label, bool& value, bool mixed);
  // An empty label leaves the whole line to the list.
  bool choice(std::string_view name, std::string_view label, std::span<const std::string> items, int& current,
              std::string_view tooltip = {}, std::span<const std::string> item_tooltips = {});
  // A length with its unit: drag, wheel, or ctrl-click and type; double click resets to 0.
  Edit length(std::string_view name, std::string_view label, double& value, double per_pixel,
              std::string_view unit, std::string_view tooltip = {});
  // A number in a field of its own, used like length(); values of at least kNoLimit are "none".
  Edit quantity(std::string_view name, double& value, const QuantityLook& look);
  // Likewise, with a label before the field.
  Edit quantity_row(std::string_view name, std::string_view label, double& value, const QuantityLook& look);
  // A slider under its label and number: drag, wheel, ctrl-click or a click on the number types. What is
  // typed may lie outside the slider's range, but not below 1.
  Edit count(std::string_view name, std::string_view label, int& value, const CountLook& look);
  // See weight_scale.h: drag, wheel, double click or the small button resets, ctrl-click (or a click on the
  // number) types. Two columns: weight over slider, what it adds to the objective over the share's bar.
  Edit weight(std::string_view name, std::string_view label, double& value, const WeightLook& look);
  float weight_share_width() const { return px(62); }
  // A "?" that explains what stands before it; the cursor stays on the line.
  void help(std::string_view name, std::string_view text);
  // A heading that opens and closes what follows; `summary` stands at its end.
  bool section(std::string_view name, std::string_view title, bool open_at_first = true,
               std::string_view summary = {}, ImU32 summary_colour = 0);
  // A pill that is on or off, with a dot; goes on to the right of the one before, or in the next line where
  // that would pass `right`.
  bool chip(const std::string& name, const std::string& label, bool on, ImU32 dot, float right, bool first);
  bool selectable(std::string_view name, std::string_view label, bool selected);

  // --- Texts.
  void text(std::string_view text, ImU32 colour = 0);
  void small_text(std::string_view text, ImU32 colour = 0);
  void wrapped(std::string_view text, ImU32 colour = 0, bool small = false);
  void heading(std::string_view text);
  // Label left, value right-aligned at the edge of the panel.
  void value_row(std::string_view label, std::string_view value, ImU32 value_colour = 0,
                 std::string_view tooltip = {});
  void separator();
  void gap(float at_scale_one = 6);
  void tooltip_if_hovered(std::string_view text) const;
  void tooltip(std::string_view text) const;

  float label_width() const { return px(92); }

 private:
  void label_cell(std::string_view label, std::string_view tooltip);
  bool typing(ImGuiID id) const { return typing_id_ == id; }
  void begin_typing(ImGuiID id, double value);
  // Draws the text field in the given rectangle; true when the value is final. none: what an empty text
  // means, 0 for nothing.
  bool typing_field(const char* id_text, ImVec2 position, float width, double& value, bool& changed,
                    double none = 0.0);
  void draw_help(ImVec2 middle, bool hovered) const;
  // The wheel's notches over an item, mostly 0. A pause after them, or the mouse going away, finishes the
  // edit.
  double wheel_notches(ImGuiID id, bool hovered, Edit& edit);
  // A line from `left` to `right` at height y, as far as `at` filled, and the knob there.
  void draw_slider(float left, float right, float y, float at, bool filled, bool held, ImU32 rim) const;
  float knob_radius() const { return px(5); }

  const Theme& theme_;
  std::map<std::string, UiRecord, std::less<>> records_;
  std::string prefix_;
  std::string wanted_;
  int frame_ = 0;

  ImGuiID typing_id_ = 0;
  bool typing_begins_ = false;
  char typed_[64] = {};
  ImGuiID wheel_id_ = 0;
  double wheel_time_ = 0;
  double drag_carry_ = 0;
};

// Scrolls the present window so that a row of a list is in its middle, where it is out of sight. row: its
// number.
void bring_row_into_sight(int row, float row_height);

// Text drawn into a rectangle: 0 left, 0.5 centred, 1 right.
void draw_text_aligned(ImDrawList& draw, ImFont* font, ImVec2 min, ImVec2 max, float align, ImU32 colour,
                       std::string_view text);
// The text shortened with … to fit.
std::string elided(ImFont* font, std::string_view text, float width);
// Likewise, but its end stays.
std::string elided_left(ImFont* font, std::string_view text, float width);

}  // namespace planewright::ui
