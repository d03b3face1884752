#include "appliance/programs/stage/mouth_clock.h"

#include <algorithm>

#include "appliance/core/board/mouth.h"
#include "appliance/core/performance/mouth.h"

namespace kaori::stage {
namespace {

constexpr Duration kOldest = std::chrono::milliseconds(500);  // Older ones move no mouth.

}  // namespace

// A stamp of the future counts as new.
void MouthClock::Mean::Add(Duration age) {
  sum += std::max(age, Duration{});
  ++count;
}

// Lips that cannot be used move no mouth and have no age; a silent voice has one, since it shuts the mouth.
void MouthClock::Present(std::uint64_t frame, const board::Snapshot& board, const performance::State& state) {
  const bool seen = board.lips.source == board::SourceState::kLive && board::IsUsable(board.lips.value);
  frame_ = frame;
  lips_at_ = seen ? board.lips.at : Time{};
  voice_at_ = board.voice.source == board::SourceState::kLive ? board.voice.at : Time{};
  shown_ = state;
}

// A picture stands until the next one: in the mean it is half a period older than when it was presented.
void MouthClock::Flip(const ports::Flip& flip) {
  if (flip.frame != frame_) return;
  const auto count = [&flip](Mean& mean, Time at, Duration more) {
    if (at != Time{} && flip.at - at < kOldest) mean.Add(flip.at - at + more);
  };
  count(lips_, lips_at_, {});
  count(voice_, voice_at_, {});
  count(mouth_, shown_.mouth_voice > 0.5F ? voice_at_ : lips_at_,
        flip.period / 2 + performance::MouthLag(shown_, flip.period));
}

// What nothing was measured of is 0, and the sums begin anew.
void MouthClock::Report(board::StageStatus& into) {
  into.lips_age = lips_.mean();
  into.voice_age = voice_.mean();
  into.mouth_lag = mouth_.mean();
  lips_ = voice_ = mouth_ = {};
}

}  // namespace kaori::stage
