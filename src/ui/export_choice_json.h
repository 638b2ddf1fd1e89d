// The export dialog's settings in the file of the window's settings (user_settings.h). Threads: pure.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "ui/export_choice.h"

namespace planewright::ui {

// Without project and note, which belong to one design.
nlohmann::ordered_json to_json(const ExportChoice& choice);
// What is missing, of another type, unknown or out of range is as at first.
ExportChoice read_export_choice(const nlohmann::json& json);

}  // namespace planewright::ui
