// The board's flash, erased and programmed by functions of the chip's ROM.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "firmware/surface/flash.h"

namespace kaori::rp2040 {

// Code that calls this lies in RAM: while an operation runs, the flash cannot be read. Interrupts go on. The
// watchdog is given eight seconds before each operation, and whoever feeds it makes that less again. One
// side.
class RomFlash final : public surface::Flash {
 public:
  std::span<const std::uint8_t> Read(std::uint32_t at, std::size_t bytes) const override;
  void Erase(std::uint32_t at) override;
  void Program(std::uint32_t at, std::span<const std::uint8_t> bytes) override;

  // The number that the flash's maker gave it, which serves as the chip's (command 4Bh).
  std::array<std::uint8_t, 8> UniqueId();
};

// Which version of the ROM the chip has.
std::uint8_t RomVersion();

// Waits on USB for a new image, as with BOOTSEL held.
[[noreturn]] void StartRomLoader();

}  // namespace kaori::rp2040
