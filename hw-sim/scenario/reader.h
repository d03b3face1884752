// Reads scenarios that people write.
//
// clang-format off
//   # a comment
//   scene poster                            names what follows
//   at 0.2s push 7                          button 7 of the box, down and up again; hold 7 and release 7 are its halves
//   at 1s dial 1 turn 0.4                   at once
//   at 1s over 0.8s left move 0.25 0.05     takes a while; left or right: move X Y, twist A, slide A, hat up, push N,
//                                           hold N, release N
//   at 2s key space tap                     or press, release
//   at 2s over 1s pointer 0.4 0.5           a position on the picture from its left upper corner, 0 to 1
//   at 2s press pointer                     or click, release; a number after it says which button
//   at 2s roll pointer 3                    notches of its wheel, away from the operator
//   at 2s lips 0.6 1.1                      height and width, in widths of the mouth at rest
//   at 3s over 1.4s say "kon ni ti wa"
//   at 3s voice a 0.8                       a vowel (a, i, u, e, o) so loud; voice off is silence
//   at 4s lens cover                        or uncover
//   at 4s camera stall                      or run
//   at 4s microphone stall                  or run; the same of the loudspeaker
//   at 4s line go tap                       or on, off; of go, blackout, service, presence, back, panic
//   at 5s unplug stick-left                 or plug
// clang-format on
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "drivers/base/result.h"
#include "hw-sim/scenario/scenario.h"
#include "hw-sim/scenario/tokenizer.h"

namespace kaori::sim {

// How long a pushed button or a tapped key stays down: several frames of any show.
inline constexpr Duration kTap = std::chrono::milliseconds(100);

// What was read: with a problem the scenario may be half of what was meant.
struct Reading {
  // Of all lines that could be read.
  Scenario scenario;
  std::vector<Problem> problems;  // The first hundred; with any, the scenario is not to be played.
};

// Reads line by line and goes on after a problem, so that people see all of them at once. A line without
// a time is right for a scene only: the scene begins with what follows it. Pure.
Reading ReadScenario(std::string_view text);

// "play.txt:12:18: no dial 9; dials are 1 to 8", a line for each, as compilers have it. Pure.
std::string Describe(const std::vector<Problem>& problems, std::string_view file);

// Reads a file; blocks for the disk. Errors: those of the file;
// invalid_argument with every problem described.
Result<Scenario> LoadScenario(const std::string& path);

}  // namespace kaori::sim
