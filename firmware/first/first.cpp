// The first stage: chooses a slot, copies its image to RAM and starts it. Never updated in the field.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/board/rp2040/chip.h"
#include "firmware/board/rp2040/registers.h"
#include "firmware/board/rp2040/rom_flash.h"
#include "firmware/board/rp2040/start.h"
#include "firmware/surface/slots.h"

namespace kaori::rp2040 {
namespace {

// Images are linked for the beginning of RAM and begin with their vector table: the stack pointer, then the
// entry.
constexpr std::uint32_t kImageInRam = 0x20000000;
// Where the first stage's own code begins (first.ld): an image that reaches so far would be no slot's choice.
constexpr std::uint32_t kFirstStageInRam = 0x2003C000;
static_assert(kImageInRam + surface::kMostImageBytes <= kFirstStageInRam);
// An image that does not come so far as to feed the watchdog itself uses up a try, and the other slot's turn
// comes.
constexpr std::uint32_t kImageFeedsWithinMs = 8000;

[[noreturn]] void Start(std::span<const std::uint8_t> image) {
  std::ranges::copy(image, reinterpret_cast<std::uint8_t*>(kImageInRam));
  At(kVectorTable) = kImageInRam;
  asm volatile(
      "msr msp, %0\n"
      "bx %1\n"
      :
      : "r"(At(kImageInRam)), "r"(At(kImageInRam + 4)));
  __builtin_unreachable();
}

}  // namespace

// The vector table that all programs share names it; here the timer never runs.
void Look() {}

// A header whose length is beyond the room is none (ReadHeader), so that nothing writes over this code. The slot's number outlives the jump in a register of the watchdog, where the image finds it.
void Main() {
  RomFlash flash;
  const auto slot = surface::Choose(flash);
  const auto header = slot ? surface::ReadHeader(flash, *slot) : std::nullopt;
  // Nothing that could be started: any computer can bring an image.
  if (!header) StartRomLoader();
  Watch(kImageFeedsWithinMs);
  TellSlot(static_cast<std::uint32_t>(*slot));
  Start(surface::Image(flash, *slot, header->image));
}

}  // namespace kaori::rp2040
