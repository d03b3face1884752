#include "appliance/programs/lips/paint_block.h"

namespace kaori::lips {
namespace {

constexpr auto kSamples = static_cast<std::size_t>(kBlock);

// Positive or 0 within the half plane. The sum stays within 16 bits, which the vector forms rely on.
int SideOf(const HalfPlane& half, int cb, int cr) {
  return half.cb * (cb - 128) + half.cr * (cr - 128) + half.offset;
}

// The or of three numbers is negative exactly where one of them is: one test for three comparisons.
void KeyPlain(const ChromaRow& row, std::size_t blocks, const Wedge& wedge, std::uint64_t* into) {
  for (std::size_t block = 0; block < blocks; ++block) {
    std::uint64_t bits = 0;
    for (std::size_t n = 0; n < kSamples; ++n) {
      const std::size_t at = (block * kSamples + n) * row.step;
      const int cb = row.cb[at];
      const int cr = row.cr[at];
      const int signs = SideOf(wedge[0], cb, cr) | SideOf(wedge[1], cb, cr) | SideOf(wedge[2], cb, cr);
      bits |= static_cast<std::uint64_t>(signs >= 0) << n;
    }
    into[block] = bits;
  }
}

}  // namespace

KeyBlocks PlainKey(Packing) {
  return &KeyPlain;
}

// Asked once a picture: the answer costs a look at the processor's features.
KeyBlocks WidestKey(Packing packing) {
  if (const KeyBlocks key = Avx2Key(packing)) return key;
  if (const KeyBlocks key = Sse2Key(packing)) return key;
  if (const KeyBlocks key = NeonKey(packing)) return key;
  return PlainKey(packing);
}

}  // namespace kaori::lips
