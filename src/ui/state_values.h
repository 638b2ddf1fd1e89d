// What scripts ask of the program's state, by name, in parts: state_value() of test_driver.h asks them in
// turn. Internal to the test driver. Threads: the window's.
#pragma once

#include <optional>
#include <string>

#include "ui/test_driver.h"

namespace planewright::ui {

// A number with all its digits.
std::string text_of(double value);

// Of what fails the tolerances, the terms of the workshop, the export dialog, and the schedule.
std::optional<std::string> workshop_state_value(const DriverContext& context, const std::string& key);

}  // namespace planewright::ui
