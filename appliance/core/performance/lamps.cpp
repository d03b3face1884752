#include "appliance/core/performance/lamps.h"

#include <algorithm>
#include <cmath>

#include "appliance/core/performance/kept.h"
#include "appliance/core/performance/motions.h"

namespace kaori::performance {
namespace {

using show::CallKind;

// Periods, and the part of each in which the lamp is lit: a fade breathes, a cue that waits blinks.
constexpr float kBreath_s = 1, kBreathLit = 0.75F;
constexpr float kBlink_s = 0.5F, kBlinkLit = 0.5F;
// Two changes and back within half a second: whoever pushed sees that it was refused.
constexpr float kRefusal_s = 0.125F;
constexpr int kRefusals = 4;

bool IsInLitPart(float since_s, float period_s, float lit) {
  return std::fmod(since_s, period_s) < lit * period_s;
}

// What was called last; what still fades out has no lamp any more.
Lamp LampOfMixture(const Mixture& mixture, std::uint16_t index) {
  if (mixture.to != index) return Lamp::kOff;
  return mixture.progress < 1 ? Lamp::kBreathing : Lamp::kLit;
}

// GO is lit while a cue stands by, and dark when the list is over. BACK and STOP happen at once and leave nothing
// to show.
Lamp LampOfVerb(const State& state, show::CueVerb verb, const show::Show& show) {
  const CueRun& run = state.cue_run;
  const auto lit = [](bool on) { return on ? Lamp::kLit : Lamp::kOff; };
  switch (verb) {
    case show::CueVerb::kGo:
      if (run.pending >= 0) return Lamp::kBlinking;
      return lit(run.standby >= 0 && run.standby < static_cast<std::int32_t>(show.cue_list.cues.size()));
    case show::CueVerb::kPause:
      return lit(run.paused != 0);
    case show::CueVerb::kPanic:
      return lit(run.panicking != 0);
    case show::CueVerb::kBlackout:
      return lit(state.black_called != 0);
    case show::CueVerb::kBack:
    case show::CueVerb::kStop:
      break;
  }
  return Lamp::kOff;
}

// A jump to a cue: it was played last, or it stands by.
Lamp LampOfJump(const CueRun& run, std::int32_t cue) {
  if (run.active == cue) return Lamp::kLit;
  return run.standby == cue ? Lamp::kBlinking : Lamp::kOff;
}

// Of one that two controls keep: the one that is on.
const Kept* KeptBy(const State& state, const show::Call& call) {
  const Kept* found = nullptr;
  for (const Kept& kept : state.kept)
    if (kept.call == call && (found == nullptr || kept.on > found->on)) found = &kept;
  return found;
}

Lamp LampOfKept(const Kept* kept) {
  if (kept == nullptr) return Lamp::kOff;
  return kept->progress < 1 ? Lamp::kBreathing : Lamp::kLit;
}

// Since what the button calls began to come or to go.
float FadeTime(const State& state, const show::Call& call) {
  if (call.mode != show::CallMode::kCall) {
    const Kept* kept = KeptBy(state, call);
    return kept == nullptr ? 0 : kept->progress * kept->duration_s;
  }
  const Mixture& mixture = call.kind == CallKind::kFace         ? state.faces
                           : call.kind == CallKind::kExpression ? state.expressions
                           : call.kind == CallKind::kStyle      ? state.styles
                                                                : state.backdrops;
  return mixture.progress * mixture.duration_s;
}

// While the list is paused fades stand still, and their lamps are steady.
bool IsLit(const State& state, const show::Call& call, const show::Show& show) {
  switch (LampOf(state, call, show)) {
    case Lamp::kOff:
      return false;
    case Lamp::kLit:
      return true;
    case Lamp::kBreathing:
      return state.cue_run.paused != 0 || IsInLitPart(FadeTime(state, call), kBreath_s, kBreathLit);
    case Lamp::kBlinking:
      return IsInLitPart(state.age_s, kBlink_s, kBlinkLit);
  }
  return false;
}

bool IsInRefusal(float since_s) {
  const auto part = static_cast<int>(since_s / kRefusal_s);
  return part < kRefusals && part % 2 == 0;
}

// In every other part of the half second after a GO that was refused.
bool IsRefused(const State& state, const show::Call& call) {
  return call.kind == CallKind::kCue && call.index == static_cast<std::uint16_t>(show::CueVerb::kGo) &&
         IsInRefusal(state.cue_run.since_refused_s);
}

}  // namespace

Lamp LampOf(const State& state, const show::Call& call, const show::Show& show) {
  if (call.kind == CallKind::kSheet) return SheetOf(state) == call.index ? Lamp::kLit : Lamp::kOff;
  if (call.mode != show::CallMode::kCall) return LampOfKept(KeptBy(state, call));
  switch (call.kind) {
    case CallKind::kFace:
      return LampOfMixture(state.faces, call.index);
    case CallKind::kExpression:
      return LampOfMixture(state.expressions, call.index);
    case CallKind::kStyle:
      return LampOfMixture(state.styles, call.index);
    case CallKind::kScene:
      return state.scene == call.index ? LampOfMixture(state.backdrops, call.index) : Lamp::kOff;
    case CallKind::kCue:
      return LampOfVerb(state, static_cast<show::CueVerb>(call.index), show);
    case CallKind::kGoTo:
      return LampOfJump(state.cue_run, call.index);
    case CallKind::kMotion:
      return IsPlaying(state, call.index) ? Lamp::kLit : Lamp::kOff;
    case CallKind::kNothing:
    case CallKind::kSheet:
    case CallKind::kBlink:
      break;
  }
  return Lamp::kOff;
}

// Bit n is button n. A refusal inverts the lamp, whatever it shows.
std::uint32_t LitLamps(const State& state, const show::Show& show) {
  std::uint32_t lamps = 0;
  for (std::size_t i = 0; i < show.buttons.size(); ++i) {
    const show::Call& call = ButtonOf(state, show, i);
    const bool locked_out = i == state.locked_out_button && IsInRefusal(state.since_locked_out_s);
    if (IsLit(state, call, show) != (IsRefused(state, call) || locked_out)) lamps |= 1U << i;
  }
  return lamps;
}

}  // namespace kaori::performance
