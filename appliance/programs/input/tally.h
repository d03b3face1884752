// The tally lamp: the audience sees her.
#pragma once

#include "appliance/core/board/board.h"
#include "drivers/base/clock.h"

namespace kaori::input {

// Lit while the stage shows frames and nobody has blacked it out. A stage that has shown none for a second,
// and for four times as long as it usually draws, is dead. Pure.
bool TallyLit(const board::Stamped<board::StageStatus>& stage, const board::Stamped<board::Lines>& lines,
              Time now);

}  // namespace kaori::input
