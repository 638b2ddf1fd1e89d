// Runs the real planewright-cli and catches what it says.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/temporary_folder.h"

namespace planewright::test {

struct Ended {
  int status = -1;  // exit status; -1: ended by a signal
  std::string out, err;
};

inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

class CommandLineTest : public testing::Test {
 protected:
  // before: what the shell does first, "ulimit -f 1;".
  Ended run(const std::vector<std::string>& arguments, const std::string& before = {}) const {
    std::ostringstream command;
    command << before << quoted(PLANEWRIGHT_CLI_BINARY);
    for (const std::string& argument : arguments) command << ' ' << quoted(argument);
    command << " > " << quoted((streams_ / "out").string()) << " 2> " << quoted((streams_ / "err").string());
    const int status = std::system(command.str().c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(streams_ / "out"),
            text_of(streams_ / "err")};
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
  nlohmann::json json(const std::string& name) const {
    return nlohmann::json::parse(text_of(folder_ / name));
  }
  // Writes a sample and returns its path.
  std::string sample(const std::string& name, int panels) const {
    const std::string file = path(name + "-input.obj");
    const Ended made = run({"sample", name, "--panels", std::to_string(panels), "-o", file});
    EXPECT_EQ(made.status, 0) << made.err;
    return file;
  }
  int files() const {
    using Iterator = std::filesystem::directory_iterator;
    return static_cast<int>(std::distance(Iterator(folder_.path()), Iterator()));
  }

  TemporaryFolder folder_;

 private:
  static std::string quoted(const std::string& text) {
    std::string out(1, '\'');
    for (const char c : text) {
      if (c == '\'')
        out += "'\\''";
      else
        out += c;
    }
    return out += '\'';
  }
  TemporaryFolder streams_;
};

// A refusal: this status, nothing on stdout, and a message that says all of these.
inline void expect_refusal(const Ended& ended, int status, const std::vector<std::string>& saying) {
  EXPECT_EQ(ended.status, status) << ended.err;
  EXPECT_EQ(ended.out, "");
  for (const std::string& words : saying)
    EXPECT_NE(ended.err.find(words), std::string::npos) << "'" << words << "' is not in: " << ended.err;
}

}  // namespace planewright::test
