// How the box does, in words: what is there, what is missing, what is wrong.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "appliance/core/board/board.h"
#include "appliance/core/board/snapshot.h"
#include "appliance/programs/status/facts.h"
#include "drivers/base/clock.h"

namespace kaori::status {

enum class Mark : std::uint8_t { kTitle, kGood, kMissing, kFault };

struct Line {
  Mark mark = Mark::kGood;
  std::string what;   // "dial box"
  std::string words;  // "pulled a moment ago; the dials stand where they were"

  friend bool operator==(const Line&, const Line&) = default;
};

struct State {
  board::Snapshot board;
  board::Stamped<board::Sound> sound;
  Facts facts;
  Time now{};
};

State Look(const board::Board& board, Facts facts, Time now);

// The title, then what is wrong, then the show, its screens and its devices. Equal states give equal lines,
// and times are told so roughly that a line seldom changes.
std::vector<Line> Describe(const State& state);

// The same as text, a line each: "!" stands before faults, "-" before what is missing.
std::string TextOf(const std::vector<Line>& lines);

}  // namespace kaori::status
