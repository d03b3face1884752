// Whether whoever stands before the box asks for a factory reset.
#pragma once

#include <optional>

#include "drivers/base/clock.h"

namespace kaori::data {

// In the first minute of a start somebody holds GO while the service key is on, for 10 s, and lets go of it within the
// next 20: a line that is shorted, or a foot switch on which a case stands, asks for nothing. Pure; one thread.
class ResetRequest {
 public:
  static constexpr Duration kFrom = std::chrono::minutes(1);
  static constexpr Duration kHeld = std::chrono::seconds(10);
  static constexpr Duration kLongest = std::chrono::seconds(30);
  enum class Verdict {
    kWaiting,
    // It has been held for long enough: to be let go.
    kLetGo,
    kAsked,
    // Nobody has asked, and nobody can any more.
    kOver
  };

  // `began` is when the box came up.
  explicit ResetRequest(Time began) : began_(began) {}

  // The key and the line at `now`. kAsked and kOver stand.
  Verdict See(bool key_is_on, bool go_is_held, Time now);

 private:
  Time began_;
  std::optional<Time> held_since_;
  Verdict verdict_ = Verdict::kWaiting;
};

}  // namespace kaori::data
