// How the show stands and what its buttons call, for those who tell people.
#pragma once

#include "appliance/core/board/sections.h"
#include "appliance/core/board/show_now.h"
#include "appliance/core/performance/state.h"
#include "appliance/core/show/show.h"

namespace kaori::stage {

// Of a state that belongs to the show; when its act began ActClock knows. Pure, and allocates nothing.
board::ShowNow ShowNowOf(const performance::State& state, const show::Show& show, Time act_began);

// What the buttons of the dial box call in this show, the box's own included. Pure.
board::ButtonCalls ButtonCallsOf(const show::Show& show);

}  // namespace kaori::stage
