#include "core/edit/json_text.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace planewright {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kWidth = 110;      // of a line of numbers
constexpr size_t kShortObject = 4;  // members, of an object that is written in one line

bool is_flat(const Json& json) {
  return std::all_of(json.begin(), json.end(), [](const Json& entry) { return entry.is_primitive(); });
}

class Writer {
 public:
  void value(const Json& json, size_t indent) {
    if (json.is_object())
      object(json, indent);
    else if (json.is_array())
      array(json, indent);
    else
      primitive(json);
  }
  Result<std::string> take() {
    if (error_) return tl::unexpected(std::move(*error_));
    return std::move(text_);
  }

 private:
  struct Step {
    const std::string* key;  // null: an entry of a list
    size_t index;
  };

  void object(const Json& json, size_t indent) {
    const bool in_one_line = json.size() <= kShortObject && is_flat(json);
    text_ += '{';
    bool first = true;
    for (auto member = json.begin(); member != json.end(); ++member) {
      if (!first) text_ += in_one_line ? ", " : ",";
      first = false;
      if (!in_one_line) new_line(indent + 2);
      place_.push_back({&member.key(), 0});
      string(member.key());
      text_ += ": ";
      value(*member, indent + 2);
      place_.pop_back();
    }
    if (!in_one_line) new_line(indent);
    text_ += '}';
  }

  void array(const Json& json, size_t indent) {
    const bool flat = is_flat(json);
    size_t line_begin = text_.size();
    text_ += '[';
    for (size_t k = 0; k < json.size(); ++k) {
      if (k > 0) text_ += ',';
      if (!flat || (k > 0 && text_.size() - line_begin > kWidth)) {
        new_line(indent + 2);
        line_begin = text_.size();
      } else if (k > 0) {
        text_ += ' ';
      }
      place_.push_back({nullptr, k});
      value(json[k], indent + 2);
      place_.pop_back();
    }
    if (!flat) new_line(indent);
    text_ += ']';
  }

  void primitive(const Json& json) {
    if (json.is_string()) return string(json.get_ref<const std::string&>());
    if (json.is_number_float() && !std::isfinite(json.get<double>()))
      return refuse("the number is not finite", "Correct it; a project holds finite numbers alone");
    text_ += json.dump();
  }

  void string(const std::string& text) {
    try {
      text_ += Json(text).dump();
    } catch (const Json::type_error&) {
      refuse("the text is not UTF-8", "Rename what it names, with letters that every system can read");
    }
  }

  void new_line(size_t indent) {
    text_ += '\n';
    text_.append(indent, ' ');
  }

  void refuse(std::string what, std::string remedy) {
    if (error_) return;
    std::string where;
    for (const Step& step : place_) {
      if (step.key) {
        if (!where.empty()) where += '.';
        where += *step.key;
      } else {
        where += '[';
        where += std::to_string(step.index);
        where += ']';
      }
    }
    error_ = Error{ErrorCode::Refused, std::move(what), std::move(where), std::move(remedy)};
  }

  std::string text_;
  std::vector<Step> place_;
  std::optional<Error> error_;
};

std::string at_line(std::string_view text, const std::string& name, size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  return name + ":" + std::to_string(1 + std::count(text.begin(), end, '\n'));
}

// "[json.exception.parse_error.101] parse error at line 3, column 5: syntax error while ..." without what
// only the parser's author needs.
std::string reason(std::string_view message) {
  for (const std::string_view before : {"] ", "parse error at line "}) {
    if (const size_t at = message.find(before); at != message.npos)
      message.remove_prefix(at + (before == "] " ? before.size() : 0));
  }
  if (message.starts_with("parse error"))
    if (const size_t colon = message.find(": "); colon != message.npos) message.remove_prefix(colon + 2);
  return std::string(message);
}

// JSON knows neither, but many programs write them.
bool is_not_a_number(std::string_view text, size_t byte) {
  std::string near(text.substr(byte > 3 ? byte - 3 : 0, 8));
  std::transform(near.begin(), near.end(), near.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return near.find("nan") != near.npos || near.find("inf") != near.npos;
}

}  // namespace

Result<std::string> json_text(const Json& json) {
  Writer writer;
  writer.value(json, 0);
  return writer.take().map([](std::string&& text) { return std::move(text) + "\n"; });
}

Result<nlohmann::json> parse_json(std::string_view text, const std::string& name) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& wrong) {
    // `byte` counts from 1 and is the last one that was read, or one more at the end.
    const size_t byte = wrong.byte > 0 ? wrong.byte - 1 : 0;
    if (byte < text.size() && is_not_a_number(text, byte))
      return fail(ErrorCode::Unreadable, "a number is NaN or infinite", at_line(text, name, byte),
                  "Give a finite number");
    return fail(ErrorCode::Unreadable, "the file is no JSON: " + reason(wrong.what()),
                at_line(text, name, byte),
                byte >= text.size() ? "The file ends early: take it from a backup, or save it again"
                                    : "Correct the line, or take the file from a backup");
  } catch (const nlohmann::json::out_of_range& wrong) {  // "number overflow parsing '1e999'"
    const std::string message = reason(wrong.what());
    const size_t open = message.find('\''), close = message.rfind('\'');
    const size_t byte = open < close ? text.find(message.substr(open + 1, close - open - 1)) : text.npos;
    return fail(ErrorCode::Unreadable, "a number is too large for a double: " + message,
                byte == text.npos ? name : at_line(text, name, byte), "Give a finite number");
  }
}

}  // namespace planewright
