// Rows of chroma become bits, 64 samples a word: by the widest instructions that the processor has.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "appliance/programs/lips/paint_key.h"

namespace kaori::lips {

inline constexpr int kBlock = 64;  // Samples that become one word of bits.

enum class Packing { kYuyv, kNv12, kPlanar };

struct ChromaRow {
  const std::uint8_t* cb = nullptr;
  const std::uint8_t* cr = nullptr;
  std::size_t step = 1;  // Bytes from sample to sample: 4 in YUYV, 2 in NV12, 1 where they lie apart.
};

using Wedge = std::array<HalfPlane, 3>;

// Writes `blocks` words: a bit is set where PaintKey::at is true. Reads as many samples from `row` on, and up
// to the end of the last one's four or two bytes.
using KeyBlocks = void (*)(const ChromaRow& row, std::size_t blocks, const Wedge& wedge, std::uint64_t* into);

// The same bits from each. Null where this processor lacks the instructions, or the program was built for
// another.
KeyBlocks WidestKey(Packing packing);  // Never null.
KeyBlocks PlainKey(Packing packing);   // Never null: sample by sample, anywhere.
KeyBlocks Sse2Key(Packing packing);
KeyBlocks Avx2Key(Packing packing);

}  // namespace kaori::lips
