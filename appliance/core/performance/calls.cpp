#include "appliance/core/performance/calls.h"

#include <algorithm>
#include <chrono>

#include "appliance/core/board/keys.h"
#include "appliance/core/performance/blink.h"
#include "appliance/core/performance/cues.h"
#include "appliance/core/performance/levels.h"
#include "appliance/core/performance/lock.h"
#include "appliance/core/performance/motions.h"

namespace kaori::performance {
namespace {

namespace key = board::key;

// kaori-input knows no show, and makes calls of its lines by these numbers alone.
static_assert(static_cast<std::uint32_t>(show::CueVerb::kGo) == board::kCallGo);
static_assert(static_cast<std::uint32_t>(show::CueVerb::kBack) == board::kCallBack);
static_assert(static_cast<std::uint32_t>(show::CueVerb::kPanic) == board::kCallPanic);

// A fresh call takes over whole, whatever its dial said about the one before. The mixture keeps the old
// dial's share as its beginning, so that the change of the dial is not seen either.
void CallWhole(State& state, Mixture& mixture, Knob knob, std::uint16_t index, float fade_s,
               show::FadeCurve curve) {
  Call(mixture, index, fade_s, At(state.shown, knob), curve);
  At(state.knobs, knob) = At(state.shown, knob) = 1;
}

// A scene that is called out of turn. Where the list consists of the scenes, it goes on from there.
void CallScene(State& state, const show::Show& show, std::uint16_t scene) {
  EnterScene(state, show, scene, show.scenes[scene].fade_s);
  if (!show.cue_list.of_scenes) return;
  state.cue_run.active = scene - 1;
  state.cue_run.standby = scene;
}

// A second call of one that loops ends it, since nothing else on its control would.
void CallMotion(State& state, const show::Show& show, std::int32_t motion) {
  if (show.motions[static_cast<std::size_t>(motion)].Loops() && IsPlaying(state, motion))
    EndMotion(state, motion);
  else
    PlayMotion(state, show, motion);
}

// What people and desks call. No guard is between two cues, but the same one again within the list's guard is one
// call: desks send twice. The guard is between two calls, as that of GO.
void CallGoTo(State& state, const show::Show& show, std::int32_t cue, float ago_s) {
  const bool again = state.jumped_to == cue && state.jump_quiet_s - ago_s < show.cue_list.go_guard_s;
  if (again) return;
  state.jumped_to = cue;
  state.jump_quiet_s = ago_s;
  GoToCue(state, show, cue);
}

// The character's eyes, of which the left one lies on the right of the picture.
void CallBlink(State& state, show::Blink which) {
  if (which != show::Blink::kLeft) state.blink_s[0] = BlinkFrom(state.blink_s[0]);
  if (which != show::Blink::kRight) state.blink_s[1] = BlinkFrom(state.blink_s[1]);
}

// Faces and expressions fade as they say themselves; those that say nothing, and styles, as long as the Fade
// dial says; scenes as long as they say themselves. `control` is what was pushed `ago_s` before the frame, as
// Kept has it.
void Obey(State& state, const show::Call& call, std::uint16_t control, const show::Show& show, float ago_s) {
  const float fade_s = At(state.knobs, Knob::kFade);
  if (call.mode == show::CallMode::kToggle) return Toggle(state, show, call, fade_s);
  if (call.mode == show::CallMode::kMomentary) return KeepDown(state, show, call, control, fade_s);
  const show::ItemFade own = show::FadeOf(show, call);
  const float in_s = own.in_s >= 0 ? own.in_s : fade_s;
  switch (call.kind) {
    case show::CallKind::kNothing:
      break;
    case show::CallKind::kFace:
      CallFace(state, call.index, in_s, own.curve);
      break;
    case show::CallKind::kExpression:
      CallExpression(state, call.index, in_s, own.curve);
      break;
    case show::CallKind::kStyle:
      Call(state.styles, call.index, fade_s, 1);
      break;
    case show::CallKind::kScene:
      CallScene(state, show, call.index);
      break;
    case show::CallKind::kCue:
      CallCue(state, show, static_cast<show::CueVerb>(call.index), ago_s);
      break;
    case show::CallKind::kSheet:
      state.sheet = call.index;
      break;
    case show::CallKind::kMotion:
      CallMotion(state, show, call.index);
      break;
    case show::CallKind::kBlink:
      CallBlink(state, static_cast<show::Blink>(call.index));
      break;
    case show::CallKind::kGoTo:
      CallGoTo(state, show, call.index, ago_s);
      break;
  }
}

// A key does all that the show has for it. X shuts the character's left eye and Z the right one, which is how
// they lie before the operator.
void Struck(State& state, std::uint16_t usage, const show::Show& show, float ago_s) {
  for (const show::KeyCall& key : show.keys)
    if (key.key_usage == usage && !IsLockedOut(state, key.call))
      Obey(state, key.call, static_cast<std::uint16_t>(kFirstKeyControl + usage), show, ago_s);
  if (state.locked != 0) return;
  if (usage == key::kSpace) CallBlink(state, show::Blink::kBoth);
  if (usage == key::kX) CallBlink(state, show::Blink::kRight);
  if (usage == key::kZ) CallBlink(state, show::Blink::kLeft);
  for (std::size_t i = 0; i < show.motions.size(); ++i)
    if (show.motions[i].key_usage == usage) CallMotion(state, show, static_cast<int>(i));
  for (std::size_t i = 0; i < show.scenes.size(); ++i)
    if (show.scenes[i].key_usage == usage) CallScene(state, show, static_cast<std::uint16_t>(i));
}

// The code of a key is its usage; that of a button is its number, which calls what the
// sheet that is there says.
void Handle(State& state, const Press& press, const show::Show& show, float ago_s) {
  if (IsLockedOut(state, press, show)) return NoteLockedOut(state, &press);
  if (press.IsKey())
    Struck(state, press.code, show, ago_s);
  else
    Obey(state, ButtonOf(state, show, press.code), press.code, show, ago_s);
}

// The place in the list of the cue that a call names; -1 where it has none such.
std::int32_t CueOf(const show::Show& show, std::uint32_t number_key) {
  const auto& cues = show.cue_list.cues;
  const auto cue =
      std::ranges::find_if(cues, [=](const show::Cue& c) { return board::CueKey(c.number) == number_key; });
  return cue == cues.end() ? -1 : static_cast<std::int32_t>(cue - cues.begin());
}

// A verb needs no cue; the two other calls name one by its key. False: the show has no such verb or cue.
bool HandleCueCall(State& state, const board::Call& call, const show::Show& show, float ago_s) {
  if (call.verb == board::CallVerb::kCue) {
    if (call.subject >= static_cast<std::uint32_t>(show::kCueVerbCount)) return false;
    CallCue(state, show, static_cast<show::CueVerb>(call.subject), ago_s);
    return true;
  }
  const std::int32_t cue = CueOf(show, call.subject);
  if (cue < 0) return false;
  if (call.verb == board::CallVerb::kGoTo)
    CallGoTo(state, show, cue, ago_s);
  else
    StandByCue(state, show, cue);
  return true;
}

// A motion that plays begins anew, as a cue's does; one that does not is no fault to end.
bool CallMotionFromAfar(State& state, const board::Call& call, const show::Show& show) {
  if (call.subject >= show.motions.size()) return false;
  const auto motion = static_cast<std::int32_t>(call.subject);
  if (call.value > 0)
    PlayMotion(state, show, motion);
  else
    EndMotion(state, motion);
  return true;
}

// False where the show has not what is called.
bool Handle(State& state, const board::Call& call, const show::Show& show, float ago_s) {
  const auto level = static_cast<show::Level>(call.subject);
  if (IsLockedOut(state, call)) {
    NoteLockedOut(state, nullptr);
    return true;
  }
  switch (call.verb) {
    case board::CallVerb::kCue:
    case board::CallVerb::kGoTo:
    case board::CallVerb::kStandBy:
      return HandleCueCall(state, call, show, ago_s);
    case board::CallVerb::kLevel:
    case board::CallVerb::kLetGo:
      if (call.subject >= show::kNamedLevels + show.roles.mixes.size()) return false;
      if (call.verb == board::CallVerb::kLevel)
        SetRemotely(state, show.roles, level, call.value);
      else
        LetGo(state, show.roles, level);
      return true;
    case board::CallVerb::kLoadRole:
      return call.value >= 0 && call.value <= kNoDevice &&
             LoadRole(state, show.roles, call.subject, static_cast<std::uint32_t>(call.value));
    case board::CallVerb::kMotion:
      return CallMotionFromAfar(state, call, show);
    case board::CallVerb::kLock:
      if (call.subject == 1) Lock(state);
      if (call.subject == 0 && state.locked != 0) NoteLockedOut(state, nullptr);
      return call.subject <= 1;
    case board::CallVerb::kLineCheck:
    case board::CallVerb::kLearn:
      return false;  // The stage's own (programs/stage/service_modes.h), which takes them out of the events.
  }
  return false;
}

// Presses have 32 bits of microseconds, whose difference tells the order of any two within half an hour.
std::int32_t Since_us(const Press& press, Time at) {
  const auto us = std::chrono::duration_cast<std::chrono::microseconds>(at.time_since_epoch()).count();
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(us) - press.at_us);
}
bool IsEarlier(const board::Call& call, const Press& press) {
  return Since_us(press, call.at) < 0;
}

// What is called in a frame was called since the one before, of which the board was read a little before it
// was presented. Any other time is of another clock, and counts as that of the frame.
constexpr float kReadAhead_s = 0.5F;
float AgoWithin(float ago_s, float passed_s) {
  return ago_s >= 0 && ago_s <= passed_s + kReadAhead_s ? ago_s : 0;
}
float Ago_s(const Press& press, Time now) {
  return static_cast<float>(Since_us(press, now)) * 1e-6F;
}
float Ago_s(const board::Call& call, Time now) {
  return static_cast<float>(Seconds(now - call.at));
}

}  // namespace

void CallFace(State& state, std::uint16_t face, float fade_s, show::FadeCurve curve) {
  EndToggles(state, show::CallKind::kFace, fade_s);
  CallWhole(state, state.faces, Knob::kFace, face, fade_s, curve);
}

void CallExpression(State& state, std::uint16_t expression, float fade_s, show::FadeCurve curve) {
  EndToggles(state, show::CallKind::kExpression, fade_s);
  CallWhole(state, state.expressions, Knob::kExpression, expression, fade_s, curve);
}

// All that fades in a scene does so in one time and one curve. Fades of their own (ItemFade) are for what
// a person calls by itself.
void EnterScene(State& state, const show::Show& show, std::uint16_t index, float fade_s) {
  const show::StageScene& scene = show.scenes[index];
  CallFace(state, scene.face, fade_s);
  CallExpression(state, scene.expression, fade_s);
  Call(state.styles, static_cast<std::uint16_t>(scene.style), fade_s, 1);
  Call(state.backdrops, index, fade_s, 1);
  Fade(state.exposure, scene.exposure, fade_s);
  state.life.called = scene.life;
  state.life.target = scene.gaze;
  state.scene = index;
}

// Both are in order already; on equal times the press comes first, which is of no account.
void PlayCalls(State& state, const InputEvents& events, const show::Show& show, float passed_s) {
  auto calls = events.calls();
  const auto ago_s = [&](const auto& one) { return AgoWithin(Ago_s(one, state.last), passed_s); };
  const auto call_next = [&] {
    if (!Handle(state, calls.front(), show, ago_s(calls.front()))) ++state.calls_refused;
    calls = calls.subspan(1);
  };
  state.calls_lost += events.lost_calls();
  for (const Press& press : events.presses()) {
    while (!calls.empty() && IsEarlier(calls.front(), press)) call_next();
    Handle(state, press, show, ago_s(press));
  }
  while (!calls.empty()) call_next();
}

}  // namespace kaori::performance
