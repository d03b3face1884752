// From a voice to a mouth that fits it: loudness opens it, the vowel shapes it, and silence shuts it. The
// mouth of a voice is a guess. The performance uses it only while the lips are not seen
// (performance/mouth.h).
#pragma once

#include "appliance/core/board/sections.h"
#include "appliance/programs/lips/voice/listener.h"

namespace kaori::voice {

// The mean lag of the mouth behind the sound: the moment from which a vowel is recognised, and the smoothing.
// Measured with claps; DelayChoice adds it to the delay of the voice.
inline constexpr Duration kVoiceMouthLag = std::chrono::milliseconds(13);

// Pure: time is in the argument. One thread. The mouth is in board::Voice's terms: height 0 shut .. 1 open,
// width 0 narrow .. 1 wide.
class VoiceMouth {
 public:
  // Moves the mouth to that of `voice`, at its time.
  const board::Voice& Follow(const Voice& voice);
  const board::Voice& mouth() const { return mouth_; }

 private:
  board::Voice mouth_;
  Time at_{};
};

}  // namespace kaori::voice
