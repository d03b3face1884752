#include "appliance/programs/lips/one_euro.h"

#include <cmath>
#include <numbers>

namespace kaori::lips {
namespace {

constexpr float kSpeedCutoff_hz =
    3;  // The cut-off for the speed itself; the paper's 1 Hz is too slow for a mouth.
constexpr Duration kLongestGap = std::chrono::seconds(1);  // After a longer gap the past says nothing.

// The weight of a new value in a first-order low pass.
float Share(float cutoff_hz, float dt_s) {
  const float x = 2 * std::numbers::pi_v<float> * cutoff_hz * dt_s;
  return x / (1 + x);
}

}  // namespace

// The speed is filtered first, with a fixed cut-off, and then sets the cut-off for the value.
float OneEuro::Filter(float value, Time at) {
  if (!last_ || at <= last_->at || at - last_->at > kLongestGap) {
    last_ = Last{at, value, 0};
    return value;
  }
  const auto dt_s = static_cast<float>(Seconds(at - last_->at));
  const float raw_speed = (value - last_->value) / dt_s;
  const float speed = last_->speed + Share(kSpeedCutoff_hz, dt_s) * (raw_speed - last_->speed);
  const float cutoff_hz = settings_.least_cutoff_hz + settings_.cutoff_per_speed * std::abs(speed);
  const float filtered = last_->value + Share(cutoff_hz, dt_s) * (value - last_->value);
  last_ = Last{at, filtered, speed};
  return filtered;
}

}  // namespace kaori::lips
