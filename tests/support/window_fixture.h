// WindowTest: starts the real window, plays a script in it (ui/script.h), and gives back what it printed.
//
// Needs a display: the present one, or a virtual one by Xvfb; without either the tests are skipped and say
// so. The pictures that scripts take are left in the build folder, ui_pictures/, for people to look at.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

namespace planewright {

struct Playback {
  int status = -1;
  std::string output;  // of both streams
};

// A virtual display for as long as the object lives; does nothing where there is one already.
class VirtualDisplay {
 public:
  VirtualDisplay() {
    int ends[2];
    if (std::getenv("DISPLAY") != nullptr || pipe(ends) != 0) return;
    server_ = fork();
    if (server_ == 0) {
      close(ends[0]);
      const int nothing = open("/dev/null", O_WRONLY);
      dup2(nothing, 1);
      dup2(nothing, 2);
      const std::string number = std::to_string(ends[1]);
      execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "1600x1000x24", "-nolisten", "tcp",
             static_cast<char*>(nullptr));
      _exit(127);
    }
    close(ends[1]);
    // The server writes the number of its display when it is ready, or closes the pipe when it cannot start.
    std::string number;
    char c = 0;
    while (read(ends[0], &c, 1) == 1 && c != '\n') number += c;
    close(ends[0]);
    if (!number.empty()) setenv("DISPLAY", (":" + number).c_str(), 1);
    own_display_ = !number.empty();
  }
  ~VirtualDisplay() {
    if (server_ <= 0) return;
    kill(server_, SIGTERM);
    waitpid(server_, nullptr, 0);
    if (own_display_) unsetenv("DISPLAY");
  }
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;

 private:
  pid_t server_ = -1;
  bool own_display_ = false;
};

class WindowTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { display_ = std::make_unique<VirtualDisplay>(); }
  static void TearDownTestSuite() { display_.reset(); }

  void SetUp() override {
    if (std::getenv("DISPLAY") == nullptr) {
      GTEST_SKIP() << "no display, and no Xvfb to make one (apt-get install xvfb)";
    }
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(PLANEWRIGHT_BINARY_DIR) / "ui_runs" / info->name();
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    pictures_ = std::filesystem::path(PLANEWRIGHT_BINARY_DIR) / "ui_pictures";
    std::filesystem::create_directories(pictures_);
  }

  // Plays a script; FOLDER and PICTURES in it stand for the test's own folder and that of the pictures.
  Playback play(std::string script, const std::string& arguments = "", int seconds = 240,
                const std::string& size = "1440x900") const {
    for (const auto& [name, path] :
         {std::pair<std::string, std::filesystem::path>{"FOLDER", folder_}, {"PICTURES", pictures_}}) {
      for (auto at = script.find(name); at != std::string::npos;
           at = script.find(name, at + path.string().size())) {
        script.replace(at, name.size(), path.string());
      }
    }
    const std::filesystem::path file = folder_ / "script.txt";
    std::ofstream(file) << script;
    std::ostringstream command;
    command << "XDG_CONFIG_HOME=" << folder_ / "config"
            << " timeout " << seconds << ' ';
    command << std::filesystem::path(PLANEWRIGHT_WINDOW_BINARY) << " --size " << size << " --script " << file
            << ' ' << arguments << " 2>&1";
    Playback run;
    FILE* pipe = popen(command.str().c_str(), "r");
    if (pipe == nullptr) return run;
    char buffer[4096];
    while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, pipe))
      run.output.append(buffer, count);
    const int status = pclose(pipe);
    run.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return run;
  }

  // A value that the script printed.
  static std::string printed(const Playback& run, const std::string& key) {
    std::istringstream lines(run.output);
    std::string line, found;
    while (std::getline(lines, line)) {
      if (line.starts_with(key + " = ")) found = line.substr(key.size() + 3);
    }
    return found;
  }

  static inline std::unique_ptr<VirtualDisplay> display_;
  std::filesystem::path folder_, pictures_;
};

}  // namespace planewright
