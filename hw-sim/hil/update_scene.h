// An update by a stick, as a stage hand brings it in.
#pragma once

#include <functional>
#include <string>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/updated_pc.h"

namespace kaori::hil {

// A PC whose slot B is one that cannot start, so that a face of it is the face of what was written. Errors: as UpdatedPc::Make and
// MakeSlotBNoise.
Result<UpdatedPc> PcToUpdate(Scene& scene);

// Waits until this file of the data partition is as wanted. Errors: timed_out, with what the disk holds.
Result<void> AwaitKept(Scene& scene, const UpdatedPc& pc, const std::string& name,
                       const std::function<bool(const std::string&)>& right, Duration longest);

// Brings the update in and restarts; the machine is off then. What it wrote is noted, and the PC is kept as it stands. Errors:
// invalid_argument, the box does not do so; those of the machine.
Result<void> UpdateAndRestart(Scene& scene, const UpdatedPc& pc);

// A PC that is about to try its update: a copy of the one that was kept, or one into which it is brought now. Errors: as above.
Result<UpdatedPc> RestartedPc(Scene& scene);

}  // namespace kaori::hil
