// Clocks, pins and the watchdog of the RP2040.
#pragma once

#include <cstdint>
#include <span>

#include "firmware/board/rp2040/pins.h"

namespace kaori::rp2040 {

inline constexpr std::uint32_t kClockHz = 125'000'000;

// Crystal of 12 MHz, system and peripherals at 125 MHz, USB at 48 MHz. Waits until all of them are steady.
void StartClocks();
// Takes blocks of the chip out of reset, as bits of the RESETS register.
void Release(std::uint32_t blocks);
void SetUp(std::span<const Pin> pins);

// Restarts the chip when this is not called again for so long, 8 s at most. Before the clocks are started it
// counts the reference clock, which is then half as fast.
void Watch(std::uint32_t milliseconds);
// Restarts the chip now.
[[noreturn]] void Restart();

// What the first stage tells the image: in which slot it lies (0 or 1).
void TellSlot(std::uint32_t slot);
std::uint32_t ToldSlot();

}  // namespace kaori::rp2040
