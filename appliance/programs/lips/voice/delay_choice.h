// How long the voice waits on its way to the loudspeaker: as a hand says, or as long as the mouth takes to
// the light.
#pragma once

#include <optional>
#include <string_view>

#include "appliance/core/board/snapshot.h"
#include "drivers/base/clock.h"
#include "drivers/base/result.h"

namespace kaori::voice {

// None: as measured.
using DelayWish = std::optional<Duration>;

// "auto", or milliseconds from 0 to 500. Errors: invalid_argument.
Result<DelayWish> ParseDelay(std::string_view text);

// Pure: time is in the arguments.
class DelayChoice {
 public:
  // Goes on with what was measured before, if that is there.
  DelayChoice(const DelayWish& wish, const board::Stamped<board::Sound>& before);

  // The delay for the sound from `now` on. What is measured is believed when it stood for a second.
  Duration Choose(const board::Snapshot& board, Time now);

  void Use(const DelayWish& wish);
  Duration chosen() const { return chosen_; }
  bool automatic() const { return !wish_; }
  bool measured() const { return !wish_ && measured_; }

 private:
  DelayWish wish_;
  Duration chosen_;
  bool measured_ = false;
  std::optional<Duration> other_;  // What is measured instead,
  Time other_since_{};             // and since when.
};

}  // namespace kaori::voice
