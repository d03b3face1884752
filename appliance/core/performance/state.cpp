#include "appliance/core/performance/state.h"

#include <algorithm>
#include <initializer_list>

namespace kaori::performance {
namespace {

constexpr float kFarTurn_rad = 20;  // No head, gaze or tip of hair of a sound state is turned so far,
// no tip swings so fast: a spring of 2 Hz within a third of a radian stays far below,
constexpr float kFastTurn_rad_s = 1e4F;
// and no head is so far from its rest, in metres: leaning in is 0.12.
constexpr float kFarShift_m = 1;

constexpr float kFarMove =
    kVoices * show::kWidestMotion * show::kMostTakeGain;  // All voices together, as far as each may go.

// False for NaN too: every comparison with it is.
bool Within(std::initializer_list<float> values, float low, float high) {
  return std::ranges::all_of(values, [=](float v) { return v >= low && v <= high; });
}

bool Within(const glm::vec2& v, float far) {
  return Within({v.x, v.y}, -far, far);
}
bool Within(const glm::vec3& v, float far) {
  return Within({v.x, v.y, v.z}, -far, far);
}

// A fade that lasts longer than any show allows would hold the face for ever.
bool IsValidFade(float progress, float duration_s) {
  return Within({progress}, 0, 1) && Within({duration_s}, 0, show::kLongestCueFade_s);
}

// What such a fade goes to lies within 0 and `most`, in its own unit.
bool IsValidFading(const Fading& f, float most) {
  return Within({f.from, f.to}, 0, most) && IsValidFade(f.progress, f.duration_s);
}

// A cue is pending in every phase but kIdle. `standby` may be one beyond the last cue: the list is over then.
bool IsValidCueRun(const CueRun& run, const show::CueList& list) {
  const auto count = static_cast<std::int32_t>(list.cues.size());
  const bool waits = run.phase != CueRun::Phase::kIdle;
  return run.active >= -1 && run.active < count && run.standby >= 0 && run.standby <= count &&
         run.pending >= -1 && run.pending < count && run.phase <= CueRun::Phase::kPerson &&
         waits == (run.pending >= 0) &&
         Within({run.left_s, run.held_s}, 0, show::kLongestWait_s + show::kLongestCueFade_s) &&
         Within({run.look_off_rad}, 0, kNoLook_rad) && run.paused <= 1 && run.panicking <= 1 &&
         Within({run.since_refused_s}, 0, kLongAgo_s);
}

// The bounds leave room for rounding: weights were normalised once a call.
bool IsValidTerms(const face::Terms& terms, std::size_t count) {
  if (static_cast<unsigned>(terms.size()) > face::Terms::kCapacity) return false;  // Nor below 0.
  const auto sound = [count](const face::Term& t) {
    return t.index < count && Within({t.weight}, 0, 1.001F);
  };
  return std::ranges::all_of(terms, sound) && (terms.empty() || Within({terms.sum()}, 0.99F, 1.01F));
}

bool IsValidMixture(const Mixture& mixture, std::size_t count) {
  return mixture.to < count && IsValidFade(mixture.progress, mixture.duration_s) &&
         mixture.curve <= show::FadeCurve::kSlowEnd && IsValidTerms(mixture.from, count);
}

// Something that the show has and that can be kept, by a control that there is.
bool IsValidKept(const Kept& kept, const show::Show& show) {
  if (kept.call.kind == show::CallKind::kNothing) return true;
  const std::size_t count = kept.call.kind == show::CallKind::kFace         ? show.cast.faces.size()
                            : kept.call.kind == show::CallKind::kExpression ? show.cast.expressions.size()
                                                                            : show::kSheetCount;
  return show::Joins(kept.call.kind) && kept.call.index < count &&
         (kept.call.mode == show::CallMode::kToggle || kept.call.mode == show::CallMode::kMomentary) &&
         kept.control < kFirstKeyControl + show::kKeyUsages && kept.on <= 1 &&
         kept.curve <= show::FadeCurve::kSlowEnd && Within({kept.from, kept.progress}, 0, 1) &&
         Within({kept.duration_s}, 0, show::kLongestItemFade_s);
}

// Each within its own range: a value beyond its end would leap to it at the first turn of the dial.
bool IsValidKnobs(const State& s) {
  for (std::size_t i = 0; i < s.knobs.size(); ++i)
    if (!Within({s.knobs[i], s.shown[i]}, show::kLevels[i].low, show::kLevels[i].high)) return false;
  return true;
}

// What eases out may be as long as the range, and dials count as far; times are bounded as those of fades.
bool IsValidLevel(const LevelNow& now, const show::LevelInfo& info, std::size_t roles) {
  constexpr float kLongest_s = show::kLongestHandover_s + 10;
  const float span = info.high - info.low;
  return Within({now.value, now.remote}, std::min(info.low, 0.0F), info.high) &&
         Within({now.base, now.offset}, -2 * span, 2 * span) &&
         Within({now.ease_s, now.eased_s, now.rest_s, now.remote_left_s}, 0, kLongest_s) &&
         static_cast<std::uint8_t>(now.owner) < kOwnerCount &&
         (now.owner != Owner::kHand || now.role < roles) && now.put <= 1;
}

// `way` and `anchor` are of the control; `value` is in its level's own unit, and no level goes so far in any.
bool IsValidMap(const MapNow& now) {
  return Within({now.way, now.anchor}, -1, 1) && Within({now.value}, -kFarTurn_rad, kFarTurn_rad) &&
         Within({now.untaken_s}, 0, 10) && now.known <= 1;
}

bool IsValidLevels(const State& s, const show::Show& show) {
  for (std::size_t i = 0; i < s.levels.size(); ++i)
    if (!IsValidLevel(s.levels[i], show::kLevels[i], show.roles.roles.size())) return false;
  return std::ranges::all_of(s.maps, IsValidMap) &&
         std::ranges::all_of(s.role_devices, [](std::uint8_t device) { return device <= kNoRole; });
}

bool IsValidSway(const Sway& sway) {
  return Within(sway.angle_rad, kFarTurn_rad) && Within(sway.head_rad, kFarTurn_rad) &&
         Within(sway.speed_rad_s, kFastTurn_rad_s);
}

// The bounds are many turns wide, since motions add to the sticks. They are to stop what would overflow the
// trigonometry, not to judge a pose.
bool IsValidPose(const State& s) {
  return Within({s.head.yaw_rad, s.head.pitch_rad, s.head.roll_rad, s.gaze.yaw_rad, s.gaze.pitch_rad},
                -kFarTurn_rad, kFarTurn_rad) &&
         Within(s.head.shift_m, kFarShift_m) && Within({s.brow}, -1, 1) &&
         std::ranges::all_of(s.sway, IsValidSway) && std::ranges::all_of(s.chains, [](const Chain& chain) {
           return IsValidSway(chain.upper) && IsValidSway(chain.lower);
         });
}

// Clocks that count seconds stop at 10 (see State), so that anything else was not written by this program.
bool IsValidClocks(const State& s) {
  const auto stick = [](const StickNow& n) { return Within({n.presence}, 0, 1) && n.lost_s >= 0; };
  return Within({s.age_s}, 0, kLifePeriod_s) && std::ranges::all_of(s.sticks, stick) &&
         Within({s.blink_s[0], s.blink_s[1], s.mouth_quiet_s, s.lips_lost_s}, 0, 10) &&
         Within({s.blackout}, 0, 1) && Within({s.since_locked_out_s}, 0, kLongAgo_s) &&
         Within({s.go_quiet_s, s.jump_quiet_s}, 0, kLongSinceGo_s) && s.locked <= 1 &&
         s.locked_out_button < show::kAllButtonCount && s.black_wanted <= 1 && s.black_called <= 1 &&
         Within({s.lids_held[0], s.lids_held[1], s.mouth_open, s.mouth_wide, s.mouth_drive, s.mouth_said,
                 s.mouth_voice},
                0, 1);
}

bool IsValidLayer(const LayerNow& now) {
  return Within({now.under, now.over, now.has, now.covers}, 0, 1) && Within({now.moved}, 0, kFarMove);
}

// A motion of -1 is a free voice. One second more than the longest motion is what a last step may add.
bool IsValidVoices(const State& s, const show::Show& show) {
  return std::ranges::all_of(s.voices, [&show](const Playing& v) {
    return v.motion < static_cast<int>(show.motions.size()) &&
           Within({v.at_s}, 0, show::kLongestMotion_s + 1) && Within({v.gain}, 0, 1) &&
           Within({v.size}, 0, show::kMostTakeGain) && v.layer <= show::MotionLayer::kOver && v.ends <= 1;
  });
}

}  // namespace

// A show without scenes has no backdrops to mix, and nothing is painted from that mixture then (animate.cpp).
bool IsValid(const State& state, const show::Show& show) {
  return IsValidMixture(state.faces, show.cast.faces.size()) &&
         IsValidMixture(state.expressions, show.cast.expressions.size()) &&
         IsValidMixture(state.styles, scene::kStyleCount) &&
         (show.scenes.empty() || IsValidMixture(state.backdrops, show.scenes.size())) &&
         IsValidFading(state.exposure, show::kMostExposure) && IsValidKnobs(state) &&
         IsValidLevels(state, show) && IsValidPose(state) && IsValidClocks(state) &&
         IsValidFading(state.cue_light, 1) && IsValidFading(state.present, 1) &&
         std::ranges::all_of(state.kept, [&](const Kept& kept) { return IsValidKept(kept, show); }) &&
         state.sheet < show::kSheetCount && IsValidCueRun(state.cue_run, show.cue_list) &&
         IsValidVoices(state, show) && std::ranges::all_of(state.layers, IsValidLayer) &&
         IsValidLife(state.life, show.gaze_targets.size()) && IsValidLobby(state.lobby, show) &&
         (show.scenes.empty() || state.scene < show.scenes.size());
}

}  // namespace kaori::performance
