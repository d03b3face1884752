#include "firmware/board/rp2040/program.h"

#include "firmware/board/rp2040/registers.h"

namespace kaori::rp2040 {

// SysTick counts down from its reload value and interrupts at 0 (ARMv6-M, B3.3): 3125 cycles are a look,
// without a remainder.
void StartLooking() {
  At(kSysTickReload) = kClockHz / kLooksPerSecond - 1;
  At(kSysTickValue) = 0;
  At(kSysTickControl) = 7;  // The processor's clock, with an interrupt.
}

}  // namespace kaori::rp2040
