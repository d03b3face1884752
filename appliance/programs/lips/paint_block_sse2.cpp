// The key with SSE2, which every x86-64 processor has: four samples at a time.
#include "appliance/programs/lips/paint_block.h"

#if defined(__SSE2__)
#include <emmintrin.h>

namespace kaori::lips {
namespace {

constexpr auto kSamples = static_cast<std::size_t>(kBlock);

__m128i Load(const std::uint8_t* at) {
  return _mm_loadu_si128(reinterpret_cast<const __m128i*>(at));
}

// Cb and Cr side by side as 16-bit numbers, as the instruction that multiplies and adds pairs (pmaddwd) needs
// them.
class Sides {
 public:
  // As in SidesOf of the AVX2 form: the offset takes up that samples are bytes around 128.
  explicit Sides(const Wedge& wedge) {
    for (std::size_t n = 0; n < wedge.size(); ++n) {
      const HalfPlane& half = wedge[n];
      sides_[n].normal =
          _mm_set_epi16(half.cr, half.cb, half.cr, half.cb, half.cr, half.cb, half.cr, half.cb);
      sides_[n].offset = _mm_set1_epi32(half.offset - 128 * (half.cb + half.cr));
    }
  }

  // A sample is paint where it lies on no negative side, which means that the bitwise or of the three sums is
  // positive.
  std::uint64_t Outside(__m128i four) const {
    const __m128i signs = _mm_or_si128(_mm_or_si128(Side(four, 0), Side(four, 1)), Side(four, 2));
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(_mm_movemask_ps(_mm_castsi128_ps(signs))));
  }

  // Samples as Cb and Cr in bytes.
  std::uint64_t OutsideOfEight(__m128i eight) const {
    const __m128i zero = _mm_setzero_si128();
    return Outside(_mm_unpacklo_epi8(eight, zero)) | Outside(_mm_unpackhi_epi8(eight, zero)) << 4;
  }

 private:
  __m128i Side(__m128i four, std::size_t n) const {
    return _mm_add_epi32(_mm_madd_epi16(four, sides_[n].normal), sides_[n].offset);
  }

  struct Half {
    __m128i normal;
    __m128i offset;
  };
  std::array<Half, 3> sides_;
};

// Samples as Cb Y Cr Y; the luma between them is masked.
void KeyYuyv(const ChromaRow& row, std::size_t blocks, const Wedge& wedge, std::uint64_t* into) {
  const Sides sides(wedge);
  const __m128i low = _mm_set1_epi16(255);
  for (std::size_t block = 0; block < blocks; ++block) {
    std::uint64_t outside = 0;
    for (std::size_t n = 0; n < kSamples; n += 4)
      outside |= sides.Outside(_mm_and_si128(Load(row.cb + (block * kSamples + n) * 4), low)) << n;
    into[block] = ~outside;
  }
}

void KeyNv12(const ChromaRow& row, std::size_t blocks, const Wedge& wedge, std::uint64_t* into) {
  const Sides sides(wedge);
  for (std::size_t block = 0; block < blocks; ++block) {
    std::uint64_t outside = 0;
    for (std::size_t n = 0; n < kSamples; n += 8)
      outside |= sides.OutsideOfEight(Load(row.cb + (block * kSamples + n) * 2)) << n;
    into[block] = ~outside;
  }
}

// The planes are interleaved first, and are then as those of NV12.
void KeyPlanar(const ChromaRow& row, std::size_t blocks, const Wedge& wedge, std::uint64_t* into) {
  const Sides sides(wedge);
  for (std::size_t block = 0; block < blocks; ++block) {
    std::uint64_t outside = 0;
    for (std::size_t n = 0; n < kSamples; n += 16) {
      const __m128i cb = Load(row.cb + block * kSamples + n);
      const __m128i cr = Load(row.cr + block * kSamples + n);
      outside |= sides.OutsideOfEight(_mm_unpacklo_epi8(cb, cr)) << n;
      outside |= sides.OutsideOfEight(_mm_unpackhi_epi8(cb, cr)) << (n + 8);
    }
    into[block] = ~outside;
  }
}

}  // namespace

KeyBlocks Sse2Key(Packing packing) {
  if (packing == Packing::kPlanar) return &KeyPlanar;
  return packing == Packing::kNv12 ? &KeyNv12 : &KeyYuyv;
}

}  // namespace kaori::lips
#else
namespace kaori::lips {

KeyBlocks Sse2Key(Packing) {
  return nullptr;
}

}  // namespace kaori::lips
#endif
