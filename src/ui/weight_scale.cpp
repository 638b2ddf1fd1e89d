#include "ui/weight_scale.h"

#include <algorithm>
#include <cmath>

namespace planewright::ui {
namespace {

constexpr double kZeroZone = 0.04;  // of the travel: here the weight is 0

double two_digits(double value) {
  if (!(value > 0)) return 0.0;
  const double power = std::pow(10.0, std::floor(std::log10(value)) - 1);
  const double digits = std::round(value / power);
  // Dividing by a whole power of ten gives the nearest double to the decimal number.
  return power < 1 ? digits / std::round(1.0 / power) : digits * power;
}

}  // namespace

double weight_at(double fraction) {
  if (!(fraction >= kZeroZone)) return 0.0;
  const double t = std::min((fraction - kZeroZone) / (1 - kZeroZone), 1.0);
  const double low = std::log10(kLeastWeight), high = std::log10(kMostWeight);
  return two_digits(std::pow(10.0, low + t * (high - low)));
}

double fraction_of_weight(double weight) {
  if (!(weight > 0)) return 0.0;
  const double low = std::log10(kLeastWeight), high = std::log10(kMostWeight);
  const double t = (std::log10(weight) - low) / (high - low);
  return kZeroZone + (1 - kZeroZone) * std::clamp(t, 0.0, 1.0);
}

double weight_step(double weight, double notches) {
  constexpr double kNotch = 0.1;  // decades
  if (!(weight > 0)) return notches > 0 ? kLeastWeight : 0.0;
  const double stepped = weight * std::pow(10.0, kNotch * notches);
  if (stepped < kLeastWeight * 0.999) return 0.0;
  return two_digits(std::min(stepped, std::max(kMostWeight, weight)));
}

}  // namespace planewright::ui
