#include "appliance/programs/lips/voice/delay_choice.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>

#include "appliance/programs/lips/voice/sound_line.h"
#include "appliance/programs/lips/voice/voice_mouth.h"

namespace kaori::voice {
namespace {

using std::chrono::milliseconds;

constexpr Duration kUsual =
    milliseconds(70);                         // Before anything was measured: a camera and a screen of 60 Hz.
constexpr Duration kClose = milliseconds(3);  // What is this close is no news.
constexpr Duration kStands = std::chrono::seconds(1);
constexpr Duration kFresh = std::chrono::seconds(2);  // The stage measures once a second.
// A mouth that opens is measured smaller than it is until the filter of the lips knows that it moves. Seen on
// claps, as kVoiceMouthLag is.
constexpr Duration kLipsFilterLag = milliseconds(2);

std::optional<Duration> Measured(const board::Snapshot& board, Time now) {
  const auto& status = board.stage_status;
  if (status.source != board::SourceState::kLive || now - status.at > kFresh) return std::nullopt;
  if (status.value.mouth_lag == Duration{}) return std::nullopt;
  const bool lips = board.lips.source == board::SourceState::kLive && board.lips.value.quality > 0;
  return std::clamp<Duration>(status.value.mouth_lag + (lips ? kLipsFilterLag : kVoiceMouthLag), Duration{},
                              kLongestDelay);
}

Duration Milliseconds(float ms) {
  return FromSeconds(static_cast<double>(ms) / 1e3);
}

}  // namespace

Result<DelayWish> ParseDelay(std::string_view text) {
  if (text == "auto") return DelayWish();
  double ms = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), ms);
  if (error != std::errc{} || end != text.data() + text.size() || !(ms >= 0 && ms <= 500))
    return FailInput("a sound delay of " + std::string(text) +
                     ": auto, off, or 0 to 500 milliseconds are wanted");
  return DelayWish(FromSeconds(ms / 1e3));
}

DelayChoice::DelayChoice(const DelayWish& wish, const board::Stamped<board::Sound>& before)
    : wish_(wish), chosen_(wish.value_or(kUsual)) {
  const bool measured = before.source != board::SourceState::kAbsent && before.value.automatic == 1;
  if (!wish && measured) chosen_ = std::min(Milliseconds(before.value.asked_ms), kLongestDelay);
}

void DelayChoice::Use(const DelayWish& wish) {
  wish_ = wish;
  if (wish) chosen_ = *wish;
}

Duration DelayChoice::Choose(const board::Snapshot& board, Time now) {
  if (wish_) return chosen_;
  const auto measured = Measured(board, now);
  const auto close = [&](Duration to) { return std::abs((*measured - to).count()) <= kClose.count(); };
  if (measured && close(chosen_)) measured_ = true;
  if (!measured || close(chosen_)) {
    other_.reset();
  } else if (!other_ || !close(*other_)) {
    other_ = measured;
    other_since_ = now;
  } else if (now - other_since_ >= kStands) {
    chosen_ = *measured;
    measured_ = true;
    other_.reset();
  }
  return chosen_;
}

}  // namespace kaori::voice
