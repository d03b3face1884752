// A microphone, the voice's way through the box, and a loudspeaker, on one simulated clock.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <optional>
#include <vector>

#include "appliance/programs/lips/voice/voice_service.h"
#include "drivers/audio/local_loudspeaker.h"
#include "drivers/audio/local_microphone.h"
#include "tests/hw-sim/link_fixture.h"

namespace kaori::voice {

class VoiceFixture : public ::testing::Test {
 protected:
  void SetUp() override { Open(std::chrono::milliseconds(100), {}); }

  void Open(DelaySetting delay, std::vector<show::Sound> clips) {
    service_.reset();
    rig_.reset();
    rig_ = sim::Rig::Open({.folder = links_.path(), .screen_width_px = 64, .screen_height_px = 48}, clock_)
               .value();
    service_ =
        VoiceService::Acquire({[this] { return audio::LocalMicrophone::Open(links_.path()); },
                               [this] { return audio::LocalLoudspeaker::Open(links_.path(), clock_); }},
                              {{}, {delay, std::move(clips)}}, board_, clock_)
            .value();
  }

  // Devices speak every millisecond, or when `pumps` says so.
  void Run(Duration time) {
    for (const Time end = clock_.now() + time; clock_.now() < end;) {
      clock_.Advance(std::chrono::milliseconds(1));
      if (clock_.now() >= pump_at_) rig_->Pump();
      service_->Step();
      Listen();
    }
  }

  // A syllable now: gives how late it is heard, in ms; nothing: it is not.
  std::optional<double> Syllable() {
    onset_.reset();
    const Time spoken = clock_.now();
    rig_->microphone().Say(0, 1);
    Run(std::chrono::milliseconds(200));
    rig_->microphone().Say(0, 0);
    Run(std::chrono::milliseconds(500));
    if (!onset_) return std::nullopt;
    return Seconds(*onset_ - spoken) * 1e3;
  }

  board::Stamped<board::Voice> voice() const { return board_.Read<board::Voice>(); }
  board::Stamped<board::Sound> sound() const { return board_.Read<board::Sound>(); }
  Time now() const { return clock_.now(); }
  sim::Rig& rig() { return *rig_; }

  void Listen() {
    for (const auto& block : rig_->loudspeaker().DrainHeard())
      for (std::size_t n = 0; n < block.samples.size(); n += 2) {
        const int step = std::abs(int{block.samples[n]} - last_);
        last_ = block.samples[n];
        steepest_ = std::max(steepest_, step);
        if (std::abs(last_) < 1000) continue;
        const Time at = block.at + FromSeconds(block.frame_s * static_cast<double>(n / 2));
        if (!onset_) onset_ = at;
        loud_at_ = at;
      }
  }

  sim::TempFolder links_;
  ManualClock clock_;
  board::Board board_ = board::Board::Create(links_.path() + "/board").value();
  std::unique_ptr<sim::Rig> rig_;
  std::unique_ptr<VoiceService> service_;
  Time pump_at_{};
  std::optional<Time> onset_;  // Of the first loud frame since it was reset,
  Time loud_at_{};             // and the last one.
  int last_ = 0;
  int steepest_ = 0;  // From one frame to the next.
};

}  // namespace kaori::voice
