#include "ui/test_driver.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <sstream>
#include <utility>

#include "ui/layer_edits.h"

namespace planewright::ui {
namespace {

using namespace std::chrono_literals;

constexpr int kPatience = 120;  // frames that a control may take to appear

bool holds(const std::string& found, const std::string& op, const std::string& wanted, bool& known) {
  known = true;
  if (op == "contains") return found.find(wanted) != std::string::npos;
  const auto a = number_in(found), b = number_in(wanted);
  const auto compare = [&](const auto& x, const auto& y) {
    if (op == "==") return x == y;
    if (op == "!=") return x != y;
    if (op == "<") return x < y;
    if (op == "<=") return x <= y;
    if (op == ">") return x > y;
    if (op == ">=") return x >= y;
    known = false;
    return false;
  };
  return a && b ? compare(*a, *b) : compare(found, wanted);
}

// "Ctrl+Shift+Z" -> key
std::optional<KeyPress> parse_key(const std::string& text) {
  KeyPress press;
  std::string rest = text;
  const auto take = [&](const std::string& prefix) {
    if (!rest.starts_with(prefix)) return false;
    rest.erase(0, prefix.size());
    return true;
  };
  for (;;) {
    if (take("Ctrl+")) {
      press.ctrl = true;
    } else if (take("Shift+")) {
      press.shift = true;
    } else {
      break;
    }
  }
  static const std::map<std::string, int> kNamed = {{"Space", GLFW_KEY_SPACE},
                                                    {"Escape", GLFW_KEY_ESCAPE},
                                                    {"Enter", GLFW_KEY_ENTER},
                                                    {"Home", GLFW_KEY_HOME},
                                                    {"F1", GLFW_KEY_F1},
                                                    {"Up", GLFW_KEY_UP},
                                                    {"Down", GLFW_KEY_DOWN},
                                                    {"PageUp", GLFW_KEY_PAGE_UP},
                                                    {"PageDown", GLFW_KEY_PAGE_DOWN},
                                                    {"Tab", GLFW_KEY_TAB},
                                                    {"Backspace", GLFW_KEY_BACKSPACE}};
  if (const auto named = kNamed.find(rest); named != kNamed.end()) {
    press.key = named->second;
  } else if (rest == "+" || rest == "-") {
    press.key = rest == "+" ? GLFW_KEY_KP_ADD : GLFW_KEY_KP_SUBTRACT;
  } else if (rest.size() == 1 && ((rest[0] >= 'A' && rest[0] <= 'Z') || (rest[0] >= '0' && rest[0] <= '9'))) {
    press.key = rest[0];
  } else {
    return std::nullopt;
  }
  return press;
}

std::u32string decode(const std::string& utf8) {
  std::u32string out;
  for (std::size_t i = 0; i < utf8.size();) {
    const auto lead = static_cast<unsigned char>(utf8[i]);
    const std::size_t length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    char32_t code = length == 1 ? lead : lead & (0xFFu >> (length + 1));
    for (std::size_t k = 1; k < length && i + k < utf8.size(); ++k) {
      code = (code << 6) | (static_cast<unsigned char>(utf8[i + k]) & 0x3Fu);
    }
    out += code;
    i += length;
  }
  return out;
}

}  // namespace

// --- Input -----------------------------------------------------------------------------------

void TestDriver::push(Input input, int frames) {
  inputs_.push_back(std::move(input));
  for (int i = 1; i < frames; ++i) inputs_.emplace_back();
}

HeldKeys TestDriver::held_in(const std::string& text) {
  const auto named = [&](const char* key) { return text.find(key) != std::string::npos; };
  return {named("Ctrl"), named("Shift"), named("Alt")};
}

void TestDriver::click_at(ImVec2 at, HeldKeys held, bool twice) {
  push({.mouse = at, .ctrl = held.ctrl, .shift = held.shift, .alt = held.alt}, 2);
  push({.left = true}, 2);
  push({.left = false});
  if (twice) {
    push({.left = true, .double_clicks = true}, 2);
    push({.left = false});
  }
  push({.ctrl = false, .shift = false, .alt = false, .double_clicks = false}, 2);
}

void TestDriver::right_click_at(ImVec2 at) {
  push({.mouse = at}, 2);
  push({.right = true}, 2);
  push({.right = false}, 3);
}

void TestDriver::drag_line(ImVec2 from, ImVec2 to, bool middle, HeldKeys held) {
  constexpr int kSteps = 10;
  push({.mouse = from, .ctrl = held.ctrl, .shift = held.shift, .alt = held.alt}, 2);
  Input down, up;
  (middle ? down.middle : down.left) = true;
  (middle ? up.middle : up.left) = false;
  push(down, 2);
  for (int i = 1; i <= kSteps; ++i) {
    const float t = static_cast<float>(i) / kSteps;
    push({.mouse = ImVec2(from.x + t * (to.x - from.x), from.y + t * (to.y - from.y))});
  }
  push({}, 2);
  push(up, 2);
  push({.ctrl = false, .shift = false, .alt = false}, 1);
}

void TestDriver::inject(ImGuiIO& io) {
  io.ConfigInputTextCursorBlink = false;  // pictures of the same state are the same
  pressed_.clear();
  typed_.clear();
  if (key_down_) {
    io.KeysDown[*key_down_] = false;
    key_down_.reset();
    ctrl_ = shift_ = false;
  }
  if (!inputs_.empty()) {
    const Input input = std::move(inputs_.front());
    inputs_.pop_front();
    if (input.mouse) mouse_ = *input.mouse;
    left_ = input.left.value_or(left_);
    right_ = input.right.value_or(right_);
    middle_ = input.middle.value_or(middle_);
    ctrl_ = input.ctrl.value_or(ctrl_);
    shift_ = input.shift.value_or(shift_);
    alt_ = input.alt.value_or(alt_);
    double_clicks_ = input.double_clicks.value_or(double_clicks_);
    io.MouseWheel = input.wheel;
    if (input.key) {
      pressed_.push_back(*input.key);
      io.KeysDown[input.key->key] = true;
      key_down_ = input.key->key;
      ctrl_ = input.key->ctrl;
      shift_ = input.key->shift;
    }
    typed_ = decode(input.text);
    for (const char32_t c : typed_) io.AddInputCharacter(static_cast<unsigned>(c));
  }
  io.MousePos = mouse_;
  io.MouseDown[0] = left_;
  io.MouseDown[1] = right_;
  io.MouseDown[2] = middle_;
  io.KeyCtrl = ctrl_;
  io.KeyShift = shift_;
  io.KeyAlt = alt_;
  io.KeySuper = false;
  // Two clicks are a double click when the script says so, however long frames take.
  io.MouseDoubleClickTime = double_clicks_ ? 10.0f : 0.0f;
}

// --- Commands --------------------------------------------------------------------------------

void TestDriver::fail_with(const std::string& what) {
  if (!failure_) failure_ = script_.name + ":" + std::to_string(line_) + ": " + what;
}

double TestDriver::number(const std::string& word) {
  const auto value = number_in(expanded(word));
  if (!value) fail_with("'" + word + "' is not a number");
  return value.value_or(0.0);
}

std::string TestDriver::expanded(const std::string& word) const {
  std::string out = word;
  // $NAME, alone or inside a word ("edge.$edge").
  for (auto at = out.find('$'); at != std::string::npos; at = out.find('$', at + 1)) {
    for (const auto& [name, value] : remembered_) {
      if (out.compare(at + 1, name.size(), name) == 0 && at + 1 + name.size() == out.size()) {
        return out.substr(0, at) + value;
      }
    }
  }
  return out;
}

void TestDriver::wait(std::string what, double seconds, std::function<bool(const DriverContext&, int)> over) {
  const auto limit =
      std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(seconds));
  waiting_ = Waiting{std::move(over), std::chrono::steady_clock::now() + limit, std::move(what)};
}

const UiRecord* TestDriver::control(const std::string& path, const DriverContext& context) {
  const UiRecord* record = context.ui.find(path);
  if (record != nullptr && record->clickable) {
    looked_for_ = 0;
    return record;
  }
  // Not there yet, or scrolled out of sight: ask for it and look again in the next frame.
  context.ui.want_visible(path);
  if (++looked_for_ > kPatience) {
    fail_with(record == nullptr ? "there is no control '" + path + "'"
                                : "the control '" + path + "' is out of sight");
    looked_for_ = 0;
  }
  return nullptr;
}

std::optional<ImVec2> TestDriver::find_edge(const std::string& which, const DriverContext& context) {
  const AppState& state = context.state;
  if (!state.mesh_view()) {
    fail_with("there is no mesh");
    return std::nullopt;
  }
  const bool flagged = which == "flagged", stuck = which == "stuck";
  if (which != "any" && !flagged && !stuck) {
    const int edge = static_cast<int>(number(which));
    const auto at = context.viewport.clickable_place_of_edge(state, edge);
    if (!at) fail_with("edge " + which + " cannot be clicked in this view");
    remembered_["edge"] = which;
    return at;
  }
  // The flippable edge (stuck: one that is not) that is nearest to the middle of the view.
  const auto& view = *state.mesh_view();
  const auto& camera = context.viewport.camera();
  std::vector<std::pair<float, int>> candidates;
  for (int e = 0; e < static_cast<int>(view.edges.size()); ++e) {
    if (view.mesh->can_flip(e) == stuck) continue;
    if (flagged && state.finding_list().find_flagged(e) == nullptr) continue;
    const auto [a, b] = view.edges[static_cast<std::size_t>(e)];
    const glm::vec2 at = camera.project(0.5 * (view.points.row(a) + view.points.row(b)).transpose());
    candidates.emplace_back(std::hypot(at.x - 0.5f * static_cast<float>(camera.width()),
                                       at.y - 0.5f * static_cast<float>(camera.height())),
                            e);
  }
  std::sort(candidates.begin(), candidates.end());
  constexpr std::size_t kTries = 200;
  for (std::size_t i = 0; i < std::min(candidates.size(), kTries); ++i) {
    if (const auto at = context.viewport.clickable_place_of_edge(state, candidates[i].second)) {
      remembered_["edge"] = std::to_string(candidates[i].second);
      return at;
    }
  }
  fail_with("no edge of this view can be clicked");
  return std::nullopt;
}

std::optional<ImVec2> TestDriver::find_element(const std::string& kind, const std::string& which,
                                               const DriverContext& context) {
  const AppState& state = context.state;
  const auto place = [&](int index) {
    return kind == "panel" ? context.viewport.clickable_place_of_panel(state, index)
                           : context.viewport.clickable_place_of_corner(state, index);
  };
  if (which != "any") {
    const auto at = place(static_cast<int>(number(which)));
    if (!at) fail_with(kind + " " + which + " cannot be clicked in this view");
    remembered_[kind] = which;
    return at;
  }
  if (!state.shown()) {
    fail_with("there are no panels");
    return std::nullopt;
  }
  // The one nearest to the middle of the view.
  const TangentComplex& complex = state.shown()->complex();
  const Points& points = state.shown()->points;
  const auto& camera = context.viewport.camera();
  const glm::vec2 middle(0.5f * static_cast<float>(camera.width()),
                         0.5f * static_cast<float>(camera.height()));
  std::vector<std::pair<float, int>> candidates;
  const int count = kind == "panel" ? complex.plane_count() : complex.point_count();
  for (int i = 0; i < count; ++i) {
    if (kind == "panel" && complex.panels[i].empty()) continue;
    const Vector3d at =
        kind == "panel" ? centroid(points, complex.panels[i]) : Vector3d(points.row(i).transpose());
    const glm::vec2 away = camera.project(at) - middle;
    candidates.emplace_back(std::hypot(away.x, away.y), i);
  }
  std::sort(candidates.begin(), candidates.end());
  for (std::size_t i = 0; i < std::min<std::size_t>(candidates.size(), 100); ++i) {
    if (const auto at = place(candidates[i].second)) {
      remembered_[kind] = std::to_string(candidates[i].second);
      return at;
    }
  }
  fail_with("no " + kind + " of this view can be clicked");
  return std::nullopt;
}

std::optional<std::filesystem::path> TestDriver::take_screenshot_request() {
  return std::exchange(screenshot_, std::nullopt);
}

void TestDriver::step(const DriverContext& context, int frame) {
  for (const KeyPress& key : pressed_) context.press_key(key);
  for (const char32_t c : typed_) context.type_character(c);
  pressed_.clear();
  typed_.clear();
  while (!failure_ && inputs_.empty() && !screenshot_ && !context.viewport.flying()) {
    if (waiting_) {
      if (waiting_->over(context, frame)) {
        waiting_.reset();
      } else if (std::chrono::steady_clock::now() > waiting_->deadline) {
        fail_with("waited in vain " + waiting_->what);
        return;
      } else {
        return;
      }
    }
    if (next_ >= script_.commands.size()) return;
    const std::size_t before = next_;
    run(script_.commands[next_], context, frame);
    if (next_ == before) return;  // asks to be run again in the next frame
  }
}

void TestDriver::run(const ScriptCommand& command, const DriverContext& c, int frame) {
  const auto& words = command.words;
  const std::string& verb = words[0];
  line_ = command.line;
  const auto middle_of = [](const UiRecord& r) {
    return ImVec2(std::round(r.middle().x), std::round(r.middle().y));
  };
  const auto at_fraction = [](const UiRecord& r, double fraction) {
    return ImVec2(r.travel_left + static_cast<float>(fraction) * (r.travel_right - r.travel_left),
                  std::round(r.middle().y));
  };

  // Commands on a control wait for it to be there.
  static constexpr std::array kOnControls = {"click", "ctrl_click", "shift_click", "double_click", "hover",
                                             "wheel", "drag",       "press",       "move",         "drag_by"};
  const UiRecord* target = nullptr;
  if (std::find(kOnControls.begin(), kOnControls.end(), verb) != kOnControls.end()) {
    target = control(words[1], c);
    if (target == nullptr) return;
    if (!target->enabled && verb != "hover") return fail_with("the control '" + words[1] + "' is disabled");
  }
  ++next_;

  if (verb == "open") {
    c.state.open_file(expanded(words[1]));
  } else if (verb == "drop") {
    c.drop({expanded(words[1])});
  } else if (verb == "sample") {
    c.state.open_sample(words[1], words.size() > 2 ? static_cast<int>(number(words[2])) : 0);
  } else if (verb == "wait_loaded") {
    wait("for the file to be read", number(words[1]),
         [](const DriverContext& now, int) { return !now.state.loading(); });
  } else if (verb == "wait_solved") {
    wait("for the solve to end", number(words[1]),
         [](const DriverContext& now, int) { return now.state.settled(); });
  } else if (verb == "wait_rated") {
    wait("for edits to be rated", number(words[1]),
         [](const DriverContext& now, int) { return now.state.advice_fits() && now.state.advice()->done; });
  } else if (verb == "wait_export") {
    wait("for the export", number(words[1]), [](const DriverContext& now, int) {
      return !now.state.export_preparing() && !now.state.exporting_to_workshop();
    });
  } else if (verb == "wait_solving") {
    wait("for a solve to begin", number(words[1]),
         [](const DriverContext& now, int) { return now.state.solving(); });
  } else if (verb == "wait_iterates") {
    const int wanted = static_cast<int>(number(words[1]));
    wait("for " + words[1] + " iterates of a running solve", number(words[2]),
         [wanted](const DriverContext& now, int) { return now.state.iterates_before_end() >= wanted; });
  } else if (verb == "wait_frames") {
    const int until = frame + static_cast<int>(number(words[1]));
    wait("for frames", 600, [until](const DriverContext&, int now) { return now >= until; });
  } else if (verb == "click" || verb == "ctrl_click" || verb == "shift_click" || verb == "double_click") {
    click_at(middle_of(*target), HeldKeys{.ctrl = verb == "ctrl_click", .shift = verb == "shift_click"},
             verb == "double_click");
  } else if (verb == "hover") {
    push({.mouse = middle_of(*target)}, 3);
  } else if (verb == "wheel") {
    const double notches = number(words[2]);
    push({.mouse = middle_of(*target)}, 2);
    for (int i = 0; i < static_cast<int>(std::abs(notches)); ++i) push({.wheel = notches > 0 ? 1.0f : -1.0f});
    push({}, 2);
  } else if (verb == "drag") {
    drag_line(ImVec2(target->knob, std::round(target->middle().y)), at_fraction(*target, number(words[2])));
  } else if (verb == "press") {
    push({.mouse =
              ImVec2(target->knob != 0 ? target->knob : target->middle().x, std::round(target->middle().y))},
         2);
    push({.left = true}, 2);
  } else if (verb == "move") {
    push({.mouse = at_fraction(*target, number(words[2]))}, 2);
  } else if (verb == "release") {
    push({.left = false}, 2);
  } else if (verb == "drag_by") {
    const ImVec2 from = middle_of(*target);
    drag_line(from, ImVec2(from.x + static_cast<float>(number(words[2])),
                           from.y + static_cast<float>(number(words[3]))));
  } else if (verb == "click_edge" || verb == "hover_edge" || verb == "context_edge") {
    if (const auto at = find_edge(expanded(words[1]), c)) {
      if (verb == "click_edge") {
        click_at(*at);
      } else if (verb == "context_edge") {
        right_click_at(*at);
      } else {
        push({.mouse = *at}, 3);
      }
    }
  } else if (verb == "click_panel" || verb == "click_corner") {
    if (const auto at = find_element(verb.substr(6), expanded(words[1]), c)) {
      click_at(*at, words.size() > 2 ? held_in(words[2]) : HeldKeys());
    }
  } else if (verb == "click_region" || verb == "hover_region" || verb == "click_border" ||
             verb == "drag_region") {
    run_on_regions(words, c);
  } else if (verb == "drag_pin") {
    const int pin = static_cast<int>(number(words[1]));
    const auto at = c.viewport.place_of_pin(c.state, pin);
    if (!at) return fail_with("pin " + words[1] + " cannot be taken in this view");
    drag_line(*at, ImVec2(at->x + static_cast<float>(number(words[2])),
                          at->y + static_cast<float>(number(words[3]))));
  } else if (verb == "drag_box" || verb == "hover_model") {
    const UiRecord* model = c.ui.find("model");
    if (model == nullptr) return fail_with("there is no model to draw a box on");
    const auto at = [&](std::size_t word) {
      return ImVec2(
          std::round(model->min.x + static_cast<float>(number(words[word])) * (model->max.x - model->min.x)),
          std::round(model->min.y +
                     static_cast<float>(number(words[word + 1])) * (model->max.y - model->min.y)));
    };
    if (verb == "hover_model") {
      push({.mouse = at(1)}, 3);
    } else {
      drag_line(at(1), at(3), false, words.size() > 5 ? held_in(words[5]) : HeldKeys());
    }
  } else if (verb == "click_model" || verb == "orbit" || verb == "pan" || verb == "zoom") {
    const UiRecord* model = c.ui.find("model");
    if (model == nullptr) return fail_with("there is no model to click on");
    if (verb == "click_model") {
      click_at(ImVec2(model->min.x + static_cast<float>(number(words[1])) * (model->max.x - model->min.x),
                      model->min.y + static_cast<float>(number(words[2])) * (model->max.y - model->min.y)));
    } else if (verb == "zoom") {
      const double notches = number(words[1]);
      push({.mouse = middle_of(*model)}, 2);
      for (int i = 0; i < static_cast<int>(std::abs(notches)); ++i)
        push({.wheel = notches > 0 ? 1.0f : -1.0f});
      push({}, 2);
    } else {
      const ImVec2 from = middle_of(*model);
      drag_line(from,
                ImVec2(from.x + static_cast<float>(number(words[1])),
                       from.y + static_cast<float>(number(words[2]))),
                verb == "pan");
    }
  } else if (verb == "key") {
    if (words[1] == "?") {
      push({.text = "?"});
      push({}, 2);
    } else if (const auto key = parse_key(words[1])) {
      Input input;
      input.key = *key;
      push(input);
      push({}, 2);
    } else {
      fail_with("there is no key '" + words[1] + "'");
    }
  } else if (verb == "type") {
    Input input;
    input.text = expanded(words[1]);
    push(input);
    push({}, 2);
  } else if (verb == "export") {
    c.state.export_panels(expanded(words[1]));
    wait("for the export", 60, [](const DriverContext& now, int) { return !now.state.exporting(); });
  } else if (verb == "screenshot") {
    screenshot_ = expanded(words[1]);
  } else if (verb == "expect") {
    const std::string key = expanded(words[1]), wanted = expanded(words[3]);
    const auto found = state_value(c, key);
    if (!found) return fail_with("there is no value '" + key + "'");
    bool known = true;
    if (!holds(*found, words[2], wanted, known)) {
      fail_with(known ? "expected " + key + " " + words[2] + " " + wanted + ", found " + *found
                      : "there is no comparison '" + words[2] + "'");
    }
  } else if (verb == "remember") {
    const auto found = state_value(c, expanded(words[1]));
    if (!found) return fail_with("there is no value '" + words[1] + "'");
    remembered_[words[2]] = *found;
  } else if (verb == "print") {
    std::vector<std::string> keys(words.begin() + 1, words.end());
    if (keys.empty()) keys = state_keys();
    for (const std::string& key : keys) {
      std::cout << expanded(key) << " = " << state_value(c, expanded(key)).value_or("?") << "\n";
    }
    std::cout.flush();
  } else if (verb == "dump_ui") {
    UiDump::print_controls(std::cout, c);
  } else if (verb == "clear_timings") {
    c.state.timings.clear();
  }
}

// --- Dump ------------------------------------------------------------------------------------

void UiDump::print_controls(std::ostream& out, const DriverContext& c) {
  out << "controls begin\n";
  for (const auto& [path, r] : c.ui.records()) {
    if (c.ui.find(path) == nullptr) continue;
    out << "control " << std::lround(r.min.x) << ' ' << std::lround(r.min.y) << ' ' << std::lround(r.max.x)
        << ' ' << std::lround(r.max.y) << ' ' << (r.clickable ? "in-sight" : "out-of-sight") << ' '
        << (r.enabled ? "enabled" : "disabled") << ' ' << std::lround(r.knob) << ' ' << path << "\n";
  }
  // A few edges that a click would flip, nearest to the middle of the view first.
  const auto& view = c.state.mesh_view();
  if (view) {
    const auto& camera = c.viewport.camera();
    std::vector<std::pair<float, int>> candidates;
    for (int e = 0; e < static_cast<int>(view->edges.size()); ++e) {
      if (!view->mesh->can_flip(e)) continue;
      const auto [a, b] = view->edges[static_cast<std::size_t>(e)];
      const glm::vec2 at = camera.project(0.5 * (view->points.row(a) + view->points.row(b)).transpose());
      candidates.emplace_back(std::hypot(at.x - 0.5f * static_cast<float>(camera.width()),
                                         at.y - 0.5f * static_cast<float>(camera.height())),
                              e);
    }
    std::sort(candidates.begin(), candidates.end());
    int printed = 0;
    for (std::size_t i = 0; i < std::min<std::size_t>(candidates.size(), 40) && printed < 5; ++i) {
      const int edge = candidates[i].second;
      if (const auto at = c.viewport.clickable_place_of_edge(c.state, edge)) {
        out << "edge " << edge << ' ' << std::lround(at->x) << ' ' << std::lround(at->y) << "\n";
        ++printed;
      }
    }
  }
  out << "controls end\n" << std::flush;
}

void UiDump::frame(const DriverContext& c) {
  std::ostringstream controls;
  for (const auto& [path, r] : c.ui.records()) {
    if (c.ui.find(path) == nullptr) continue;
    controls << path << std::lround(r.min.x) << std::lround(r.min.y) << std::lround(r.max.x)
             << std::lround(r.max.y) << r.clickable << r.enabled << std::lround(r.knob);
  }
  controls << state_value(c, "camera").value_or("") << state_value(c, "revision").value_or("");
  still_ = controls.str() == controls_ ? still_ + 1 : 0;
  controls_ = controls.str();
  constexpr int kRest = 3;
  if (still_ >= kRest && controls_ != printed_controls_) {
    printed_controls_ = controls_;
    print_controls(out_, c);
  }
  std::ostringstream line;
  line << "state";
  for (const char* key : {"document",       "revision", "ticket",   "solving", "settled",
                          "status",         "asked",    "polished", "badge",   "iterates_before_end",
                          "weight.fairing", "undo",     "camera",   "colours", "messages_posted",
                          "hovered_edge",   "mode",     "regions",  "tool",    "hovered_region"}) {
    line << ' ' << key << "=\"" << state_value(c, key).value_or("?") << '"';
  }
  if (line.str() != printed_state_) {
    printed_state_ = line.str();
    out_ << printed_state_ << "\n" << std::flush;
  }
}

}  // namespace planewright::ui
