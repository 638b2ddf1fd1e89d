#include "core/certify/file_bytes.h"

#include <fstream>
#include <iterator>

namespace planewright {

Result<std::string> file_bytes(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    return fail(ErrorCode::Unreadable, "the file is not there", path.filename().string());
  std::ifstream in(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (!in && !in.eof())
    return fail(ErrorCode::Unreadable, "the file cannot be read", path.filename().string());
  if (bytes.empty()) return fail(ErrorCode::Unreadable, "the file is empty", path.filename().string());
  return bytes;
}

}  // namespace planewright
