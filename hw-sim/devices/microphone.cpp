#include "hw-sim/devices/microphone.h"

#include <algorithm>
#include <utility>

namespace kaori::sim {
namespace {

// Of a longer sleep only the last second is heard: making hours of sound would take seconds.
constexpr std::int64_t kMostAtOnce = kSynthRate_hz;

}  // namespace

// What was heard before is heard with the voice that it had.
void Microphone::Say(int vowel, double loudness) {
  HearUntil(context_.clock.now());
  const int vowel_before = synth_.vowel();
  const double loudness_before = synth_.loudness();
  synth_.Say(vowel, loudness);
  if (synth_.vowel() != vowel_before || synth_.loudness() != loudness_before)
    context_.Notify({DevicePort::kMicrophone, Verb::kVoice, synth_.vowel(), synth_.loudness(), 0});
}

void Microphone::Stall(bool stalled) {
  if (std::exchange(stalled_, stalled) == stalled) return;
  // What was said while it stalled is not delivered afterwards.
  if (!stalled) Drop(context_.clock.now());
  context_.Notify({DevicePort::kMicrophone, Verb::kStall, stalled ? 1 : 0, 0, 0});
}

void Microphone::SetDrift(double ppm) {
  HearUntil(context_.clock.now());
  // The crystal changes from here on; frames before keep their times.
  start_ = TimeOf(heard_);
  first_ = heard_;
  ppm_ = ppm;
}

void Microphone::LoseBlocks(int count) {
  to_lose_ += count;
}

Time Microphone::TimeOf(std::int64_t frame) const {
  return start_ + FromSeconds(static_cast<double>(frame - first_) / (kSynthRate_hz * (1 + ppm_ * 1e-6)));
}

// The voice is made sample by sample up to `now`; nothing is made twice.
void Microphone::HearUntil(Time now) {
  const auto until =
      first_ + static_cast<std::int64_t>(Seconds(now - start_) * kSynthRate_hz * (1 + ppm_ * 1e-6));
  if (until - heard_ > kMostAtOnce) {
    heard_ = until - kMostAtOnce;
    lost_ = true;
    waiting_.clear();
  }
  for (; heard_ < until; ++heard_) waiting_.push_back(synth_.Next());
}

// Blocks that are to be lost are made and dropped, so that the voice goes on behind them.
std::optional<Microphone::Block> Microphone::NextBlock(Time now) {
  HearUntil(now);
  while (waiting_.size() >= kBlockFrames) {
    Block block{TimeOf(heard_ - static_cast<std::int64_t>(waiting_.size())),
                lost_,
                {waiting_.begin(), waiting_.begin() + kBlockFrames}};
    waiting_.erase(waiting_.begin(), waiting_.begin() + kBlockFrames);
    const bool loses = stalled_ || to_lose_ > 0;
    // A stalled microphone loses blocks anyway: those that are to be lost come after it.
    if (to_lose_ > 0 && !stalled_) --to_lose_;
    lost_ = loses;
    if (!loses) return block;
  }
  return std::nullopt;
}

Time Microphone::next_due() const {
  const auto missing = kBlockFrames - static_cast<std::int64_t>(waiting_.size());
  return TimeOf(heard_ + std::max<std::int64_t>(missing, 1));
}

void Microphone::Drop(Time now) {
  HearUntil(now);
  waiting_.clear();
}

}  // namespace kaori::sim
