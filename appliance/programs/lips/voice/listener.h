// From a microphone's blocks to a voice: its level, whether somebody speaks, and which vowel it is. 48 kHz
// become 12 kHz first: vowels lie below 4 kHz, and a quarter of the samples costs a quarter of the work.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "appliance/programs/lips/voice/loudness.h"
#include "appliance/programs/lips/voice/vowel.h"
#include "drivers/ports/microphone.h"

namespace kaori::voice {

struct Voice {
  Time at{};  // The time of the newest frame.
  float level_db = kSilent_db;
  bool speaking = false;
  std::optional<VowelGuess> vowel;  // Of the last 30 ms; only while somebody speaks.
};

// Processes blocks at 48 kHz. Used by one thread; it allocates nothing. It remembers the last 30 ms, over the
// borders of blocks of any length.
class Listener {
 public:
  explicit Listener(const GateSettings& settings = {}) : gate_(settings) {}

  // Processes a block, which is borrowed for the call. Frames that were lost before it (xrun) count as
  // silence. `format` has one or two channels at 48 kHz, as the caller has checked. What it gives holds until
  // the next call.
  const Voice& Hear(const ports::SoundBlock& block, const ports::SoundFormat& format);
  // Changes the gate's settings from the next block on.
  void Use(const GateSettings& gate) { gate_.Use(gate); }
  // The voice as of the last block.
  const Voice& voice() const { return voice_; }

 private:
  static constexpr std::size_t kTaps = 65;     // The taps of the low pass before every fourth sample is kept.
  static constexpr std::size_t kMoment = 360;  // 30 ms at kVoiceRate_hz.

  // Adds a sample at 48 kHz, -1 .. 1; every fourth one brings a sample of the moment.
  void AddSample(float sample);
  float LowPassed() const;

  Gate gate_;
  Voice voice_;
  std::array<float, kTaps> recent_{};    // Samples at 48 kHz, the oldest first.
  std::array<float, kMoment> moment_{};  // Samples at kVoiceRate_hz, the oldest first.
  // Samples since the last one that was kept.
  int phase_ = 0;
};

}  // namespace kaori::voice
