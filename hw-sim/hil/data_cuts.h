// Cuts of the power after which a disk has only a part of what it was given since its last flush, and some of it torn.
#pragma once

#include <string>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/update_history.h"

namespace kaori::hil {

// What such cuts found of a data partition.
struct DataCuts {
  int cuts = 0;
  // After which a file was neither as before nor as after, or e2fsck could not mend it.
  int wrong = 0;
  // In which the last flush lies between two states of what is kept: the cut decided which of them there is.
  int deciding = 0;
  // Of the first of them.
  std::string said{};
};

// Cuts at writes of the history, half of them anywhere and half where a change of what is kept comes to count, onto copies of the data
// partition of `disk`, which is as the history began. Of what came since the last flush each write is there, lost, or torn at 512 or 4096
// bytes, by chance; what was flushed is there, but where `lies`: a disk that says so of what it then loses, which is how these cuts are
// seen to find anything. Each copy is mended by e2fsck, as the box does it where its kernel cannot, and the files that people would miss
// must be as they were at the flush, or as they would be had nothing been lost. Needs e2fsprogs. Errors: those of the files and programs;
// invalid_argument, nothing that is kept has changed.
Result<DataCuts> CutData(Scene& scene, const UpdateHistory& history, const std::string& disk, int cuts,
                         bool lies);

}  // namespace kaori::hil
