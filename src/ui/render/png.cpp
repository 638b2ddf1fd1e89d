#include "ui/render/png.h"

#include "core/base/atomic_file.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>

namespace planewright::render {

std::string encode_png(const Image& image) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(image.rgba.size() / 4 * 3);
  for (size_t i = 0; i + 3 < image.rgba.size(); i += 4) {
    rgb.insert(rgb.end(), image.rgba.begin() + static_cast<std::ptrdiff_t>(i),
               image.rgba.begin() + static_cast<std::ptrdiff_t>(i) + 3);
  }
  std::string bytes;
  const auto append = [](void* to, void* data, int size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data), static_cast<size_t>(size));
  };
  stbi_write_png_to_func(append, &bytes, image.width, image.height, 3, rgb.data(), 3 * image.width);
  return bytes;
}

Result<void> write_png(const Image& image, const std::filesystem::path& path) {
  const std::string bytes = encode_png(image);
  if (bytes.empty())
    return fail(ErrorCode::Unwritable, "the picture cannot be encoded (out of memory)", path.string());
  return write_file_atomically(path, bytes);
}

}  // namespace planewright::render
