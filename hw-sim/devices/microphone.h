// The simulated microphone: hears a voice made by rule, in blocks of five milliseconds.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "drivers/ports/microphone.h"
#include "hw-sim/devices/operator_action.h"
#include "hw-sim/devices/voice_synth.h"

namespace kaori::sim {

// Hears in real time, whoever listens. It is a crystal of its own: with a drift its frames come earlier
// or later than the clock has them. One thread.
class Microphone {
 public:
  // 5 ms, the period that the box asks sound cards for.
  static constexpr int kBlockFrames = 240;

  // Begins to hear at the context's present time. Borrows the context.
  explicit Microphone(const DeviceContext& context) : context_(context), start_(context.clock.now()) {}

  // Test's side. The voice from now on; `vowel` is 0 to 4 for a, i, u, e, o,
  // `loudness` as VoiceSynth has it.
  void Say(int vowel, double loudness);
  void Stall(bool stalled);    // No blocks while stalled; their frames are lost.
  void SetDrift(double ppm);   // Its crystal runs so much faster, from now on.
  void LoseBlocks(int count);  // The next ones never come, and the one after them says so.
  int vowel() const { return synth_.vowel(); }
  double loudness() const { return synth_.loudness(); }
  bool stalled() const { return stalled_; }

  // Appliance's side.
  ports::SoundFormat format() const { return {kSynthRate_hz, 1}; }
  // What is sent in one packet.
  struct Block {
    Time at{};          // When its first frame was heard.
    bool lost = false;  // Frames were lost before it.
    std::vector<std::int16_t> samples;
  };
  // The next block that has been heard wholly by `now`; nothing: none has.
  // Called again until there is none.
  std::optional<Block> NextBlock(Time now);
  // When the next block will have been heard, by the crystal.
  Time next_due() const;
  // Nobody listens: what was heard until `now` is gone. Blocks of another listener begin where these end.
  void Drop(Time now);

 private:
  // When a frame was heard, by the crystal as it runs since `start_`.
  Time TimeOf(std::int64_t frame) const;
  // Makes the samples up to `now`.
  void HearUntil(Time now);

  const DeviceContext& context_;
  // Makes the samples, in the order of time.
  VoiceSynth synth_;
  Time start_;              // When frame `first_` was heard,
  std::int64_t first_ = 0;  // since which the crystal is what it is.
  // How much faster the crystal runs, in millionths.
  double ppm_ = 0;
  std::int64_t heard_ = 0;  // Frames since the beginning.
  // Heard, and not yet sent.
  std::vector<std::int16_t> waiting_;
  // Blocks that are to be lost still.
  int to_lose_ = 0;
  // The next block tells of it, once.
  bool lost_ = false;
  bool stalled_ = false;
};

}  // namespace kaori::sim
