// What the lamps in the buttons say.
#pragma once

#include <cstdint>

#include "appliance/core/performance/state.h"
#include "appliance/core/show/show.h"

namespace kaori::performance {

enum class Lamp : std::uint8_t {
  kOff,
  kLit,  // What the button calls is there.
  kBreathing,  // It is on its way: lit for three quarters of each second, from the push on, and steadily in a pause.
  kBlinking,  // It waits, or stands by: lit for each other quarter of a second.
};

// Of a call as it stands now. A call that is there is the newest of its kind, or one that is kept.
Lamp LampOf(const State& state, const show::Call& call, const show::Show& show);

// Which lamps of the sheet that is there are lit in this frame: bit n is button n. A GO that was refused
// makes its lamp blink twice. Lamps are on or off; all of them breathe and blink by this one function, so
// that a lamp that is told now shows what the others show.
std::uint32_t LitLamps(const State& state, const show::Show& show);

}  // namespace kaori::performance
