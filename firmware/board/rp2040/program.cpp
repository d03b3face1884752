#include "firmware/board/rp2040/program.h"

#include "firmware/board/rp2040/registers.h"
#include "firmware/board/rp2040/rom_flash.h"
#include "firmware/board/rp2040/shift_registers.h"
#include "firmware/board/rp2040/stepping.h"
#include "firmware/surface/refusal.h"

namespace kaori::rp2040 {

// SysTick counts down from its reload value and interrupts at 0 (ARMv6-M, B3.3): 3125 cycles are a look,
// without a remainder.
void StartLooking() {
  At(kSysTickReload) = kClockHz / kLooksPerSecond - 1;
  At(kSysTickValue) = 0;
  At(kSysTickControl) = 7;  // The processor's clock, with an interrupt.
}

// The register reads 0 while its block is in reset, which would be taken for a chip that is too old.
wire::ChipStepping ReadStepping() {
  Release(kResetSysInfo);
  return SteppingOf(At(kChipId), RomVersion());
}

// As Main of a surface, and with the same loop: the watchdog is fed, so that a chip which refuses does not restart again
// and again. The switches that come back with the exchange are nobody's. All objects live on this stack for good.
void Refuse(const surface::UsbIdentity& identity, const surface::Unit& unit) {
  surface::Refusal refusal(unit);
  UsbController usb;
  surface::UsbDevice device(surface::RefusedIdentity(identity), refusal, usb);
  usb.Start();
  StartLooking();
  Run(refusal, device, usb, [&] { ShiftRegisters::Exchange(refusal.Tick()); });
}

}  // namespace kaori::rp2040
