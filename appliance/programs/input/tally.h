// The tally lamp: it is lit while the audience sees the face.
#pragma once

#include "appliance/core/board/board.h"
#include "drivers/base/clock.h"

namespace kaori::input {

// Whether the lamp is lit: the stage shows frames and no blackout is on. A stage is taken for dead when its
// last frame is older than one second plus four times its usual drawing time. Pure. Lines that are absent or
// stale have no blackout on. A stage that plays unseen writes no status, so that the lamp goes out with the
// screen.
bool TallyLit(const board::Stamped<board::StageStatus>& stage, const board::Stamped<board::Lines>& lines,
              Time now);

}  // namespace kaori::input
