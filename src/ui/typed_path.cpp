#include "ui/typed_path.h"

#include <cstdlib>

namespace planewright::ui {

std::filesystem::path home_folder() {
  const char* home = std::getenv("HOME");
  return home != nullptr ? std::filesystem::path(home) : std::filesystem::path("/");
}

std::filesystem::path typed_path(const std::string& text) {
  if (text == "~") return home_folder();
  return text.starts_with("~/") ? home_folder() / text.substr(2) : std::filesystem::path(text);
}

}  // namespace planewright::ui
