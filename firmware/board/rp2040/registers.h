// The registers of the RP2040 that this firmware uses. Source: RP2040 datasheet, at the sections that are
// named.
#pragma once

#include <cstdint>

namespace kaori::rp2040 {

using Register = volatile std::uint32_t;

inline Register& At(std::uint32_t address) {
  return *reinterpret_cast<Register*>(address);
}
// Peripherals' registers have aliases that set and clear single bits at once (2.1.2).
inline Register& SetAt(std::uint32_t address) {
  return At(address + 0x2000);
}
inline Register& ClearAt(std::uint32_t address) {
  return At(address + 0x3000);
}

// Resets (2.14.3).
inline constexpr std::uint32_t kResets = 0x4000C000, kResetDone = kResets + 8;
inline constexpr std::uint32_t kResetIoBank = 1U << 5, kResetPads = 1U << 8, kResetPllSys = 1U << 12,
                               kResetPllUsb = 1U << 13, kResetSpi0 = 1U << 16, kResetSpi1 = 1U << 17,
                               kResetSysInfo = 1U << 19, kResetUsb = 1U << 24;

// Clocks (2.15.7), crystal (2.16.7), PLLs (2.18.4).
inline constexpr std::uint32_t kClocks = 0x40008000;
inline constexpr std::uint32_t kClockRefControl = kClocks + 0x30, kClockRefSelected = kClocks + 0x38;
inline constexpr std::uint32_t kClockSysControl = kClocks + 0x3C, kClockSysSelected = kClocks + 0x44;
inline constexpr std::uint32_t kClockPeriControl = kClocks + 0x48, kClockUsbControl = kClocks + 0x54;
inline constexpr std::uint32_t kCrystalControl = 0x40024000, kCrystalStatus = 0x40024004,
                               kCrystalStartup = 0x4002400C;
inline constexpr std::uint32_t kPllSys = 0x40028000, kPllUsb = 0x4002C000;

// Watchdog (4.7.6), and what it resets (2.13.5).
inline constexpr std::uint32_t kWatchdogControl = 0x40058000, kWatchdogLoad = 0x40058004,
                               kWatchdogScratch0 = 0x4005800C, kWatchdogTick = 0x4005802C;
inline constexpr std::uint32_t kWatchdogResets = 0x40010008;

// Pins (2.19.6), and the processors' own access to them (2.3.1.7).
constexpr std::uint32_t PinControl(unsigned pin) {
  return 0x40014004 + 8 * pin;
}
constexpr std::uint32_t PinPad(unsigned pin) {
  return 0x4001C004 + 4 * pin;
}
inline constexpr std::uint32_t kPinsIn = 0xD0000004, kPinsSet = 0xD0000014, kPinsClear = 0xD0000018,
                               kPinsDrive = 0xD0000024;

// SPI (4.4.4), an ARM PL022.
inline constexpr std::uint32_t kSpi0 = 0x4003C000, kSpi1 = 0x40040000;
inline constexpr std::uint32_t kSpiControl0 = 0x00, kSpiControl1 = 0x04, kSpiData = 0x08, kSpiStatus = 0x0C,
                               kSpiPrescale = 0x10;

// USB (4.1.4), and the memory of its buffers (4.1.2.5).
inline constexpr std::uint32_t kUsb = 0x50110000, kUsbMemory = 0x50100000;
inline constexpr std::uint32_t kUsbAddress = kUsb, kUsbMain = kUsb + 0x40, kUsbSieControl = kUsb + 0x4C,
                               kUsbSieStatus = kUsb + 0x50, kUsbBufferStatus = kUsb + 0x58,
                               kUsbStallArm = kUsb + 0x68, kUsbMuxing = kUsb + 0x74, kUsbPower = kUsb + 0x78;

// The core's own timer and table of interrupts (ARMv6-M, B3.2 and B3.3).
inline constexpr std::uint32_t kSysTickControl = 0xE000E010, kSysTickReload = 0xE000E014,
                               kSysTickValue = 0xE000E018;
inline constexpr std::uint32_t kVectorTable = 0xE000ED08;

// Which chip it is (2.20.2), and the version of its ROM (2.8.3): the upper byte of the half at 0x12.
inline constexpr std::uint32_t kChipId = 0x40000000, kRomVersionHalf = 0x12;

// The flash's controller (4.10.13) and its select line (2.19.6.2).
inline constexpr std::uint32_t kFlashControllerStatus = 0x18000028, kFlashControllerData = 0x18000060;
inline constexpr std::uint32_t kFlashSelectControl = 0x4001800C;
inline constexpr std::uint32_t kFlashMemory = 0x10000000;

}  // namespace kaori::rp2040
