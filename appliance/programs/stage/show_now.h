// How the show stands, for those who tell people.
#pragma once

#include "appliance/core/board/show_now.h"
#include "appliance/core/performance/state.h"

namespace kaori::stage {

// Pure, and allocates nothing.
board::ShowNow ShowNowOf(const performance::State& state);

}  // namespace kaori::stage
