#include "ui/window.h"

#include <epoxy/gl.h>
// After the loader of OpenGL.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <cstring>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/atomic_file.h"
#include "ui/finding_limits.h"
#include "ui/panels.h"
#include "ui/render/png.h"
#include "ui/test_driver.h"
#include "ui/viewport.h"

namespace planewright::ui {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

constexpr int kFramesAfterInput = 3;  // Dear ImGui settles within these

// What GLFW said last.
std::string glfw_reason() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text != nullptr ? text : "no reason given";
}

struct GlfwLibrary {
  bool ready = glfwInit() == GLFW_TRUE;
  ~GlfwLibrary() {
    if (ready) glfwTerminate();
  }
};

struct WindowDeleter {
  void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
};

struct ImGuiScope {
  ImGuiScope() { ImGui::CreateContext(); }
  ~ImGuiScope() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
  }
  ImGuiScope(const ImGuiScope&) = delete;
  ImGuiScope& operator=(const ImGuiScope&) = delete;
};

// What the callbacks gather between two frames.
struct Gathered {
  bool anything = false;
  std::vector<KeyPress> keys;
  std::vector<char32_t> characters;
  std::vector<fs::path> dropped;
};

Gathered& gathered_of(GLFWwindow* window) {
  auto& gathered = *static_cast<Gathered*>(glfwGetWindowUserPointer(window));
  gathered.anything = true;
  return gathered;
}

// Letters as the layout of the keyboard has them: on a German keyboard Ctrl Z is where Z stands.
int key_by_layout(int key, int scancode) {
  if (key < GLFW_KEY_A || key > GLFW_KEY_Z) return key;
  const char* name = glfwGetKeyName(key, scancode);
  if (name == nullptr || std::strlen(name) != 1) return key;
  const char letter = name[0];
  return letter >= 'a' && letter <= 'z' ? letter - 'a' + GLFW_KEY_A : key;
}

// Dear ImGui's backend chains to callbacks that were there before it.
void install_callbacks(GLFWwindow* window) {
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
    Gathered& gathered = gathered_of(w);
    if (action != GLFW_PRESS) return;
    gathered.keys.push_back({key_by_layout(key, scancode), (mods & GLFW_MOD_CONTROL) != 0,
                             (mods & GLFW_MOD_SHIFT) != 0, (mods & GLFW_MOD_ALT) != 0});
  });
  glfwSetCharCallback(window,
                      [](GLFWwindow* w, unsigned code) { gathered_of(w).characters.push_back(code); });
  glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
    gathered_of(w).dropped.assign(paths, paths + count);
  });
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double, double) { gathered_of(w); });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int, int, int) { gathered_of(w); });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double, double) { gathered_of(w); });
  glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int) { gathered_of(w); });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int) { gathered_of(w); });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { gathered_of(w); });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { gathered_of(w); });
}

Result<void> save_screenshot(GLFWwindow* window, const fs::path& path) {
  render::Image image;
  glfwGetFramebufferSize(window, &image.width, &image.height);
  const auto row = static_cast<std::size_t>(image.width) * 4;
  std::vector<std::uint8_t> pixels(row * static_cast<std::size_t>(image.height));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  image.rgba.resize(pixels.size());
  for (int y = 0; y < image.height; ++y) {
    std::memcpy(image.rgba.data() + static_cast<std::size_t>(image.height - 1 - y) * row,
                pixels.data() + static_cast<std::size_t>(y) * row, row);
  }
  return render::write_png(image, path);
}

UserSettings load_settings(AppState& state) {
  const auto path = user_settings_path();
  std::error_code error;
  if (!path || !fs::exists(*path, error)) return {};
  const auto settings = read_file(*path).and_then(parse_user_settings);
  if (settings) return *settings;
  state.post(Message::Kind::Warning, "the window's settings could not be read, the defaults are used",
             path->string(), settings.error().what);
  return {};
}

Result<void> save_settings(const UserSettings& settings) {
  const auto path = user_settings_path();
  if (!path) return {};
  std::error_code error;
  fs::create_directories(path->parent_path(), error);
  if (error)
    return fail(ErrorCode::Unwritable, "the settings' folder cannot be made: " + error.message(),
                path->string());
  return write_file_atomically(*path, format_user_settings(settings));
}

class Window {
 public:
  explicit Window(const WindowOptions& options) : options_(options), state_(&glfwPostEmptyEvent) {}

  Result<void> open();
  Result<void> run();

 private:
  void frame();
  void handle_keys();
  void type_character(char32_t character);
  void drop(const std::vector<fs::path>& paths);
  void take_browser_result();
  void apply_wishes();
  double sleep_seconds() const;
  bool workshop_in_sight() const;

  const WindowOptions& options_;
  GlfwLibrary glfw_;
  std::unique_ptr<GLFWwindow, WindowDeleter> window_;
  std::unique_ptr<ImGuiScope> imgui_;
  Gathered gathered_;
  std::optional<Theme> theme_;
  std::optional<Ui> ui_;
  WindowState shown_;
  std::optional<Viewport> viewport_;  // dies before the context
  AppState state_;                    // dies first: its workers post events to GLFW
  std::optional<Actions> actions_;
  std::optional<TestDriver> driver_;
  std::optional<UiDump> dump_;
  std::string title_ = "Planewright";
  int frame_ = 0;
  int frames_due_ = kFramesAfterInput;
  Clock::time_point last_frame_{};
};

Result<void> Window::open() {
  if (!glfw_.ready) {
    return fail(ErrorCode::Unavailable, "no window can be opened: " + glfw_reason(), {},
                "Start it on a desktop, or use planewright-cli.");
  }
  if (options_.remember) shown_.settings = load_settings(state_);
  UserSettings& settings = shown_.settings;
  if (options_.dark) settings.dark = *options_.dark;
  state_.view_options.ghost = settings.show_ghost;
  if (const auto unit = parse_length_unit(settings.unit, "unit")) state_.default_unit = *unit;
  state_.set_auto_solve(settings.auto_solve);
  state_.set_polish_automatically(settings.polish_automatically);
  state_.set_finding_settings(with_limits(settings.finding_limits));

  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "planewright");
  window_.reset(glfwCreateWindow(options_.width.value_or(settings.window_width),
                                 options_.height.value_or(settings.window_height), "Planewright", nullptr,
                                 nullptr));
  if (!window_) {
    return fail(ErrorCode::Unavailable, "no window with OpenGL 3.3 can be opened: " + glfw_reason(), {},
                "Install Mesa's drivers (libgl1-mesa-dri).");
  }
  glfwSetWindowSizeLimits(window_.get(), 640, 480, GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwMakeContextCurrent(window_.get());
  glfwSwapInterval(options_.script ? 0 : 1);
  glfwSetWindowUserPointer(window_.get(), &gathered_);
  install_callbacks(window_.get());

  imgui_ = std::make_unique<ImGuiScope>();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // what is remembered stands in UserSettings
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  if (!ImGui_ImplGlfw_InitForOpenGL(window_.get(), true) || !ImGui_ImplOpenGL3_Init("#version 330")) {
    return fail(ErrorCode::Unavailable, "the window's controls cannot be drawn with this OpenGL");
  }
  float scale_x = 1, scale_y = 1;
  glfwGetWindowContentScale(window_.get(), &scale_x, &scale_y);
  // On X11 a pixel of the window is one of the screen; where the framebuffer is finer, it scales by itself.
  int window_width = 1, framebuffer_width = 1, unused = 0;
  glfwGetWindowSize(window_.get(), &window_width, &unused);
  glfwGetFramebufferSize(window_.get(), &framebuffer_width, &unused);
  const float finer = static_cast<float>(framebuffer_width) / static_cast<float>(std::max(window_width, 1));
  theme_.emplace(std::clamp(options_.scale.value_or(scale_x / std::max(finer, 1.0f)), 0.75f, 4.0f),
                 settings.dark);
  ui_.emplace(*theme_);
  actions_.emplace(state_, shown_);

  auto viewport = Viewport::create();
  if (!viewport) return tl::unexpected<Error>(viewport.error());
  viewport_.emplace(std::move(*viewport));

  if (options_.script) driver_.emplace(*options_.script);
  if (options_.dump_ui) dump_.emplace(std::cout);
  if (options_.file) {
    state_.open_file(*options_.file);
  } else {
    state_.open_sample("dome");
  }
  return {};
}

double Window::sleep_seconds() const {
  double seconds = 0.5;
  if (state_.busy() || state_.loading() || ui_->waiting() || ImGui::GetIO().WantTextInput || dump_ ||
      state_.export_preparing() || state_.exporting_to_workshop())
    seconds = 0.05;
  if (const auto deadline = state_.next_deadline()) {
    seconds = std::min(seconds, std::chrono::duration<double>(*deadline - Clock::now()).count());
  }
  return std::max(seconds, 0.001);
}

Result<void> Window::run() {
  while (!shown_.quit && !(driver_ && driver_->done())) {
    if (glfwWindowShouldClose(window_.get()) != GLFW_FALSE) {
      glfwSetWindowShouldClose(window_.get(), GLFW_FALSE);
      leave(shown_, state_, {Leaving::What::Quit, {}});
      frames_due_ = kFramesAfterInput;
      if (shown_.quit) break;
    }
    if (driver_ && driver_->idle() && frames_due_ == 0) {
      glfwWaitEventsTimeout(0.02);
    } else if (frames_due_ > 0 || driver_) {
      glfwPollEvents();
    } else {
      glfwWaitEventsTimeout(sleep_seconds());
    }
    const Stopwatch watch;
    const ThreadClock thread_clock;
    const auto now = Clock::now();
    if (std::exchange(gathered_.anything, false)) frames_due_ = kFramesAfterInput;

    const std::size_t drains = state_.timings.drain.count(), uploads = state_.timings.upload.count();
    if (state_.update(now)) frames_due_ = std::max(frames_due_, 2);
    viewport_->upload(state_, shown_.settings.dark);
    const bool drained = state_.timings.drain.count() > drains,
               uploaded = state_.timings.upload.count() > uploads;
    if (drained || uploaded) {
      state_.timings.stream.add(watch.milliseconds());
      state_.timings.stream_cpu.add(thread_clock.milliseconds());
    }

    // Things that move by themselves: the time of a running solve, a text cursor, a gesture that ends by
    // waiting.
    const bool lively = state_.busy() || state_.loading() || ui_->waiting() || ImGui::GetIO().WantTextInput ||
                        state_.export_preparing() || state_.exporting_to_workshop();
    if (viewport_->flying()) frames_due_ = std::max(frames_due_, 1);
    if (lively && now - last_frame_ > 90ms) frames_due_ = std::max(frames_due_, 1);
    if (dump_) frames_due_ = std::max(frames_due_, 1);
    if (frames_due_ == 0 && !driver_) continue;
    frames_due_ = std::max(frames_due_ - 1, 0);
    last_frame_ = now;
    frame();
    state_.timings.frame.add(watch.milliseconds());
    if (driver_ && driver_->failure()) break;
  }

  int width = 0, height = 0;
  glfwGetWindowSize(window_.get(), &width, &height);
  if (!options_.width) shown_.settings.window_width = std::max(width, 640);
  if (!options_.height) shown_.settings.window_height = std::max(height, 480);
  if (options_.print_timings) std::cout << state_.timings.text() << std::flush;
  if (driver_ && driver_->failure()) return fail(ErrorCode::Infeasible, *driver_->failure());
  if (options_.remember) return save_settings(shown_.settings);
  return {};
}

void Window::handle_keys() {
  const auto keys = std::exchange(gathered_.keys, {});
  const auto characters = std::exchange(gathered_.characters, {});
  if (ImGui::GetIO().WantTextInput || shown_.browser.is_open() || shown_.leaving) return;
  for (const KeyPress& key : keys) actions_->press(key);
  for (const char32_t character : characters) type_character(character);
}

// The question mark stands on different keys, so it is known by what it types.
void Window::type_character(char32_t character) {
  if (character == U'?') actions_->request(Action::Keys);
}

void Window::drop(const std::vector<fs::path>& paths) {
  if (paths.empty()) return;
  leave(shown_, state_, {Leaving::What::Open, paths.front()});
  if (paths.size() > 1) {
    state_.post(Message::Kind::Info,
                "only the first of " + std::to_string(paths.size()) + " files is opened");
  }
}

void Window::take_browser_result() {
  const auto path = shown_.browser.draw(*ui_);
  if (!path) return;
  shown_.settings.last_folder = path->parent_path().string();
  if (shown_.browser.purpose() == FileBrowser::Purpose::Open) {
    leave(shown_, state_, {Leaving::What::Open, *path});
  } else if (shown_.browser.purpose() == FileBrowser::Purpose::SaveProject) {
    state_.save_project(*path);
  } else if (shown_.browser.purpose() == FileBrowser::Purpose::OpenTolerances) {
    state_.load_tolerances(*path);
  } else if (shown_.browser.purpose() == FileBrowser::Purpose::SaveTolerances) {
    state_.save_tolerances(*path);
  } else if (shown_.browser.purpose() == FileBrowser::Purpose::ChooseFolder) {
    shown_.export_dialog.folder = path->string();
    state_.forget_export_outcome();
  } else {
    state_.export_panels(*path);
  }
}

void Window::apply_wishes() {
  if (std::exchange(shown_.fit_wanted, false)) viewport_->fit(state_);
  if (std::exchange(shown_.reset_view_wanted, false)) viewport_->reset_direction(state_);
  if (const auto look = std::exchange(shown_.look_at, std::nullopt)) viewport_->look_at(*look);
  if (const auto look = state_.take_look_at()) viewport_->look_at(*look);
  if (theme_->dark() != shown_.settings.dark) theme_->set_dark(shown_.settings.dark);
  const std::string name = state_.title();
  const std::string title =
      name.empty() ? "Planewright" : (state_.modified() ? "• " : "") + name + " – Planewright";
  if (title != title_) glfwSetWindowTitle(window_.get(), (title_ = title).c_str());
}

// Whether what the workshop makes of the panels is to be found out.
bool Window::workshop_in_sight() const {
  return shown_.export_dialog.open || shown_.right_tab == 2 || actions_->checked(Action::Schedule) ||
         state_.view_options.names || state_.view_options.colours == ColourMap::Tolerances;
}

void Window::frame() {
  ++frame_;
  state_.workshop_in_sight = workshop_in_sight();
  state_.wanted_export =
      shown_.export_dialog.open ? std::optional(shown_.settings.workshop_export) : std::nullopt;
  if (!gathered_.dropped.empty()) drop(std::exchange(gathered_.dropped, {}));
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  if (driver_) driver_->inject(ImGui::GetIO());
  ImGui::NewFrame();
  ui_->begin_frame(frame_);
  handle_keys();

  const Stopwatch watch;
  Desk desk{*ui_, state_, shown_, *actions_};
  const float menu_height = draw_menu_bar(desk);
  const Layout layout = arrange(ImGui::GetIO().DisplaySize, menu_height, theme_->scale(), shown_.settings);
  viewport_->draw(*ui_, state_, layout.viewport);
  draw_toolbar(desk, layout.toolbar);
  draw_design_panel(desk, layout.left);
  draw_findings_panel(desk, layout.right);
  draw_bottom_panel(desk, layout.bottom);
  draw_status_bar(desk, layout.status);
  draw_splitters(desk, layout);
  draw_solve_badge(desk, viewport_->panels_place());
  draw_hint(desk, layout.viewport);
  draw_export_dialog(desk);
  draw_messages(desk, layout.viewport);
  take_browser_result();
  draw_help_cards(desk);
  draw_leaving(desk);
  if (const auto target = viewport_->take_context_request()) open_context_menu(desk, *target);
  draw_context_menu(desk);
  // A control that vanishes while it is held (its card is closed, its tab left) never says that it is done.
  if (state_.document().merging() && !ImGui::IsAnyItemActive() && !ui_->waiting()) state_.end_merge();
  actions_->apply_requested();
  if (std::exchange(shown_.export_dialog_wanted, false)) open_export_dialog(desk);
  apply_wishes();

  ImGui::Render();
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_.get(), &width, &height);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, width, height);
  const ImVec4 ground = to_vec4(theme_->colours().ground);
  glClearColor(ground.x, ground.y, ground.z, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  state_.timings.panels.add(watch.milliseconds() -
                            (viewport_->take_redrawn() ? state_.timings.scene.last() : 0));

  const DriverContext context{state_,
                              shown_,
                              *ui_,
                              *viewport_,
                              *actions_,
                              [this](const std::vector<fs::path>& paths) { drop(paths); },
                              [this](const KeyPress& key) { gathered_.keys.push_back(key); },
                              [this](char32_t character) { gathered_.characters.push_back(character); }};
  if (driver_) {
    if (const auto path = driver_->take_screenshot_request()) {
      if (const auto saved = save_screenshot(window_.get(), *path); !saved) state_.post(saved.error());
    }
    driver_->step(context, frame_);
  }
  if (dump_) dump_->frame(context);
  glfwSwapBuffers(window_.get());
}

}  // namespace

Result<void> run_window(const WindowOptions& options) {
  Window window(options);
  if (auto opened = window.open(); !opened) return opened;
  return window.run();
}

}  // namespace planewright::ui
