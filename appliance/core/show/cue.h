// The cue list of a show: what each GO of an evening does, in the order in which the play wants it.
//
// A cue sets what it names and leaves everything else as it was, as on a light desk ("tracking"). What stands
// after a cue is therefore the sum of all cues up to it; Track adds them up once, when a show is loaded, so
// that a jump to any cue lands exactly where a run through the list would have come.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "appliance/core/show/life.h"
#include "appliance/core/show/motion.h"

namespace kaori::show {

struct Show;

inline constexpr std::size_t kMostCues = 2000;
inline constexpr float kLongestWait_s = 3600;     // Of a pre-wait or of a wait for a person.
inline constexpr float kLongestGoGuard_s = 5;     // A longer one would refuse what an operator means.
inline constexpr float kLongestCueFade_s = 1800;  // Half an hour; scenes and dials have kLongestFade_s.

// What a person calls while a list is played. Keys, buttons, the foot switch and pages call the same.
enum class CueVerb : std::uint16_t {
  kGo,        // Plays the cue that stands by.
  kBack,      // Holds what runs; again, or where nothing runs: to the cue before.
  kStop,      // Ends motions and waits softly; what would have followed stands by.
  kPause,     // Holds waits, fades and motions; again: they go on. Operators, lips and life are not held.
  kPanic,     // As kStop, and the panic scene; again while it comes: at once.
  kBlackout,  // Black over all; again: as it was. No cue lifts it.
};
inline constexpr int kCueVerbCount = 6;

// Something of the show that a cue calls: a face, an expression, a style or a scene.
struct CueCall {
  std::uint16_t index = 0;
  float in_s = 0;  // 0: at once.
};

// A level that a cue moves.
struct CueLevel {
  float value = 1;
  float in_s = 0;
};

// What begins the next cue besides GO.
enum class CueNext : std::uint8_t {
  kGo,        // Nothing.
  kContinue,  // This one's beginning.
  kFollow,    // This one's end: its longest fade and its motion are over.
};

// What a cue waits for after GO and its pre-wait.
enum class CuePerson : std::uint8_t {
  kNobody,
  kMouthShut,   // The face's mouth is shut: the operator has ended a word.
  kVoiceQuiet,  // Nobody speaks into the microphone.
  kPresence,    // Somebody stands before the box.
  kGazeOn,      // Her eyes rest on a target: whoever plays them has brought the look there.
};

// Times are seconds, up to kLongestWait_s, and count only where there is a person.
struct CueWait {
  CuePerson person = CuePerson::kNobody;
  float for_s = 0;           // So long without a break.
  float at_most_s = 0;       // Then the cue comes all the same: an evening never hangs on a sensor.
  std::int32_t target = -1;  // Of the show's gaze targets, for kGazeOn alone.
};

// What a cue says of motions where it calls none: nothing, or that they end softly.
inline constexpr int kNoMotion = -1, kEndsMotion = -2;

// One cue of the list. What it does not name stays as it stands.
struct Cue {
  std::string number{};  // Digits and dots: "3", "2.10". Rises from cue to cue, see CompareCueNumbers.
  std::string name{};
  std::string act{};    // For the show report; empty: as the cue before.
  std::string notes{};  // For whoever calls the show.
  float pre_wait_s = 0;
  std::optional<CueCall> scene{};  // First, so that a face or a style named beside it stays.
  std::optional<CueCall> face{}, expression{}, style{};
  std::optional<CueLevel> light{};     // 0 black .. 1 as the scene is lit.
  std::optional<CueLevel> present{};   // 0 she has left the picture .. 1 she is there.
  int motion = kNoMotion;              // Of the show's motions, or one of the two below 0,
  MotionUse use{};                     // and how it is played.
  std::uint32_t release = 0;           // Bit n: whoever has the level n (show::Level) lets go of it.
  std::optional<LifeAmounts> life{};   // Parts that are kKeepsLife stay as they were.
  std::optional<std::int32_t> gaze{};  // Whom she looks at, of the show's targets, or kNoTarget.
  bool lock = false;                   // The show is locked from then on; only the service key unlocks it.
  CueNext next = CueNext::kGo;
  CueWait wait{};
};

// A motion that plays on until something ends it.
struct TrackedLoop {
  int motion = kNoMotion;
  MotionUse use{};
  bool operator==(const TrackedLoop&) const = default;
};

// What stands when everything up to a cue has been played and all fades have run.
struct TrackedState {
  // Called last, and what was called before that: a dial turned back shows it.
  struct Item {
    std::uint16_t now = 0, before = 0;
    bool operator==(const Item&) const = default;
  };
  Item face, expression, style, scene;
  float light = 1;
  float present = 1;
  LifeAmounts life = kWholeLife;
  std::int32_t gaze = kNoTarget;
  std::vector<TrackedLoop> loops{};  // The one that was called first stands first; kMostTakes at most.
  bool operator==(const TrackedState&) const = default;
};

// All cues of a show in the order of their numbers, and what holds for each of them. Times are seconds.
struct CueList {
  float go_guard_s = 0.3F;  // A second GO within it is a slip of the foot, from whichever control.
  float goto_s = 1.0F;      // A jump fades so long.
  CueCall panic{0, 1.0F};   // A scene.
  std::vector<Cue> cues;
  bool of_scenes = false;  // Track made the cues, since the show has none: they are not in its pack.
  std::vector<TrackedState> tracked;  // [0] before the first cue, [n] after cue n - 1. Made by Track.
};

// Part by part, as numbers: 2 < 2.5 < 2.10 < 3. Both consist of digits and single dots (IsCueNumber).
std::strong_ordering CompareCueNumbers(std::string_view a, std::string_view b);
bool IsCueNumber(std::string_view text);

// The cue at which the chain of `cue` ends: that after which GO is waited for. `cue` is one of the list's, counted from
// 0; the last cue ends every chain. Pure.
std::size_t EndOfChain(const CueList& list, std::size_t cue);

// Fills `tracked`; scenes, faces and the rest that cues name must exist. A show without cues gets its scenes
// as cues, the second one first: the first stands when the show opens.
void Track(Show& show);

}  // namespace kaori::show
