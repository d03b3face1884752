// From a voice to the mouth that it would make: loud opens, the vowel shapes, silence shuts.
#pragma once

#include "appliance/core/board/sections.h"
#include "appliance/programs/lips/voice/listener.h"

namespace kaori::voice {

// How far what VoiceMouth says is behind the sound, in the mean: the moment that a vowel is told from, and
// the smoothing.
inline constexpr Duration kVoiceMouthLag = std::chrono::milliseconds(13);

// Pure: time is in the voice.
class VoiceMouth {
 public:
  const board::Voice& Follow(const Voice& voice);
  const board::Voice& mouth() const { return mouth_; }

 private:
  board::Voice mouth_;
  Time at_{};
};

}  // namespace kaori::voice
