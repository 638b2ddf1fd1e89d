// Window: the GLFW window with its OpenGL context, and the loop that a frame goes through:
// poll input → take what the workers have → draw the parts → apply actions → draw the model if something
// changed.
//
// Sleeps while nothing happens; workers wake it. Threads: run_window() must be called on the main thread.
#pragma once

#include <filesystem>
#include <optional>

#include "core/base/result.h"
#include "ui/script.h"

namespace planewright::ui {

struct WindowOptions {
  std::optional<std::filesystem::path> file;  // to open; else a sample
  std::optional<int> width, height;           // else as it was left
  std::optional<float> scale;                 // of everything; else the monitor's
  std::optional<bool> dark;                   // else as it was left
  bool remember = true;                       // read the settings at the start, write them at the end
  bool print_timings = false;                 // at the end, to standard output
  bool dump_ui = false;                       // where the controls are, to standard output, for tests
  std::optional<Script> script;               // plays it, then quits
};

// Returns when the window was closed. Fails with ErrorCode::Unavailable (no display, no OpenGL 3.3), or with
// ErrorCode::Infeasible and the place in the script where an expectation was not met.
Result<void> run_window(const WindowOptions& options);

}  // namespace planewright::ui
