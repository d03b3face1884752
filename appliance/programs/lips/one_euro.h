// Still when still, at once when moving: the 1 Euro filter (Casiez, Roussel, Vogel: CHI 2012).
#pragma once

#include <optional>

#include "drivers/base/clock.h"

namespace kaori::lips {

struct OneEuroSettings {
  float least_cutoff_hz = 6;    // Of a value at rest: lower is stiller.
  float cutoff_per_speed = 20;  // Hz more for each unit per second: higher follows sooner.
  friend bool operator==(const OneEuroSettings&, const OneEuroSettings&) = default;
};

class OneEuro {
 public:
  explicit OneEuro(OneEuroSettings settings = {}) : settings_(settings) {}

  // The filtered value at `at`; the first one is taken as it is. Time that stands still or leaps starts anew.
  float Filter(float value, Time at);
  void Reset() { last_.reset(); }

 private:
  struct Last {
    Time at;
    float value;
    float speed;
  };
  OneEuroSettings settings_;
  std::optional<Last> last_;
};

}  // namespace kaori::lips
