// From a microphone's blocks to a voice: how loud, whether it speaks, and which vowel.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "appliance/programs/lips/voice/loudness.h"
#include "appliance/programs/lips/voice/vowel.h"
#include "drivers/ports/microphone.h"

namespace kaori::voice {

struct Voice {
  Time at{};  // Of the newest frame that was heard.
  float level_db = kSilent_db;
  bool speaking = false;
  std::optional<VowelGuess> vowel;  // Of the last 30 ms; while speaking only.
};

// Blocks at 48 kHz. One thread. Allocates nothing.
class Listener {
 public:
  explicit Listener(const GateSettings& settings = {}) : gate_(settings) {}

  // Frames that were lost (xrun) leave a gap that sounds like nothing.
  const Voice& Hear(const ports::SoundBlock& block, const ports::SoundFormat& format);
  void Use(const GateSettings& gate) { gate_.Use(gate); }
  const Voice& voice() const { return voice_; }

 private:
  static constexpr std::size_t kTaps = 65;     // Of the low pass before three frames of four are left out.
  static constexpr std::size_t kMoment = 360;  // 30 ms at kVoiceRate_hz.

  void AddSample(float sample);
  float LowPassed() const;

  Gate gate_;
  Voice voice_;
  std::array<float, kTaps> recent_{};    // At 48 kHz, the oldest first.
  std::array<float, kMoment> moment_{};  // At kVoiceRate_hz, the oldest first.
  int phase_ = 0;
};

}  // namespace kaori::voice
