// What checks that cut the power of a PC with UEFI have in common: where to cut, the face that must come, and that its absence is seen.
#pragma once

#include <cstddef>

#include "hw-sim/hil/updated_pc.h"

namespace kaori::hil {

// Of checks that a release repeats as often as it is told to.
inline constexpr int kManyRounds = 1000;

// The place of a cut within the writes [first, end), of which one at least comes before it. `number` counts the cuts from 0, of `of` in
// all: each lies where the scene's chance has it in its own part of them, so that each phase has one.
std::size_t CutPoint(Scene& scene, std::size_t first, std::size_t end, int number, int of);

// Starts a PC, with the disk and the variables that it has, and waits for its face; it is off again afterwards. `when`: for the error.
// Errors: those of the machine; timed_out.
Result<void> WantFaceOf(Scene& scene, const UpdatedPc& pc, const char* when, Duration longest);

// A control: a PC whose loader names another slot is seen, and so is one that comes to no face. Errors: invalid_argument, it is not.
Result<void> ASpoiltSlotIsSeen(Scene& scene);

}  // namespace kaori::hil
