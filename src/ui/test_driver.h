// TestDriver: plays a Script on the real window. Its mouse and keys go in where the real ones do, right after
// the backend's new frame; its expectations read the same state that the panels show.
//
// UiDump: prints where every control stands, and what the design is at, for tests that drive the window from
// outside with a real mouse.
//
// Threads: the window's.
#pragma once

#include <imgui.h>

#include <array>
#include <chrono>
#include <deque>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ui/actions.h"
#include "ui/app_state.h"
#include "ui/script.h"
#include "ui/viewport.h"
#include "ui/widgets.h"
#include "ui/window_state.h"

namespace planewright::ui {

// What a script reaches.
struct DriverContext {
  AppState& state;
  WindowState& window;
  Ui& ui;
  Viewport& viewport;
  Actions& actions;
  std::function<void(const std::vector<std::filesystem::path>&)>
      drop;                                        // as if files were dropped on the window
  std::function<void(const KeyPress&)> press_key;  // as if a key went down
  std::function<void(char32_t)> type_character;
};

// The value that `expect` and `print` know by this name, or nothing.
std::optional<std::string> state_value(const DriverContext& context, const std::string& key);
// The keys that a dump of the whole state lists.
const std::vector<std::string>& state_keys();

// Keys that are held during a gesture of a script.
struct HeldKeys {
  bool ctrl = false, shift = false, alt = false;
};

class TestDriver {
 public:
  explicit TestDriver(Script script) : script_(std::move(script)) {}

  // Right after the backend's new frame: overwrites the input with the script's.
  void inject(ImGuiIO& io);
  // After a frame was drawn: runs commands until one has to wait. `frame`: the running number of the frame.
  void step(const DriverContext& context, int frame);

  // Nothing to feed in: a wait for a worker may sleep a little, so that the worker has the machine.
  bool idle() const { return inputs_.empty() && waiting_.has_value(); }
  bool done() const {
    return failure_ || (next_ >= script_.commands.size() && inputs_.empty() && !waiting_ && !screenshot_);
  }
  // "script.txt:12: expected ..., found ..."; nothing as long as all is well.
  const std::optional<std::string>& failure() const { return failure_; }
  // A picture of the window to take before the buffers are swapped.
  std::optional<std::filesystem::path> take_screenshot_request();

 private:
  struct Input {  // of one frame, on top of the one before
    std::optional<ImVec2> mouse = {};
    std::optional<bool> left = {}, right = {}, middle = {};
    std::optional<bool> ctrl = {}, shift = {}, alt = {};
    std::optional<bool> double_clicks = {};
    float wheel = 0;
    std::optional<KeyPress> key = {};
    std::string text = {};
  };
  struct Waiting {
    std::function<bool(const DriverContext&, int frame)> over;
    std::chrono::steady_clock::time_point deadline;
    std::string what;
  };

  void run(const ScriptCommand& command, const DriverContext& context, int frame);
  void fail_with(const std::string& what);
  void push(Input input, int frames = 1);
  static HeldKeys held_in(const std::string& text);
  void click_at(ImVec2 at, HeldKeys held = {}, bool twice = false);
  void right_click_at(ImVec2 at);
  void drag_line(ImVec2 from, ImVec2 to, bool middle = false, HeldKeys held = {});
  // A panel ("panel") or a corner ("corner") that can be clicked, as the script names it.
  std::optional<ImVec2> find_element(const std::string& kind, const std::string& which,
                                     const DriverContext& context);
  std::optional<ImVec2> find_edge(const std::string& which, const DriverContext& context);
  std::optional<ImVec2> find_region(const std::string& which, const DriverContext& context);
  // A place of a region beside $region, or of the border between the two.
  std::optional<ImVec2> find_neighbour(const std::string& which, bool border, const DriverContext& context);
  void run_on_regions(const std::vector<std::string>& words, const DriverContext& context);
  const UiRecord* control(const std::string& path, const DriverContext& context);
  void wait(std::string what, double seconds, std::function<bool(const DriverContext&, int frame)> over);
  double number(const std::string& word);
  std::string expanded(const std::string& word) const;

  Script script_;
  std::size_t next_ = 0;
  int line_ = 0;
  std::deque<Input> inputs_;
  std::optional<Waiting> waiting_;
  std::optional<std::string> failure_;
  std::optional<std::filesystem::path> screenshot_;
  std::map<std::string, std::string> remembered_;

  // The held input.
  ImVec2 mouse_{-1000, -1000};
  bool left_ = false, right_ = false, middle_ = false, ctrl_ = false, shift_ = false, alt_ = false,
       double_clicks_ = false;
  std::optional<int> key_down_;
  std::vector<KeyPress> pressed_;
  std::u32string typed_;
  int looked_for_ = 0;  // frames that the present control was not there
};

class UiDump {
 public:
  explicit UiDump(std::ostream& out) : out_(out) {}
  // Prints the controls when they have moved and come to rest, and the state when it has changed.
  void frame(const DriverContext& context);
  static void print_controls(std::ostream& out, const DriverContext& context);

 private:
  std::ostream& out_;
  std::string controls_, printed_controls_, printed_state_;
  int still_ = 0;
};

}  // namespace planewright::ui
