// The flash of a control surface: what a chip's NOR flash can do, and where what lies in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace kaori::surface {

// Units of the chip: what is erased at once, and what is programmed at once.
inline constexpr std::uint32_t kSectorBytes = 4096;
inline constexpr std::uint32_t kPageBytes = 256;

// Places in bytes from the flash's beginning. firmware/images.py reads these lines.
inline constexpr std::uint32_t kFirstStageBytes = 16 * 1024;  // From 0.
inline constexpr std::uint32_t kSlotAAt = 0x10000;
static_assert(kFirstStageBytes <= kSlotAAt);
inline constexpr std::uint32_t kSlotBAt = 0x50000;
inline constexpr std::uint32_t kSlotBytes = 256 * 1024;
inline constexpr std::uint32_t kStoreAt = 0x90000;  // Two sectors.

// Memory that is read like any other, whose bits are only ever cleared one by one, and set again a sector at
// a time. One side.
class Flash {
 public:
  // The span is good until the next Erase or Program.
  virtual std::span<const std::uint8_t> Read(std::uint32_t at, std::size_t bytes) const = 0;
  // Sets all bits of the sector that begins at `at`. Takes up to 0.4 s.
  virtual void Erase(std::uint32_t at) = 0;
  // Clears those bits of one page that are 0 in `bytes`: 256 of them at most, from the page's beginning `at`.
  // Takes up to 3 ms.
  virtual void Program(std::uint32_t at, std::span<const std::uint8_t> bytes) = 0;

 protected:
  // Nobody owns one by this type.
  ~Flash() = default;
};

}  // namespace kaori::surface
