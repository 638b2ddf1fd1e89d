// Runs the window's state without a window, as its frames would.
#pragma once

#include <chrono>
#include <thread>

#include "ui/app_state.h"

namespace planewright::test {

// Runs frames until `done`; false after a minute.
template <class Done>
bool run_until(ui::AppState& state, Done done) {
  using namespace std::chrono_literals;
  const auto limit = ui::Clock::now() + 60s;
  while (!done()) {
    if (ui::Clock::now() > limit) return false;
    state.update(ui::Clock::now());
    std::this_thread::sleep_for(1ms);
  }
  return true;
}
inline bool settle(ui::AppState& state) {
  return run_until(state, [&] { return state.settled() && !state.document().empty(); });
}

// A solved dome, and what the workshop makes of it.
inline bool open_dome_at_the_workshop(ui::AppState& state, int panels) {
  state.workshop_in_sight = true;
  state.open_sample("dome", panels);
  return settle(state);
}

// The active layer's settings with another weight of fairing.
inline LayerSettings with_fairing(const ui::AppState& state, double weight) {
  LayerSettings settings = state.document().settings();
  settings.weights["fairing"] = weight;
  return settings;
}

}  // namespace planewright::test
