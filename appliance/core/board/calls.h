// What people call while a show plays: GO, a jump to a cue. Each call has a time and arguments, which
// counters have not, so that the stage handles the calls of all writers in the order in which they were made.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "drivers/base/checksum.h"
#include "drivers/base/clock.h"

namespace kaori::board {

// Who writes calls, each a section of its own.
enum class CallWriter : std::uint32_t {
  kInput,    // kaori-input: the foot switch, and the lines for BACK and PANIC.
  kControl,  // Whoever plays the box from a page or a network; in the demo its page.
};
inline constexpr std::size_t kCallWriters = 2;

// What is called. `subject` and `value` are as each says; both are 0 where nothing is said.
enum class CallVerb : std::uint32_t {
  kCue,       // `subject` is a show::CueVerb: GO, BACK, STOP, PAUSE, PANIC, BLACKOUT.
  kGoTo,      // `subject` is the CueKey of the cue in whose state the show shall stand.
  kStandBy,   // `subject` is the CueKey of the cue that the next GO shall play.
  kLevel,     // `subject` is a show::Level, `value` where a remote control wants it, in the level's own unit.
  kLetGo,     // `subject` is a show::Level of which its owner shall let go.
  kLoadRole,  // `subject` is the role's place among the show's, `value` the show::Device from which it is played from now on;
              // one more than the last device: nobody plays it.
  kLock,      // `subject` is 1: the show is locked (ShowNow::locked). No call unlocks it: 0 is refused.
  kLineCheck,  // `subject` is a LineCheckCall. The stage itself hears it, and the show does not.
  kLearn,      // `subject` is a LearnCall (learn.h), `value` as it says. The stage itself hears it too.
  kMotion,  // `subject` is a motion of the show's; `value` 1: it begins, anew where it plays; 0: it ends softly.
};
inline constexpr std::uint32_t kCallVerbCount = 10;
enum class LineCheckCall : std::uint32_t { kEnd, kBegin, kLampsWereLit };
// The subjects of GO, BACK and PANIC: writers know no show.
inline constexpr std::uint32_t kCallGo = 0, kCallBack = 1, kCallPanic = 4;

// By which control a person called.
enum class CallSource : std::uint32_t { kFootSwitch, kPage };
inline constexpr std::uint32_t kCallSourceCount = 2;

// One call. valid.h bounds everything but the subject, which only the show can judge.
struct Call {
  Time at{};  // When the person called, which may be before it was written.
  CallVerb verb{};
  std::uint32_t subject = 0;
  float value = 0;
  CallSource source{};
};

// The newest calls of one writer. A reader that remembers `count` of its last look reads the calls from there
// on; where more than kKept lie between, the older ones are lost, and it knows how many.
//   writer   kaori-input; whoever plays the box from a page or a network, in the demo its page (CallWriter): at each call
//   readers  kaori-stage at each frame, and once more when it has been away: a call that was made meanwhile is handled then;
//            the writers themselves when they start: kaori-input, in the demo its page
//   stale    never written so
struct Calls {
  static constexpr const char* kName = "calls";
  static constexpr std::size_t kKept = 32;  // A power of two, so that `count` may wrap.
  std::uint32_t count = 0;                  // Calls since the board began; wraps.
  std::uint32_t unused = 0;                 // No byte of the board is padding.
  std::array<Call, kKept> newest{};         // Call n, counted from 0, lies in newest[n % kKept].
};

// Adds a call to the writer's own copy of the section, which is published afterwards; the oldest of kKept calls goes.
// Calls are added in the order in which they were made. Never fails.
inline void Append(Calls& calls, const Call& call) {
  calls.newest[calls.count % Calls::kKept] = call;
  ++calls.count;
}

// A cue's number as a call carries it: a sum over its parts without leading zeros, so that whoever calls a
// cue need not know the list. Two numbers of one list with the same key are refused when the show is packed.
constexpr std::uint32_t CueKey(std::string_view number) {
  std::uint64_t sum = kFnvBasis;
  bool leads = true;  // At the beginning of a part.
  for (std::size_t i = 0; i < number.size(); ++i) {
    const bool last = i + 1 == number.size() || number[i + 1] == '.';
    if (leads && number[i] == '0' && !last) continue;
    leads = number[i] == '.';
    sum = Fnv1a(number.substr(i, 1), sum);
  }
  return static_cast<std::uint32_t>(sum ^ sum >> 32U);
}

}  // namespace kaori::board
