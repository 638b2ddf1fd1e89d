// PNG encoding. No OpenGL. Threads: no shared state.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "ui/render/image.h"

namespace planewright::render {

// The bytes of a PNG file: 8 bits RGB, no alpha (the picture's ground is opaque).
std::string encode_png(const Image& image);

// Whole or not at all; fails with ErrorCode::Unwritable.
Result<void> write_png(const Image& image, const std::filesystem::path& path);

}  // namespace planewright::render
