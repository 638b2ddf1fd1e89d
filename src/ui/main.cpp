// planewright: the window. Only the command line and the exit status are here.
//
// Exit status: 0 closed; 1 an expectation of --script was not met; 2 bad usage; 3 something is missing or
// unreadable (no display, no OpenGL, the script); 4 the settings could not be written.
#include <CLI/CLI.hpp>
#include <iostream>
#include <string>

#include "ui/window.h"

namespace {

int exit_status(planewright::ErrorCode code) {
  switch (code) {
    case planewright::ErrorCode::Infeasible:
      return 1;
    case planewright::ErrorCode::Usage:
      return 2;
    case planewright::ErrorCode::Unreadable:
    case planewright::ErrorCode::Refused:
    case planewright::ErrorCode::Unavailable:
      return 3;
    case planewright::ErrorCode::Unwritable:
      return 4;
  }
  return 3;
}

int report(const planewright::Error& error) {
  std::cerr << "planewright: " << error.text() << "\n";
  return exit_status(error.code);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Planewright turns freeform surfaces into planar panels.", "planewright");
  app.set_version_flag("--version", PLANEWRIGHT_VERSION);
  std::string file, script, size, theme;
  float scale = 0;
  planewright::ui::WindowOptions options;
  app.add_option("FILE", file, "A mesh to open (.obj .off .ply .stl); without one, a sample");
  app.add_option("--scale", scale, "Size of text and controls, 1 for a plain monitor")
      ->check(CLI::Range(0.75, 4.0));
  app.add_option("--theme", theme, "light or dark")->check(CLI::IsMember({"light", "dark"}));
  app.add_option("--size", size, "Size of the window, e.g. 1440x900");
  // For tests.
  app.add_option("--script", script)->group("");
  app.add_flag("--dump-ui", options.dump_ui)->group("");
  app.add_flag("--print-timings", options.print_timings)->group("");
  bool forget = false;
  app.add_flag("--no-settings", forget)->group("");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (!file.empty()) options.file = file;
  if (scale > 0) options.scale = scale;
  if (!theme.empty()) options.dark = theme == "dark";
  options.remember = !forget;
  if (!size.empty()) {
    int width = 0, height = 0;
    char rest = 0;
    if (std::sscanf(size.c_str(), "%dx%d%c", &width, &height, &rest) != 2 || width < 640 || height < 480) {
      return report({planewright::ErrorCode::Usage, "the size is two numbers of at least 640x480", "--size",
                     "For example --size 1440x900"});
    }
    options.width = width;
    options.height = height;
  }
  if (!script.empty()) {
    auto loaded = planewright::ui::load_script(script);
    if (!loaded) return report(loaded.error());
    options.script = std::move(*loaded);
  }
  const auto result = planewright::ui::run_window(options);
  return result ? 0 : report(result.error());
}
