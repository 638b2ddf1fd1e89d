// TextScanner: walks over a text in memory, token by token, and knows the line. For readers of text files.
//
// Tokens are separated by blanks and line ends ("\n", "\r\n" or "\r"); they are views into the content.
// Numbers are read independently of the locale.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace planewright {

struct ScannerRules {
  bool hash_comments = false;  // a token that begins with '#' is a comment up to the end of the line
  bool continuation = false;   // '\' at the end of a line joins it with the next one
};

class TextScanner {
 public:
  TextScanner(std::string_view content, std::string name, ScannerRules rules = {})
      : content_(content), name_(std::move(name)), rules_(rules) {}

  // The next token of this line; empty at the end of the line.
  std::string_view token_in_line();
  // The next token, in this line or a later one; empty at the end of the text.
  std::string_view token();
  // Moves past the end of this line.
  void skip_line();
  // Whether no token is left in the whole text.
  bool at_end();

  // Bytes from here to the end, and what has been passed.
  size_t remaining() const { return content_.size() - position_; }
  size_t position() const { return position_; }
  const std::string& name() const { return name_; }

  // "roof.obj:14": the line of the last token that was read.
  std::string where() const { return where(token_line_); }
  std::string where(int line) const { return name_ + ":" + std::to_string(line); }
  int token_line() const { return token_line_; }

  // An error of the file at the last token.
  tl::unexpected<Error> error(std::string what, std::string remedy) const {
    return fail(ErrorCode::Unreadable, std::move(what), where(), std::move(remedy));
  }

 private:
  bool at_line_end() const;
  void skip_blanks();

  std::string_view content_;
  std::string name_;
  ScannerRules rules_;
  size_t position_ = 0;
  int line_ = 1;
  int token_line_ = 1;
};

// The whole token as a number: nothing if it is not one; infinite if it is too large for a double.
std::optional<double> to_number(std::string_view token);
// The whole token as an integer; beyond long long it becomes the nearest long long.
std::optional<long long> to_integer(std::string_view token);

// A coordinate from a token, or why it is none.
Result<double> read_coordinate(const TextScanner& scanner, std::string_view token);

// A token for an error message: in quotes, short, printable.
std::string in_quotes(std::string_view token);

bool equal_ignoring_case(std::string_view a, std::string_view b);

}  // namespace planewright
