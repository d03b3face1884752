#include "appliance/programs/lips/voice/delay_choice.h"

#include <algorithm>
#include <cstdlib>

#include "appliance/core/board/mouth.h"
#include "appliance/programs/lips/voice/delay_line.h"
#include "appliance/programs/lips/voice/voice_mouth.h"
#include "drivers/base/number.h"

namespace kaori::voice {
namespace {

using std::chrono::milliseconds;

// The delay before anything was measured: that of a camera and a screen of 60 Hz.
constexpr Duration kUsual = milliseconds(70);
constexpr Duration kClose = milliseconds(3);  // A smaller difference changes nothing.
// How long another measurement must stand before it is used: the delay is not to wander with every figure,
// since each change is heard.
constexpr Duration kStands = std::chrono::seconds(1);
constexpr Duration kFresh = std::chrono::seconds(2);  // The stage measures once a second.
// An opening mouth is measured too small until the filter of the lips follows its speed. Measured with claps
// of the lips, as kVoiceMouthLag is.
constexpr Duration kLipsFilterLag = milliseconds(2);

// The stage measures from what the camera sees, or from the voice where that has the mouth, until the screen
// shows it; what lies before that in this program is added here.
std::optional<Duration> Measured(const board::Snapshot& board, Time now) {
  const auto& status = board.stage_status;
  if (status.source != board::SourceState::kLive || now - status.at > kFresh) return std::nullopt;
  if (status.value.mouth_lag == Duration{}) return std::nullopt;
  const bool lips = board.lips.source == board::SourceState::kLive && board::IsUsable(board.lips.value);
  return std::clamp<Duration>(status.value.mouth_lag + (lips ? kLipsFilterLag : kVoiceMouthLag), Duration{},
                              kLongestDelay);
}

Duration Milliseconds(float ms) {
  return FromSeconds(static_cast<double>(ms) / 1e3);
}

}  // namespace

// "off" is no delay; it is told apart before (lips/sound_options.cpp) and is named in the message only.
Result<DelaySetting> ParseDelay(std::string_view text) {
  if (text == "auto") return DelaySetting();
  const auto ms = ParseNumber<double>(text);
  if (!ms || !(*ms >= 0 && *ms <= 500))
    return FailInput("--sound-delay " + std::string(text) + ": expected auto, off, or 0 to 500 milliseconds");
  return DelaySetting(FromSeconds(*ms / 1e3));
}

// A delay that a person had asked for comes from the settings again, and not from the board.
DelayChoice::DelayChoice(const DelaySetting& setting, const board::Stamped<board::Sound>& before)
    : setting_(setting), chosen_(setting.value_or(kUsual)) {
  const bool measured = before.source != board::SourceState::kAbsent && before.value.automatic == 1;
  if (!setting && measured) chosen_ = std::min(Milliseconds(before.value.asked_ms), kLongestDelay);
}

// Without a setting the delay stays as it is, until a measurement has stood for long enough.
void DelayChoice::Use(const DelaySetting& setting) {
  setting_ = setting;
  if (setting) chosen_ = *setting;
}

// A measurement that is close to the chosen delay ends the wait for another one, so that a single
// odd figure starts nothing.
Duration DelayChoice::Choose(const board::Snapshot& board, Time now) {
  if (setting_) return chosen_;
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
