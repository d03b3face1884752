// The two slots for images in flash, and which of them is started.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "firmware/surface/flash.h"
#include "firmware/wire/surface_feature.h"

namespace kaori::surface {

// A slot: a page with the header, a page with the record, and from the second sector on the image, which is
// linked for RAM.
//
//   header  0 u32 "KSF1", 4 u32 generation, 8 SurfaceImage (44 bytes), 52 u8[4] the beginning of the SHA-256 of 0..51
//   record  0 u8[3] tries: a byte in which any bit is 0 is used up; 3 u8: 0 is kept
//
// The header is written last, so that a slot without a whole image has none. Bits of the record are only ever
// cleared.
enum class Slot : std::uint8_t { kA, kB };

inline constexpr unsigned kTries = 3;
// What RAM has room for below the code of the first stage, which copies an image there; a slot has room for more.
inline constexpr std::uint32_t kMostImageBytes = 0x3C000;
static_assert(kMostImageBytes <= kSlotBytes - kSectorBytes);

struct SlotHeader {
  std::uint32_t generation = 0;  // The newer image has the higher one.
  wire::SurfaceImage image;
};

// Bytes from the flash's beginning.
std::uint32_t At(Slot slot);
std::uint32_t ImageAt(Slot slot);
Slot Other(Slot slot);

// Nothing where it was never written, not to its end, or is damaged.
std::optional<SlotHeader> ReadHeader(const Flash& flash, Slot slot);
// Writes it, into a slot whose first sector is erased.
void WriteHeader(Flash& flash, Slot slot, const SlotHeader& header);
// Whether the image has the hash that its header says. Reads all of it.
bool HasItsHash(const Flash& flash, Slot slot, const wire::SurfaceImage& image);
std::span<const std::uint8_t> Image(const Flash& flash, Slot slot, const wire::SurfaceImage& image);

bool IsKept(const Flash& flash, Slot slot);
void Keep(Flash& flash, Slot slot);

// What the first stage starts: the newest whole image that is kept or has a try left, of which one is used up
// then. Where there is none such, the newest that is whole: a device that nobody confirms goes on playing.
// Nothing: no slot has one.
std::optional<Slot> Choose(Flash& flash);

}  // namespace kaori::surface
