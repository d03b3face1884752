// What is looked for on the board while an evening plays: "cue 14", "camera stale", "level fade 1.1". The
// words of a running order.
#pragma once

#include <cstdint>
#include <string>

#include "appliance/core/board/board.h"
#include "appliance/core/show/show.h"
#include "hw-sim/devices/operator_action.h"
#include "hw-sim/scenario/tokenizer.h"

namespace kaori::sim {

// How the show stands at one moment, where the board alone does not tell.
struct ShowSeen {
  // That the screen has accepted, over all stages of the evening.
  std::uint64_t pictures = 0;
  // Of the newest picture: 0 lit .. 1 black.
  float blackout = 0;
  // Of the show log on the disk.
  std::uint64_t log_bytes = 0;
};

// One of the conditions, with the fields that its kind uses; all other fields keep their defaults. A plain
// value that is read once from the running order and never changes afterwards.
struct Condition {
  enum class Kind : std::uint8_t {
    // This cue was played last.
    kCue,
    // This cue stands by.
    kStandby,
    // A GO was refused,
    kRefused,
    // a call named what the show has not,
    kUnknown,
    // calls came faster than the board keeps them,
    kLost,
    // a picture was presented,
    kPicture,
    // another board took the place of the one before,
    kNewBoard,
    // and the show log grew, all since the condition was begun.
    kLogGrows,
    // The cue list holds,
    kPaused,
    // or does not.
    kRunning,
    // The panic scene is on.
    kPanic,
    // The pending cue waits for a person.
    kWaiting,
    // The newest picture is all black,
    kDark,
    // or as it is lit.
    kLit,
    // The device on this port is there,
    kLive,
    // or gone or silent.
    kStale,
    // Lips or voice have the mouth,
    kMouth,
    // and this one the level.
    kOwner,
    // The level has this value, to within 2 % of its range.
    kLevel,
  } kind = Kind::kCue;
  // The cue or the level.
  int index = 0;
  // A board::LevelOwner.
  int owner = 0;
  // Of the level, in its own unit.
  double value = 0;
  // Of kLive and kStale.
  DevicePort port{};
  // As it was written.
  std::string words;
};

// Reads one; names of cues and levels are those of the show. A problem is added to the tokenizer's where
// there is none.
Condition ReadCondition(Tokenizer& tokens, const show::Show& show);

// Counters as they stood when a condition was begun; what is told of as "since" is compared with them.
struct Since {
  std::uint32_t refused = 0, unknown = 0, lost = 0, moves = 0;
  std::uint64_t pictures = 0, log_bytes = 0;
};
Since SinceNow(const board::Board& board, const ShowSeen& seen);

// Whether it is so now. Never waits.
bool Holds(const Condition& condition, const Since& since, const board::Board& board, const ShowSeen& seen);

// What is so instead, for people: "cue 13 is on". Empty where the condition says all there is.
std::string Instead(const Condition& condition, const board::Board& board, const show::Show& show);

}  // namespace kaori::sim
