#include "ui/count_scale.h"

#include <algorithm>
#include <cmath>

namespace planewright::ui {

int count_at(double fraction, int least, int most) {
  if (!(fraction > 0)) return least;
  const double low = std::log(least), high = std::log(most);
  return std::clamp(static_cast<int>(std::lround(std::exp(low + std::min(fraction, 1.0) * (high - low)))),
                    least, most);
}

double fraction_of_count(int count, int least, int most) {
  if (most <= least) return 0.0;
  const double low = std::log(least), high = std::log(most);
  return std::clamp((std::log(std::max(count, 1)) - low) / (high - low), 0.0, 1.0);
}

int count_step(int count, double notches, int least, int most) {
  constexpr double kPart = 0.05;
  const double step = std::max(1.0, std::round(kPart * count));
  return std::clamp(static_cast<int>(std::lround(count + notches * step)), std::min(least, count),
                    std::max(most, count));
}

}  // namespace planewright::ui
