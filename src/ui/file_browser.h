// FileBrowser: opening and saving files inside the window, so that nothing blocks and a test can drive it.
//
// A name typed or a row chosen, then Enter or the button; a folder is entered, a file is returned. Saving
// over a file that exists asks once more, in the same place. Where a folder is chosen, the name is that of
// one in the folder that is seen, there or not; without a name it is that folder itself. Threads: the
// window's; folders are read when entered.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ui/widgets.h"

namespace planewright::ui {

class FileBrowser {
 public:
  enum class Purpose { Open, SaveProject, OpenTolerances, SaveTolerances, ExportPanels, ChooseFolder };

  // `folder`: where to begin; the working directory if it is empty or gone. `name`: what to call a new file.
  void open(Purpose purpose, const std::filesystem::path& folder, std::string name = {});
  void close() { is_open_ = false; }
  bool is_open() const { return is_open_; }
  Purpose purpose() const { return purpose_; }
  const std::filesystem::path& folder() const { return folder_; }

  // The path that was chosen in this frame.
  std::optional<std::filesystem::path> draw(Ui& ui);

 private:
  struct Entry {
    std::string name;
    bool is_folder = false;
    std::uintmax_t size = 0;
  };
  void enter(const std::filesystem::path& folder);
  bool saving() const {
    return purpose_ == Purpose::ExportPanels || purpose_ == Purpose::SaveProject ||
           purpose_ == Purpose::SaveTolerances;
  }
  bool has_formats() const { return purpose_ == Purpose::ExportPanels; }
  bool choosing_folder() const { return purpose_ == Purpose::ChooseFolder; }
  std::optional<std::filesystem::path> accept();
  void move_selection(int by);
  void draw_places(Ui& ui);
  bool draw_entries(Ui& ui, float height);

  bool is_open_ = false, appearing_ = false, scroll_to_selected_ = false;
  Purpose purpose_ = Purpose::Open;
  std::filesystem::path folder_;
  std::vector<Entry> entries_;
  int selected_ = -1;
  std::string name_;                                // the text field
  std::string trouble_;                             // why the last try did not work
  int format_ = 0;                                  // of a new file
  std::optional<std::filesystem::path> overwrite_;  // asks whether to replace it
};

}  // namespace planewright::ui
