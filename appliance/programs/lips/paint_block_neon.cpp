// The key with NEON, which every 64-bit ARM processor has: sixteen samples at a time, in numbers of 16 bits.
// What is said of sums in paint_block_avx2.cpp holds here too.
#include "appliance/programs/lips/paint_block.h"

#if defined(__aarch64__)
#include <arm_neon.h>

namespace kaori::lips {
namespace {

constexpr std::size_t kAtOnce = 16;
constexpr std::size_t kQuarters = static_cast<std::size_t>(kBlock) / kAtOnce;

// Cb and Cr of sixteen samples.
struct Chroma {
  uint8x16_t cb;
  uint8x16_t cr;
};

int16x8_t Widened(uint8x8_t bytes) {
  return vreinterpretq_s16_u16(vmovl_u8(bytes));
}

// Positive or 0 within the half plane. The offset takes up that bytes are not centred: normal . (c - 128) +
// offset.
int16x8_t SideOfEight(const HalfPlane& half, int16x8_t cb, int16x8_t cr) {
  const auto offset = static_cast<std::int16_t>(half.offset - 128 * (half.cb + half.cr));
  const int16x8_t sum = vmlaq_n_s16(vmulq_n_s16(cb, static_cast<std::int16_t>(half.cb)), cr,
                                    static_cast<std::int16_t>(half.cr));
  return vqaddq_s16(sum, vdupq_n_s16(offset));
}

// All bits of a sample's byte are set where it is paint: the or of three sums is negative where one of them
// is.
uint8x8_t PaintOfEight(const Wedge& wedge, uint8x8_t cb_bytes, uint8x8_t cr_bytes) {
  const int16x8_t cb = Widened(cb_bytes);
  const int16x8_t cr = Widened(cr_bytes);
  const int16x8_t signs = vorrq_s16(vorrq_s16(SideOfEight(wedge[0], cb, cr), SideOfEight(wedge[1], cb, cr)),
                                    SideOfEight(wedge[2], cb, cr));
  return vmovn_u16(vcgezq_s16(signs));
}

// Each sample's byte holds its own bit of eight, or 0.
uint8x16_t BitsOf(const Wedge& wedge, const Chroma& chroma) {
  constexpr std::array<std::uint8_t, kAtOnce> kBits{1, 2, 4, 8, 16, 32, 64, 128, 1, 2, 4, 8, 16, 32, 64, 128};
  const uint8x8_t low = PaintOfEight(wedge, vget_low_u8(chroma.cb), vget_low_u8(chroma.cr));
  const uint8x8_t high = PaintOfEight(wedge, vget_high_u8(chroma.cb), vget_high_u8(chroma.cr));
  return vandq_u8(vcombine_u8(low, high), vld1q_u8(kBits.data()));
}

// Neighbours are added three times, until the bits of eight samples are one byte.
std::uint64_t Word(const std::array<uint8x16_t, kQuarters>& bits) {
  const uint8x16_t fours = vpaddq_u8(vpaddq_u8(bits[0], bits[1]), vpaddq_u8(bits[2], bits[3]));
  return vgetq_lane_u64(vreinterpretq_u64_u8(vpaddq_u8(fours, fours)), 0);
}

Chroma LoadYuyv(const ChromaRow& row, std::size_t sample) {
  const uint8x16x4_t groups = vld4q_u8(row.cb + sample * 4);
  return {groups.val[0], groups.val[2]};
}

Chroma LoadNv12(const ChromaRow& row, std::size_t sample) {
  const uint8x16x2_t pairs = vld2q_u8(row.cb + sample * 2);
  return {pairs.val[0], pairs.val[1]};
}

Chroma LoadPlanar(const ChromaRow& row, std::size_t sample) {
  return {vld1q_u8(row.cb + sample), vld1q_u8(row.cr + sample)};
}

template <Chroma (*kLoad)(const ChromaRow& row, std::size_t sample)>
void Key(const ChromaRow& row, std::size_t blocks, const Wedge& wedge, std::uint64_t* into) {
  for (std::size_t block = 0; block < blocks; ++block) {
    std::array<uint8x16_t, kQuarters> bits{};
    for (std::size_t quarter = 0; quarter < kQuarters; ++quarter)
      bits[quarter] = BitsOf(wedge, kLoad(row, (block * kQuarters + quarter) * kAtOnce));
    into[block] = Word(bits);
  }
}

}  // namespace

KeyBlocks NeonKey(Packing packing) {
  if (packing == Packing::kPlanar) return &Key<LoadPlanar>;
  return packing == Packing::kNv12 ? &Key<LoadNv12> : &Key<LoadYuyv>;
}

}  // namespace kaori::lips
#else
namespace kaori::lips {

KeyBlocks NeonKey(Packing) {
  return nullptr;
}

}  // namespace kaori::lips
#endif
