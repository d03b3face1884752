// What the programs of all surfaces have in common: the timer's looks, and the loop that is fed by them.
#pragma once

#include <atomic>
#include <cstdint>

#include "firmware/board/rp2040/chip.h"
#include "firmware/board/rp2040/usb_controller.h"
#include "firmware/surface/service.h"
#include "firmware/surface/usb_device.h"

namespace kaori::rp2040 {

inline constexpr std::uint32_t kLooksPerSecond = 40'000;
inline constexpr std::uint8_t kHardwareRp2040 = 1;
inline constexpr std::uint32_t kWatchdogMs = 100;

// How many looks there were. The timer's interrupt alone writes it.
inline std::atomic<std::uint32_t> looks{0};
inline void CountLook() {
  looks.store(looks.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
}
// From here on the timer calls Look.
void StartLooking();

// Of this chip. SYSINFO is in reset when the power comes, and is released here.
wire::ChipStepping ReadStepping();
// Instead of playing, on a chip that is not fit: shows the device to the host under a name that says so, answers its
// feature report and blinks its lamps, until somebody wants a restart. Pins and shift registers are set up.
[[noreturn]] void Refuse(const surface::UsbIdentity& identity, const surface::Unit& unit);

// Serves USB at each look and calls `tick` a few thousand times a second, for ever: until the surface wants a
// restart, or something stands still and the watchdog bites.
template <class Surface, class Tick>
[[noreturn]] void Run(Surface& surface, surface::UsbDevice& device, UsbController& usb, Tick tick) {
  constexpr std::uint32_t kLooksInATick = kLooksPerSecond / Surface::kTicksPerSecond;
  // The answer to the command that asks for a restart is fetched within that.
  constexpr std::uint32_t kLooksToRestart = kLooksPerSecond / 20;
  std::uint32_t ticked_at = 0, restart_at = 0;
  for (;;) {
    asm volatile("wfi" ::: "memory");
    const std::uint32_t now = looks.load(std::memory_order_relaxed);
    usb.Service(device);
    device.Poll();
    if (now - ticked_at < kLooksInATick) continue;
    // After an operation of the flash, which takes many ticks, there is one.
    ticked_at = now;
    tick();
    // Here the looks have moved, and USB and the reports had their turn: whichever stands still, the watchdog
    // bites.
    Watch(kWatchdogMs);
    if (!surface.wants_restart()) restart_at = now + kLooksToRestart;
    if (static_cast<std::int32_t>(now - restart_at) > 0) Restart();
  }
}

}  // namespace kaori::rp2040
