#include "firmware/board/rp2040/chip.h"

#include "firmware/board/rp2040/registers.h"

namespace kaori::rp2040 {
namespace {

constexpr std::uint32_t kHighest = 1U << 31;  // Locked, stable, trigger: all of them are bit 31.

// The crystal is steady after 1 ms: 47 times 256 cycles of 12 MHz.
constexpr std::uint32_t kCrystalDelay = 47, kCrystalEnable = 0xFAB000 | 0xAA0;

// PLL (2.18.2): 12 MHz times `times`, divided twice.
struct Pll {
  std::uint32_t address;
  std::uint32_t times, first_divisor, second_divisor;
};
constexpr Pll kSystemPll{kPllSys, 125, 6, 2};  // 1500 MHz, 125 MHz
constexpr Pll kUsbPll{kPllUsb, 100, 5, 5};     // 1200 MHz, 48 MHz
constexpr std::uint32_t kPllPower = 4, kPllTimes = 8, kPllDivisors = 12;
constexpr std::uint32_t kPowerDown = 1U << 0, kDividersDown = 1U << 3, kOscillatorDown = 1U << 5;

// Clocks (2.15.7): the system's has a glitchless switch between the reference and an auxiliary source.
constexpr std::uint32_t kClockEnable = 1U << 11;
constexpr std::uint32_t kReferenceIsCrystal = 2, kSystemIsAuxiliary = 1;

// Who drives a pin (2.19.2), and what its pad does (2.19.6.3).
constexpr std::uint32_t kFunctionSpi = 1, kFunctionProcessor = 5;
constexpr std::uint32_t kPadInput = 1U << 6, kPadPullUp = 1U << 3, kPadSchmitt = 1U << 1,
                        kPadDrive4mA = 1U << 4;

// Twice a microsecond (RP2040-E1), in 24 bits.
constexpr std::uint32_t kWatchdogPerMs = 2000, kWatchdogMost = 0xFFFFFF;
constexpr std::uint32_t kWatchdogEnable = 1U << 30;
// All but the two oscillators.
constexpr std::uint32_t kWatchdogAll = 0x1FFFC;
constexpr std::uint32_t kTickEnable = 1U << 9, kTickCycles = 12;

// "SLT" and the number of the slot.
constexpr std::uint32_t kSlotMark = 0x534C5400;

// In the order that the data sheet asks for: divisor, power, wait for the lock, and only then the dividers
// behind it.
void StartPll(const Pll& pll) {
  At(pll.address) = 1;  // The crystal is not divided.
  At(pll.address + kPllTimes) = pll.times;
  ClearAt(pll.address + kPllPower) = kPowerDown | kOscillatorDown;
  while ((At(pll.address) & kHighest) == 0) {
  }
  At(pll.address + kPllDivisors) = pll.first_divisor << 16 | pll.second_divisor << 12;
  ClearAt(pll.address + kPllPower) = kDividersDown;
}

}  // namespace

// A block that comes out of reset needs some cycles, and its registers do not answer before.
void Release(std::uint32_t blocks) {
  ClearAt(kResets) = blocks;
  while ((At(kResetDone) & blocks) != blocks) {
  }
}

// The crystal comes first, since both PLLs multiply it; until they are locked the processor runs from the
// reference clock, so that no PLL is changed under it. Each wait ends by the part itself: where one never
// answers, the watchdog that runs already restarts the chip.
void StartClocks() {
  At(kCrystalStartup) = kCrystalDelay;
  At(kCrystalControl) = kCrystalEnable;
  while ((At(kCrystalStatus) & kHighest) == 0) {
  }
  // Off the PLLs, should somebody have left them running, before they are started.
  ClearAt(kClockSysControl) = kSystemIsAuxiliary;
  while ((At(kClockSysSelected) & 1U) == 0) {
  }
  At(kClockRefControl) = kReferenceIsCrystal;
  while ((At(kClockRefSelected) & 1U << kReferenceIsCrystal) == 0) {
  }
  Release(kResetPllSys | kResetPllUsb);
  StartPll(kSystemPll);
  StartPll(kUsbPll);
  At(kClockSysControl) = 0;  // The auxiliary source is the system's PLL,
  SetAt(kClockSysControl) = kSystemIsAuxiliary;
  while ((At(kClockSysSelected) & 2U) == 0) {
  }
  At(kClockPeriControl) = kClockEnable;  // that of the peripherals the system's clock,
  At(kClockUsbControl) = kClockEnable;   // that of USB its own PLL.
}

// An output is low before it is driven, so that no line spikes as the power comes.
void SetUp(std::span<const Pin> pins) {
  Release(kResetIoBank | kResetPads);
  for (const Pin& pin : pins) {
    if (pin.use == PinUse::kOutput) {
      At(kPinsClear) = 1U << pin.gpio;
      At(kPinsDrive) = 1U << pin.gpio;
    }
    At(PinPad(pin.gpio)) = pin.use == PinUse::kInput ? kPadInput | kPadPullUp | kPadSchmitt
                                                     : kPadInput | kPadSchmitt | kPadDrive4mA;
    At(PinControl(pin.gpio)) = pin.use == PinUse::kSpi ? kFunctionSpi : kFunctionProcessor;
  }
}

// The tick of the watchdog is the crystal by 12: one a microsecond. Longer times than the counter holds
// become the longest, 8.4 s.
void Watch(std::uint32_t milliseconds) {
  const std::uint32_t count = milliseconds * kWatchdogPerMs;
  At(kWatchdogTick) = kTickEnable | kTickCycles;
  At(kWatchdogLoad) = count < kWatchdogMost ? count : kWatchdogMost;
  At(kWatchdogResets) = kWatchdogAll;
  SetAt(kWatchdogControl) = kWatchdogEnable;
}

void Restart() {
  At(kWatchdogResets) = kWatchdogAll;
  SetAt(kWatchdogControl) = kHighest;
  for (;;) {
  }
}

// Scratch registers outlive a restart by the watchdog: the first stage tells the image where it came from.
void TellSlot(std::uint32_t slot) {
  At(kWatchdogScratch0) = kSlotMark | slot;
}

// Slot A where nobody told, as when a debugger has started the image.
std::uint32_t ToldSlot() {
  const std::uint32_t told = At(kWatchdogScratch0);
  return (told & ~1U) == kSlotMark ? told & 1U : 0;
}

}  // namespace kaori::rp2040
