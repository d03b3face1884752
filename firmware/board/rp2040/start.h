// What a program of this board defines.
#pragma once

namespace kaori::rp2040 {

// Called once, with interrupts off at the timer.
[[noreturn]] void Main();
// The timer's interrupt.
void Look();

}  // namespace kaori::rp2040
