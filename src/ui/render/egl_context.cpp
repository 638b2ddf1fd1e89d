#include "ui/render/egl_context.h"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <string>

namespace planewright::render {
namespace {

constexpr const char* kPackages = "on Debian: apt-get install libegl1 libegl-mesa0 libgl1 libgl1-mesa-dri";

tl::unexpected<Error> missing(std::string what) {
  return fail(ErrorCode::Unavailable, std::move(what), {}, kPackages);
}

// libepoxy ends the program when a library it needs is not there; so this asks first.
bool can_open(const char* library) {
  void* handle = dlopen(library, RTLD_LAZY | RTLD_LOCAL);
  if (handle != nullptr) dlclose(handle);
  return handle != nullptr;
}

EGLDisplay open_display() {
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    const EGLDisplay display =
        eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE) return display;
  }
  const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE) return display;
  return EGL_NO_DISPLAY;
}

}  // namespace

struct EglContext::Impl {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  EGLDisplay display_before = EGL_NO_DISPLAY;
  EGLContext context_before = EGL_NO_CONTEXT;
  EGLSurface draw_before = EGL_NO_SURFACE, read_before = EGL_NO_SURFACE;

  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  // The display stays initialised: EGL has one per process, and others may use it.
  ~Impl() {
    if (context == EGL_NO_CONTEXT) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
    if (context_before != EGL_NO_CONTEXT)
      eglMakeCurrent(display_before, draw_before, read_before, context_before);
  }
};

Result<EglContext> EglContext::create() {
  if (!can_open("libEGL.so.1"))
    return missing("this machine has no EGL (libEGL.so.1), needed to draw without a window");
  if (!can_open("libOpenGL.so.0") && !can_open("libGL.so.1")) {
    return missing("this machine has no OpenGL library (libOpenGL.so.0 or libGL.so.1)");
  }

  auto impl = std::make_unique<Impl>();
  impl->display_before = eglGetCurrentDisplay();
  impl->context_before = eglGetCurrentContext();
  impl->draw_before = eglGetCurrentSurface(EGL_DRAW);
  impl->read_before = eglGetCurrentSurface(EGL_READ);

  impl->display = open_display();
  if (impl->display == EGL_NO_DISPLAY) return missing("EGL has no driver that draws without a window");
  if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) return missing("EGL offers no desktop OpenGL");

  const EGLint config_wishes[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_DONT_CARE,
                                  EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (eglChooseConfig(impl->display, config_wishes, &config, 1, &count) != EGL_TRUE || count == 0) {
    config = EGL_NO_CONFIG_KHR;
  }
  const EGLint context_wishes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                   3,
                                   EGL_CONTEXT_MINOR_VERSION,
                                   3,
                                   EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                   EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                   EGL_NONE};
  impl->context = eglCreateContext(impl->display, config, EGL_NO_CONTEXT, context_wishes);
  if (impl->context == EGL_NO_CONTEXT) return missing("the OpenGL driver has no version 3.3");
  if (eglMakeCurrent(impl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, impl->context) != EGL_TRUE) {
    return missing("the OpenGL driver cannot draw without a surface");
  }
  return EglContext(std::move(impl));
}

EglContext::EglContext(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
EglContext::EglContext(EglContext&&) noexcept = default;
EglContext& EglContext::operator=(EglContext&&) noexcept = default;
EglContext::~EglContext() = default;

}  // namespace planewright::render
