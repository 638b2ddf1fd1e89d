#include "ui/script.h"

#include <array>
#include <charconv>
#include <limits>
#include <sstream>
#include <string_view>

#include "core/base/atomic_file.h"

namespace planewright::ui {
namespace {

struct Form {
  std::string_view name;
  std::size_t least, most;  // words after the name
};
constexpr std::size_t kAny = std::numeric_limits<std::size_t>::max();
constexpr std::array kForms = {
    Form{"open", 1, 1},          Form{"drop", 1, 1},          Form{"sample", 1, 2},
    Form{"wait_loaded", 1, 1},   Form{"wait_solved", 1, 1},   Form{"wait_solving", 1, 1},
    Form{"wait_rated", 1, 1},    Form{"wait_iterates", 2, 2}, Form{"wait_frames", 1, 1},
    Form{"click", 1, 1},         Form{"ctrl_click", 1, 1},    Form{"double_click", 1, 1},
    Form{"hover", 1, 1},         Form{"wheel", 2, 2},         Form{"drag", 2, 2},
    Form{"press", 1, 1},         Form{"move", 2, 2},          Form{"release", 0, 0},
    Form{"drag_by", 3, 3},       Form{"click_edge", 1, 1},    Form{"hover_edge", 1, 1},
    Form{"context_edge", 1, 1},  Form{"click_model", 2, 2},   Form{"click_panel", 1, 2},
    Form{"click_corner", 1, 2},  Form{"drag_pin", 3, 3},      Form{"drag_box", 4, 5},
    Form{"hover_model", 2, 2},   Form{"orbit", 2, 2},         Form{"pan", 2, 2},
    Form{"zoom", 1, 1},          Form{"key", 1, 1},           Form{"type", 1, 1},
    Form{"export", 1, 1},        Form{"screenshot", 1, 1},    Form{"expect", 3, 3},
    Form{"remember", 2, 2},      Form{"print", 0, kAny},      Form{"dump_ui", 0, 0},
    Form{"clear_timings", 0, 0}, Form{"click_region", 1, 2},  Form{"hover_region", 1, 1},
    Form{"click_border", 2, 2},  Form{"drag_region", 2, 2},   Form{"wait_export", 1, 1},
    Form{"click_border", 2, 2},  Form{"drag_region", 2, 2},   Form{"shift_click", 1, 1},
};

}  // namespace

Result<Script> parse_script(const std::string& text, const std::string& name) {
  Script script;
  script.name = name;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const std::string where = name + ":" + std::to_string(number);
    ScriptCommand command;
    command.line = number;
    bool quoted = false, in_word = false;
    for (const char c : line) {
      if (c == '"') {
        if (!quoted && !in_word) command.words.emplace_back();
        quoted = !quoted;
        in_word = true;
      } else if (!quoted && (c == ' ' || c == '\t' || c == '\r')) {
        in_word = false;
      } else if (!quoted && c == '#') {
        break;
      } else {
        if (!in_word) command.words.emplace_back();
        in_word = true;
        command.words.back() += c;
      }
    }
    if (quoted) return fail(ErrorCode::Usage, "a quote is not closed", where);
    if (command.words.empty()) continue;
    const Form* form = nullptr;
    for (const Form& f : kForms) {
      if (f.name == command.words[0]) form = &f;
    }
    if (form == nullptr)
      return fail(ErrorCode::Usage, "there is no command '" + command.words[0] + "'", where);
    const std::size_t given = command.words.size() - 1;
    if (given < form->least || given > form->most) {
      return fail(ErrorCode::Usage, "'" + command.words[0] + "' takes another number of words", where);
    }
    script.commands.push_back(std::move(command));
  }
  return script;
}

Result<Script> load_script(const std::filesystem::path& path) {
  return read_file(path).and_then([&](const std::string& text) { return parse_script(text, path.string()); });
}

std::optional<double> number_in(const std::string& word) {
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

}  // namespace planewright::ui
