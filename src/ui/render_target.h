// RenderTarget: the texture and depth buffer that the model is drawn into, so that a picture can be shown
// again without being drawn again. Threads: that of the current OpenGL context. Units: framebuffer pixels.
#pragma once

#include <epoxy/gl.h>
#include <imgui.h>

#include <cstdint>

namespace planewright::ui {

class RenderTarget {
 public:
  RenderTarget() = default;
  RenderTarget(const RenderTarget&) = delete;
  RenderTarget& operator=(const RenderTarget&) = delete;
  ~RenderTarget() { release(); }

  // True if the size changed, so that the picture is gone.
  bool resize(int width, int height) {
    if (width == width_ && height == height_) return false;
    release();
    width_ = width;
    height_ = height;
    glGenTextures(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glBindTexture(GL_TEXTURE_2D, 0);
    glGenRenderbuffers(1, &depth_);
    glBindRenderbuffer(GL_RENDERBUFFER, depth_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return true;
  }
  GLuint framebuffer() const { return framebuffer_; }
  ImTextureID texture() const { return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture_)); }
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  void release() {
    if (framebuffer_ != 0) glDeleteFramebuffers(1, &framebuffer_);
    if (depth_ != 0) glDeleteRenderbuffers(1, &depth_);
    if (texture_ != 0) glDeleteTextures(1, &texture_);
    framebuffer_ = depth_ = texture_ = 0;
  }

  GLuint framebuffer_ = 0, texture_ = 0, depth_ = 0;
  int width_ = 0, height_ = 0;
};

}  // namespace planewright::ui
