// The status of the box in sentences: what works, what is missing, and what is wrong.
//
//     Kaori box    This box is left-lobby. Profile stage; the root file system is verified, hash 0123456789ab.
//     show         The show has 60 frames a second, 4.1 ms each; none was late; fine quality.
//   - left stick   It was unplugged 2 minutes ago; the head moves by itself.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "appliance/core/board/board.h"
#include "appliance/core/board/snapshot.h"
#include "appliance/programs/status/facts.h"
#include "drivers/base/clock.h"

namespace kaori::status {

// What a line means: the title, a working part, a part that is missing, or a fault that somebody has to mend.
enum class Mark : std::uint8_t { kTitle, kGood, kMissing, kFault };

// One row of the status.
struct Line {
  Mark mark = Mark::kGood;
  std::string what;   // "dial box"
  std::string words;  // "It was unplugged a moment ago; the dials keep their values."

  friend bool operator==(const Line&, const Line&) = default;
};

// All that the status depends on, at one moment.
struct State {
  // All sections but those that follow.
  board::Snapshot board;
  board::Stamped<board::Sound> sound;
  board::Stamped<board::ShowNow> show_now{};
  board::Stamped<board::Learn> learn{};
  // What is known beside the board; `now` is the time at which ages are told.
  Facts facts;
  Time now{};
};

// Reads all that the status depends on. Blocks for nothing.
State Look(const board::Board& board, Facts facts, Time now);

// Describes a state: the title, then faults and notices, then the show, its screens and its devices. Equal
// states give equal lines, and spans of time are so rough that a line seldom changes. Pure.
std::vector<Line> Describe(const State& state);

// The lines as text, one a line: "!" marks a fault and "-" something that is missing. Pure.
std::string TextOf(const std::vector<Line>& lines);

}  // namespace kaori::status
