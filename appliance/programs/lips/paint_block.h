// Rows of chroma are keyed to bits, 64 samples a word, with the widest instructions that the processor has.
// Keying touches every sample of a picture, so that this is written for the processor: AVX2, SSE2, NEON and
// plain, which give the same bits and are compared by a test.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "appliance/programs/lips/paint_key.h"

namespace kaori::lips {

inline constexpr int kBlock = 64;  // The samples of one word of bits.

// How chroma lies in memory.
enum class Packing { kYuyv, kNv12, kPlanar };

// A row of chroma, borrowed.
struct ChromaRow {
  const std::uint8_t* cb = nullptr;
  const std::uint8_t* cr = nullptr;
  std::size_t step = 1;  // Bytes from sample to sample: 4 in YUYV, 2 in NV12, 1 in separate planes.
};

using Wedge = std::array<HalfPlane, 3>;

// Writes `blocks` words to `into`; a bit is set where PaintKey::at is true. It reads 64 samples of `row` for
// each word, and up to the end of the last sample's group of `step` bytes. Pure; any thread.
using KeyBlocks = void (*)(const ChromaRow& row, std::size_t blocks, const Wedge& wedge, std::uint64_t* into);

// All of them give the same bits. Sse2Key, Avx2Key and NeonKey are null where the processor lacks the
// instructions, or the program was built for another architecture.
KeyBlocks WidestKey(Packing packing);  // Never null.
KeyBlocks PlainKey(Packing packing);   // Never null: works sample by sample on any processor.
// For tests, which compare all of them; the program asks for WidestKey.
KeyBlocks Sse2Key(Packing packing);
KeyBlocks Avx2Key(Packing packing);
KeyBlocks NeonKey(Packing packing);

}  // namespace kaori::lips
