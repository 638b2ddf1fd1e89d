// An OpenGL 3.3 core context without window, display or X: EGL's surfaceless platform (Mesa), or EGL's
// default display where that platform is missing. It has no framebuffer of its own; draw into one you make.
//
// Threads: the context is current in the thread that made it, and must die there. The EGL context that was
// current before is so again afterwards.
#pragma once

#include <memory>

#include "core/base/result.h"

namespace planewright::render {

class EglContext {
 public:
  // Fails with ErrorCode::Unavailable, naming what is missing and the Debian packages that bring it.
  static Result<EglContext> create();
  EglContext(EglContext&&) noexcept;
  EglContext& operator=(EglContext&&) noexcept;
  ~EglContext();

 private:
  struct Impl;
  explicit EglContext(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace planewright::render
