// The delay of the voice on its way to the loudspeaker: as it is set, or as long as a mouth takes to be
// presented.
#pragma once

#include <optional>
#include <string_view>

#include "appliance/core/board/snapshot.h"
#include "drivers/base/clock.h"
#include "drivers/base/result.h"

namespace kaori::voice {

// The delay that is set; empty: the measured one.
using DelaySetting = std::optional<Duration>;

// Parses "auto", or milliseconds from 0 to 500. Errors:
//   invalid_argument  anything else; the message names the text
Result<DelaySetting> ParseDelay(std::string_view text);

// Decides, block by block, how late the voice is played. Pure: time is in the arguments. One thread.
class DelayChoice {
 public:
  // Goes on with the measured delay of `before`, the section of the program's last run, if there is one.
  DelayChoice(const DelaySetting& setting, const board::Stamped<board::Sound>& before);

  // Returns the delay for the sound from `now` on. A measured delay is used once it was stable for a second.
  // Between 0 and kLongestDelay. Reads the sections `stage_status` and `lips` of the snapshot.
  Duration Choose(const board::Snapshot& board, Time now);

  // Changes the setting, from the next sound on.
  void Use(const DelaySetting& setting);
  // The delay that was chosen last; whether it is the measurement that chooses; and whether it has measured
  // anything yet, since before that a usual delay of 70 ms is used.
  Duration chosen() const { return chosen_; }
  bool automatic() const { return !setting_; }
  bool measured() const { return !setting_ && measured_; }

 private:
  DelaySetting setting_;
  Duration chosen_;
  // chosen_ comes from a measurement of this run.
  bool measured_ = false;
  std::optional<Duration> other_;  // Another delay that is being measured,
  Time other_since_{};             // and since when.
};

}  // namespace kaori::voice
