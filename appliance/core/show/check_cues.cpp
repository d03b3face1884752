#include "appliance/core/show/check_cues.h"

#include <algorithm>

#include <fmt/format.h>

#include "appliance/core/show/level.h"

namespace kaori::show {
namespace {

// One cue, or the list itself, and what is wrong with it.
class CueChecker {
 public:
  CueChecker(std::string item, std::vector<std::string>& faults) : item_(std::move(item)), faults_(faults) {}

  void Fault(const std::string& reason) { faults_.push_back(item_ + ": " + reason); }

  // NaN lies within nothing.
  void Within(const char* what, float value, float high) {
    if (!(value >= 0 && value <= high)) Fault(fmt::format("{} is {}, not within 0 to {}", what, value, high));
  }

  // `what` is the word for such items, of which the show has `count`.
  void Call(const char* what, const std::optional<CueCall>& call, std::size_t count) {
    if (!call) return;
    if (call->index >= count) Fault(fmt::format("there is no {} {}", what, call->index));
    Within(fmt::format("the fade of its {}", what).c_str(), call->in_s, kLongestCueFade_s);
  }

  void Level(const char* what, const std::optional<CueLevel>& level) {
    if (!level) return;
    Within(what, level->value, 1);
    Within(fmt::format("the fade of its {}", what).c_str(), level->in_s, kLongestCueFade_s);
  }

  // kNoTarget is allowed: the cue then lets her look at nobody.
  void Gaze(std::int32_t target, std::size_t count) {
    if (target < kNoTarget || target >= static_cast<std::int32_t>(count))
      Fault(fmt::format("there is no gaze target {}", target));
  }

 private:
  std::string item_;
  std::vector<std::string>& faults_;
};

// A wait for a person needs an end of its own, so that no sensor can stop an evening.
void CheckWait(CueChecker& check, const CueWait& wait, std::size_t targets) {
  if (wait.person > CuePerson::kGazeOn) return check.Fault("it waits for nothing that is known");
  check.Within("its wait", wait.for_s, kLongestWait_s);
  check.Within("its longest wait", wait.at_most_s, kLongestWait_s);
  if (wait.person != CuePerson::kNobody && !(wait.at_most_s > 0))
    check.Fault("a wait for a person wants at_most_s, or the evening may hang");
  if (wait.for_s > wait.at_most_s && wait.person != CuePerson::kNobody)
    check.Fault("it waits longer than its longest wait");
  if (wait.person == CuePerson::kGazeOn && (wait.target < 0 || wait.target >= static_cast<int>(targets)))
    check.Fault(
        fmt::format("it waits for a look at the gaze target {}, and there is none such", wait.target));
}

// A part may be kKeepsLife, which no scene has.
void CheckLifeOf(CueChecker& check, const LifeAmounts& life) {
  for (const float amount : life)
    if (amount != kKeepsLife) check.Within("its life", amount, kMostLife);
}

// Where it begins must lie before its end, or nothing would play.
void CheckUse(CueChecker& check, const MotionUse& use, const Motion& motion) {
  if (use.layer && *use.layer > MotionLayer::kOver) check.Fault("the layer of its motion is not known");
  if (!(use.gain >= kLeastTakeGain && use.gain <= kMostTakeGain))
    check.Fault(fmt::format("the gain of its motion is {}, not within {} to {}", use.gain, kLeastTakeGain,
                            kMostTakeGain));
  const float end_s = motion.Loops() ? motion.loop_to_s : EndOf(motion);
  if (!(use.from_s >= 0 && (use.from_s == 0 || use.from_s < end_s)))
    check.Fault(fmt::format("its motion begins at {} s and ends at {} s", use.from_s, end_s));
}

// Faults name a cue by its number, by which it is found in cues.toml.
void CheckCue(const Show& show, const Cue& cue, std::vector<std::string>& faults) {
  CueChecker check(fmt::format("cue {}", cue.number), faults);
  if (!IsCueNumber(cue.number)) check.Fault("its number is not of digits and single dots");
  check.Within("its pre-wait", cue.pre_wait_s, kLongestWait_s);
  check.Call("scene", cue.scene, show.scenes.size());
  check.Call("face", cue.face, show.cast.faces.size());
  check.Call("expression", cue.expression, show.cast.expressions.size());
  check.Call("style", cue.style, scene::kStyleCount);
  check.Level("light", cue.light);
  check.Level("present", cue.present);
  if (cue.motion < kEndsMotion || cue.motion >= static_cast<int>(show.motions.size()))
    check.Fault(fmt::format("there is no motion {}", cue.motion));
  else if (cue.next == CueNext::kFollow && cue.motion >= 0 &&
           show.motions[static_cast<std::size_t>(cue.motion)].Loops())
    check.Fault("nothing can follow it: its motion loops, and has no end");
  if (cue.motion >= 0 && cue.motion < static_cast<int>(show.motions.size()))
    CheckUse(check, cue.use, show.motions[static_cast<std::size_t>(cue.motion)]);
  if (cue.release >> kLevelCount != 0) check.Fault("it releases a level that is not known");
  if (cue.life) CheckLifeOf(check, *cue.life);
  if (cue.gaze) check.Gaze(*cue.gaze, show.gaze_targets.size());
  if (cue.next > CueNext::kFollow) check.Fault("what begins the next cue is not known");
  CheckWait(check, cue.wait, show.gaze_targets.size());
}

}  // namespace

// Numbers are compared between neighbours: where each rises, the whole list does.
void CheckCueList(const Show& show, std::vector<std::string>& faults) {
  const CueList& list = show.cue_list;
  CueChecker check("cue list", faults);
  if (list.cues.size() > kMostCues)
    return check.Fault(fmt::format("{} cues, and {} at most can be played", list.cues.size(), kMostCues));
  check.Within("go_guard", list.go_guard_s, kLongestGoGuard_s);
  check.Within("goto", list.goto_s, kLongestFade_s);
  if (!show.scenes.empty()) check.Call("scene of panic", list.panic, show.scenes.size());
  for (const Cue& cue : list.cues) CheckCue(show, cue, faults);
  const auto not_rising = [](const Cue& a, const Cue& b) {
    return CompareCueNumbers(a.number, b.number) >= 0;
  };
  for (auto at = list.cues.begin();; ++at) {
    at = std::adjacent_find(at, list.cues.end(), not_rising);
    if (at == list.cues.end()) break;
    faults.push_back(
        fmt::format("cue {}: stands after cue {}; numbers must rise", (at + 1)->number, at->number));
  }
}

}  // namespace kaori::show
