#include "firmware/board/rp2040/rom_flash.h"

#include <algorithm>

#include "firmware/board/rp2040/chip.h"
#include "firmware/board/rp2040/registers.h"

namespace kaori::rp2040 {
namespace {

// The ROM's table of functions: pairs of a code of two letters and a pointer of 16 bits (2.8.3).
constexpr std::uint32_t kFunctionTable = 0x14;

constexpr std::uint16_t Code(char first, char second) {
  return static_cast<std::uint16_t>(first | second << 8);
}

// The compiler takes an address below a page for a mistake, and must not know this one.
std::uint32_t RomHalf(std::uint32_t address) {
  asm("" : "+r"(address));
  return *reinterpret_cast<const volatile std::uint16_t*>(address);
}

// Walks the ROM's table to the code. All codes of this file are in every ROM of the chip, so that there is an
// end.
template <class Function>
Function Rom(std::uint16_t code) {
  std::uint32_t entry = RomHalf(kFunctionTable);
  while (RomHalf(entry) != code) entry += 4;
  return reinterpret_cast<Function>(static_cast<std::uintptr_t>(RomHalf(entry + 2)));
}

using Plain = void (*)();
using RangeErase = void (*)(std::uint32_t at, std::uint32_t bytes, std::uint32_t block_bytes,
                            std::uint8_t block_command);
using RangeProgram = void (*)(std::uint32_t at, const std::uint8_t* data, std::uint32_t bytes);
using UsbBoot = void (*)(std::uint32_t lamp_pins, std::uint32_t disabled);

// Blocks of 64 KB would be erased by D8h where they fit: a sector never does.
constexpr std::uint32_t kBlockBytes = 65536;
constexpr std::uint8_t kBlockErase = 0xD8;
// How long the watchdog waits while the flash works. A command takes 0.4 s at most (Flash); the rest is for a
// chip that is slow with age.
constexpr std::uint32_t kLongestOperationMs = 8000;

// The flash takes commands from its making on, and is memory again after it.
class CommandMode {
 public:
  CommandMode() {
    Watch(kLongestOperationMs);
    Rom<Plain>(Code('I', 'F'))();
    Rom<Plain>(Code('E', 'X'))();
  }
  ~CommandMode() {
    Rom<Plain>(Code('F', 'C'))();
    Rom<Plain>(Code('C', 'X'))();
  }
  CommandMode(const CommandMode&) = delete;
  CommandMode& operator=(const CommandMode&) = delete;
};

// Drives the flash's select line: 2 is low, 3 is high.
void Select(bool selected) {
  const std::uint32_t others = At(kFlashSelectControl) & ~(3U << 8);
  At(kFlashSelectControl) = others | (selected ? 2U : 3U) << 8;
}

// One byte each way.
std::uint8_t Exchange(std::uint8_t out) {
  constexpr std::uint32_t kRoomToSend = 1U << 1, kReceived = 1U << 3;
  while ((At(kFlashControllerStatus) & kRoomToSend) == 0) {
  }
  At(kFlashControllerData) = out;
  while ((At(kFlashControllerStatus) & kReceived) == 0) {
  }
  return static_cast<std::uint8_t>(At(kFlashControllerData));
}

}  // namespace

// Flash is memory to the processor while no command runs (2.6.3).
std::span<const std::uint8_t> RomFlash::Read(std::uint32_t at, std::size_t bytes) const {
  return {reinterpret_cast<const std::uint8_t*>(kFlashMemory + at), bytes};
}

// Interrupts look at the dials meanwhile: they and all that they call lie in RAM, for which the image is
// linked.
void RomFlash::Erase(std::uint32_t at) {
  const CommandMode mode;
  Rom<RangeErase>(Code('R', 'E'))(at, surface::kSectorBytes, kBlockBytes, kBlockErase);
}

void RomFlash::Program(std::uint32_t at, std::span<const std::uint8_t> bytes) {
  // The ROM programs whole pages; ones leave bits as they are.
  std::array<std::uint8_t, surface::kPageBytes> page;
  page.fill(0xFF);
  std::ranges::copy(bytes.first(std::min(bytes.size(), page.size())), page.begin());
  const CommandMode mode;
  Rom<RangeProgram>(Code('R', 'P'))(at, page.data(), surface::kPageBytes);
}

// Command 4Bh of the W25Q flash: four bytes that say nothing, then eight of the number that each chip has
// alone.
std::array<std::uint8_t, 8> RomFlash::UniqueId() {
  constexpr std::uint8_t kReadUniqueId = 0x4B;
  const CommandMode mode;
  Select(true);
  Exchange(kReadUniqueId);
  for (int dummy = 0; dummy < 4; ++dummy) Exchange(0);
  std::array<std::uint8_t, 8> id;
  for (auto& byte : id) byte = Exchange(0);
  Select(false);
  return id;
}

std::uint8_t RomVersion() {
  return static_cast<std::uint8_t>(RomHalf(kRomVersionHalf) >> 8);
}

// The chip's own loader: it shows itself as a disk onto which an image can be copied.
void StartRomLoader() {
  Rom<UsbBoot>(Code('U', 'B'))(0, 0);
  for (;;) {
  }
}

}  // namespace kaori::rp2040
