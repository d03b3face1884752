#include "appliance/core/performance/mouth.h"

#include <algorithm>
#include <cmath>

#include "appliance/core/board/mouth.h"
#include "appliance/core/performance/ease.h"

namespace kaori::performance {
namespace {

constexpr float kDialFrom = 0.01F;  // A dial turned this far takes the mouth.
constexpr float kGivesWayFrom =
    0.5F;  // Lips and voice, to a take of the layer over that has so much of the mouth.
constexpr float kFollowLips_s = 0.012F;   // Lips are in time with a voice: hardly any smoothing.
constexpr float kFollowVoice_s = 0.025F;  // What is heard is a guess, and trembles.
constexpr float kFollowDial_s = 0.04F;
constexpr float kFastest_per_s =
    15;  // No mouth opens faster; where one source takes over from another, it would.
constexpr float kSpeaking = 0.08F;  // Lips that move further than this from rest are speaking,
constexpr float kPause_s = 0.7F;    // and stay so in pauses of this length.
// Half of the 200 ms within which the voice shall move a mouth whose lips are lost; a camera of 15 frames a
// second is never so late. The rest is for the way over.
constexpr float kLipsLost_s = 0.1F;
// The way over, from all of the lips to all of the voice; and how old the voice's last block
// may be until it is lost.
constexpr float kToVoice_s = 0.06F;
constexpr float kVoiceLost_s = 0.25F;
// Clocks of the mouth stop here, as those of State do.
constexpr float kForgotten_s = 10;
// The expression's own mouth gives way so fast. An opening is added sooner while it is small, so that the
// first word after a pause is in time.
constexpr float kGivesWay_per_s = 12, kOpens_per_s = 60, kGivenBack_per_s = 3;

// Where the mouth shall go, as board::MouthPosition (open 0..1, wide 0..1 with 0.5 at rest); the half life
// with which it goes there; and whether somebody speaks: false leaves the mouth to the expression.
struct Target {
  float open = 0;
  float wide = 0.5F;
  float follow_s = kFollowLips_s;
  bool drives = false;
};

// Seconds from `at` to the time of the last frame, bounded: a stamp of the future counts as now.
float Age_s(const State& state, Time at) {
  return std::clamp(static_cast<float>(Seconds(state.last - at)), 0.0F, kForgotten_s);
}

// Whether the lips can be followed: the camera works and sees a usable mouth.
bool Seen(const board::Stamped<board::Lips>& lips) {
  return lips.source == board::SourceState::kLive && board::IsUsable(lips.value);
}

// Whether a microphone works. Silence is heard too: it shuts the mouth.
bool Heard(const State& state, const board::Stamped<board::Voice>& voice) {
  return voice.source == board::SourceState::kLive && Age_s(state, voice.at) < kVoiceLost_s;
}

// How much of the mouth the voice has: it takes the mouth when the lips are lost and gives it back when they
// are seen again. Without a voice the lips keep it, however old they are.
float VoiceShare(State& state, const board::Snapshot& board, float dt_s) {
  state.lips_lost_s =
      Seen(board.lips) ? Age_s(state, board.lips.at) : std::min(kForgotten_s, state.lips_lost_s + dt_s);
  const bool leads = Heard(state, board.voice) && state.lips_lost_s > kLipsLost_s;
  if (leads || Seen(board.lips))
    state.mouth_voice = Travel(state.mouth_voice, leads ? 1.0F : 0.0F, dt_s, 1 / kToVoice_s);
  return SmoothStep(state.mouth_voice);
}

// Whoever is lost leaves the mouth as it is, to be given back to the expression.
Target FromLips(const State& state, const board::Stamped<board::Lips>& lips) {
  if (!Seen(lips)) return {state.mouth_open, state.mouth_wide, kFollowLips_s, false};
  const board::MouthPosition mouth = board::PositionOf(lips.value);
  return {mouth.open, mouth.wide, kFollowLips_s, true};
}

// A microphone that works and hears nothing shuts the mouth; one that is gone leaves it as it is.
Target FromVoice(const State& state, const board::Stamped<board::Voice>& voice) {
  if (!Heard(state, voice)) return {state.mouth_open, state.mouth_wide, kFollowVoice_s, false};
  return {voice.value.height, voice.value.width, kFollowVoice_s, true};
}

// Lips and voice mixed by the voice's share. A mouth that stays near its rest for kPause_s no longer drives:
// the expression's own mouth (a smile) comes back while nobody speaks.
Target FromOperator(State& state, const board::Snapshot& board, float dt_s) {
  const float share = VoiceShare(state, board, dt_s);
  const Target lips = FromLips(state, board.lips), voice = FromVoice(state, board.voice);
  Target target{Mix(lips.open, voice.open, share), Mix(lips.wide, voice.wide, share),
                Mix(lips.follow_s, voice.follow_s, share), lips.drives || voice.drives};
  if (!target.drives) return target;
  const bool speaks = target.open > kSpeaking || std::abs(target.wide - 0.5F) > 2 * kSpeaking;
  state.mouth_quiet_s = speaks ? 0 : std::min(kForgotten_s, state.mouth_quiet_s + dt_s);
  target.drives = state.mouth_quiet_s < kPause_s;
  return target;
}

// A dial that is off its rest has the mouth before all others. The operator's lips are followed meanwhile, so
// that they take over without a jump when the dial is turned back.
Target WhoSpeaks(State& state, const board::Snapshot& board, float dt_s) {
  Target from_operator = FromOperator(state, board, dt_s);
  if (IsMouthByDial(state))
    return {At(state.shown, Knob::kMouth), At(state.shown, Knob::kMouthWidth), kFollowDial_s, true};
  const LayerNow& takes = state.layers[static_cast<std::size_t>(show::Level::kMouthOpen)];
  from_operator.drives = from_operator.drives && takes.covers < kGivesWayFrom;
  return from_operator;
}

}  // namespace

bool IsMouthByDial(const State& state) {
  return At(state.shown, Knob::kMouth) > kDialFrom ||
         std::abs(At(state.shown, Knob::kMouthWidth) - 0.5F) > kDialFrom;
}

// Two shares move with the speech: mouth_drive gives the expression's mouth away and adds the two shut
// shapes; mouth_said adds the two open ones and is faster while the mouth is small. The shapes are weighted
// bilinearly, (1-open or open) x (1-wide or wide), in the order shut narrow, shut wide, open narrow, open
// wide.
void MoveMouth(State& state, const board::Snapshot& board, const show::Channels& channels,
               face::Weights& weights, float dt_s) {
  Target target = WhoSpeaks(state, board, dt_s);
  if (!target.drives && state.mouth_said <= 0) target.open = 0;  // Nobody sees it: the next word begins shut.
  const auto follow = [&](float& now, float to) {
    now = Travel(now, Approach(now, to, dt_s, target.follow_s), dt_s, kFastest_per_s);
  };
  follow(state.mouth_open, target.open);
  follow(state.mouth_wide, target.wide);
  const auto move_share = [&](float& share, float speed_per_s) {
    share = Travel(share, target.drives ? 1.0F : 0.0F, dt_s, target.drives ? speed_per_s : kGivenBack_per_s);
  };
  move_share(state.mouth_drive, kGivesWay_per_s);
  move_share(state.mouth_said, kGivesWay_per_s / std::max(state.mouth_open, kGivesWay_per_s / kOpens_per_s));
  const float drive = SmoothStep(state.mouth_drive);
  weights.mouth_given_away = drive;
  const float open = state.mouth_open, wide = state.mouth_wide;
  const std::array<float, 4> shapes{(1 - open) * (1 - wide), (1 - open) * wide, open * (1 - wide),
                                    open * wide};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const float share = i < 2 ? drive : state.mouth_said;
    if (channels.mouth[i] >= 0 && share * shapes[i] > 0)
      weights.channels.Add(static_cast<std::uint16_t>(channels.mouth[i]), share * shapes[i]);
  }
}

// What does a share of the way that is left in each frame is behind by (1 - share) / share frames in the
// mean. Approach leaves 2^(-frame / half life) of the way in each frame. The bound keeps the sum finite for
// frames that are far shorter than the half life.
Duration MouthLag(const State& state, Duration frame) {
  const double half_life_s = Mix(kFollowLips_s, kFollowVoice_s, state.mouth_voice);
  const double left = std::exp2(-Seconds(frame) / half_life_s);
  return FromSeconds(Seconds(frame) * left / (1 - std::min(left, 0.99)));
}

}  // namespace kaori::performance
