// The 1 Euro filter (Casiez, Roussel, Vogel: CHI 2012): a low pass that is strong at rest and weak in motion.
#pragma once

#include <optional>

#include "drivers/base/clock.h"

namespace kaori::lips {

// Units of the value are the caller's: here widths of the mouth at rest.
struct OneEuroSettings {
  float least_cutoff_hz = 6;    // The cut-off of a value at rest; lower is stiller.
  float cutoff_per_speed = 20;  // More Hz for each unit per second of speed; higher follows sooner.
  friend bool operator==(const OneEuroSettings&, const OneEuroSettings&) = default;
};

// One filter for one value. Plain, and deterministic: time is in the argument.
class OneEuro {
 public:
  explicit OneEuro(OneEuroSettings settings = {}) : settings_(settings) {}

  // Returns the filtered value at `at`. The first value passes unfiltered, and so does one after a gap of
  // more than a second or with a time that is not later than the last.
  float Filter(float value, Time at);
  // Forgets the past: the next value passes unfiltered.
  void Reset() { last_.reset(); }

 private:
  // The last value as it was given, and its speed, filtered, in units a second.
  struct Last {
    Time at;
    float value;
    float speed;
  };
  OneEuroSettings settings_;
  std::optional<Last> last_;
};

}  // namespace kaori::lips
