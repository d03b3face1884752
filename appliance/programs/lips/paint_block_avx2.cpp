// The key with AVX2: sixteen samples at a time, in numbers of 16 bits. A normal has the length 64, so that a
// sum of two products stays below 255 * 91. Adding the offset saturates, and a saturated sum keeps its sign.
#include "appliance/programs/lips/paint_block.h"

#if defined(__x86_64__)
#include <immintrin.h>

#define KAORI_AVX2 __attribute__((target("avx2")))

namespace kaori::lips {
namespace {

constexpr auto kSamples = static_cast<std::size_t>(kBlock);
constexpr int kInOrder =
    0xD8;  // AVX2 packs within halves of 128 bits; this order swaps the middle quarters back.

struct Sides {
  __m256i normal[3];  // Cb and Cr as bytes, repeated.
  __m256i offset[3];
};

KAORI_AVX2 inline __m256i Load(const std::uint8_t* at) {
  return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(at));
}

KAORI_AVX2 inline __m256i Load16(const std::uint8_t* at) {
  return _mm256_castsi128_si256(_mm_loadu_si128(reinterpret_cast<const __m128i*>(at)));
}

// The offset takes up that bytes are not centred: normal . (c - 128) + offset = normal . c + (offset - 128
// (cb + cr)).
KAORI_AVX2 inline Sides SidesOf(const Wedge& wedge) {
  Sides sides;
  for (std::size_t n = 0; n < wedge.size(); ++n) {
    const HalfPlane& half = wedge[n];
    const auto pair = static_cast<std::uint16_t>((half.cb & 255) | (half.cr & 255) << 8);
    sides.normal[n] = _mm256_set1_epi16(static_cast<std::int16_t>(pair));
    sides.offset[n] = _mm256_set1_epi16(static_cast<std::int16_t>(half.offset - 128 * (half.cb + half.cr)));
  }
  return sides;
}

// maddubs multiplies unsigned samples by the signed normal and adds Cb's and Cr's product.
KAORI_AVX2 inline __m256i Side(__m256i pairs, const Sides& sides, int n) {
  return _mm256_adds_epi16(_mm256_maddubs_epi16(pairs, sides.normal[n]), sides.offset[n]);
}

// Negative for each of sixteen samples, Cb and Cr as bytes, that lies outside a half plane.
KAORI_AVX2 inline __m256i Signs(__m256i pairs, const Sides& sides) {
  const __m256i two = _mm256_or_si256(Side(pairs, sides, 0), Side(pairs, sides, 1));
  return _mm256_or_si256(two, Side(pairs, sides, 2));
}

// 32 samples to 32 bits: packing keeps the sign of each sum, and movemask collects the signs; set bits of the
// result are paint.
KAORI_AVX2 inline std::uint64_t Paint(__m256i first, __m256i second, const Sides& sides) {
  const __m256i signs = _mm256_packs_epi16(Signs(first, sides), Signs(second, sides));
  const auto outside =
      static_cast<std::uint32_t>(_mm256_movemask_epi8(_mm256_permute4x64_epi64(signs, kInOrder)));
  return static_cast<std::uint32_t>(~outside);
}

// Sixteen samples as Cb Y Cr Y; the luma between them is masked.
KAORI_AVX2 inline __m256i PairsOfYuyv(const std::uint8_t* at) {
  const __m256i low = _mm256_set1_epi16(255);
  const __m256i packed =
      _mm256_packus_epi16(_mm256_and_si256(Load(at), low), _mm256_and_si256(Load(at + 32), low));
  return _mm256_permute4x64_epi64(packed, kInOrder);
}

// Sixteen samples of each plane, interleaved as Cb Cr Cb Cr; the order is put right before, since AVX2
// interleaves within halves of 128 bits.
KAORI_AVX2 inline __m256i PairsOfPlanes(const std::uint8_t* cb, const std::uint8_t* cr) {
  const __m256i blue = _mm256_permute4x64_epi64(Load16(cb), kInOrder);
  const __m256i red = _mm256_permute4x64_epi64(Load16(cr), kInOrder);
  return _mm256_unpacklo_epi8(blue, red);
}

KAORI_AVX2 void KeyYuyv(const ChromaRow& row, std::size_t blocks, const Wedge& wedge, std::uint64_t* into) {
  const Sides sides = SidesOf(wedge);
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::uint8_t* at = row.cb + block * kSamples * 4;
    const std::uint64_t low = Paint(PairsOfYuyv(at), PairsOfYuyv(at + 64), sides);
    into[block] = low | Paint(PairsOfYuyv(at + 128), PairsOfYuyv(at + 192), sides) << 32;
  }
}

KAORI_AVX2 void KeyNv12(const ChromaRow& row, std::size_t blocks, const Wedge& wedge, std::uint64_t* into) {
  const Sides sides = SidesOf(wedge);
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::uint8_t* at = row.cb + block * kSamples * 2;
    const std::uint64_t low = Paint(Load(at), Load(at + 32), sides);
    into[block] = low | Paint(Load(at + 64), Load(at + 96), sides) << 32;
  }
}

KAORI_AVX2 void KeyPlanar(const ChromaRow& row, std::size_t blocks, const Wedge& wedge, std::uint64_t* into) {
  const Sides sides = SidesOf(wedge);
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::uint8_t* cb = row.cb + block * kSamples;
    const std::uint8_t* cr = row.cr + block * kSamples;
    const std::uint64_t low = Paint(PairsOfPlanes(cb, cr), PairsOfPlanes(cb + 16, cr + 16), sides);
    into[block] = low | Paint(PairsOfPlanes(cb + 32, cr + 32), PairsOfPlanes(cb + 48, cr + 48), sides) << 32;
  }
}

}  // namespace

// The file is compiled for any x86-64; only these functions are for AVX2, and run where the processor has it.
KeyBlocks Avx2Key(Packing packing) {
  if (!__builtin_cpu_supports("avx2")) return nullptr;
  if (packing == Packing::kPlanar) return &KeyPlanar;
  return packing == Packing::kNv12 ? &KeyNv12 : &KeyYuyv;
}

}  // namespace kaori::lips
#else
namespace kaori::lips {

KeyBlocks Avx2Key(Packing) {
  return nullptr;
}

}  // namespace kaori::lips
#endif
