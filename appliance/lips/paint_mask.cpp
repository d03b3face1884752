#include "appliance/lips/paint_mask.h"

#include <algorithm>
#include <array>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace kaori::lips {
namespace {

constexpr int kBlock = 64;  // Samples that become one word of bits.

constexpr std::size_t kCacheLine_bytes = 64;
constexpr std::size_t kRowsAhead = 2;  // Of the grid, that are fetched while one is looked at.

enum class Packing { kYuyv, kNv12, kPlanar, kOther };

struct ChromaRow {
  const std::uint8_t* cb;
  const std::uint8_t* cr;
  std::size_t step;
};

// A block of Cb Cr Cb Cr.
using Pairs = std::array<std::uint8_t, std::size_t{2} * kBlock>;

// The rest of a row, and shapes that no camera of ours sends: sample by sample, neutral beyond the end.
void Gather(const ChromaRow& row, int count, Pairs& pairs) {
  pairs.fill(128);
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    pairs[2 * i] = row.cb[i * row.step];
    pairs[2 * i + 1] = row.cr[i * row.step];
  }
}

#if defined(__SSE2__)
// Every x86-64 has these instructions. Four samples at a time: Cb and Cr lie side by side as 16-bit numbers,
// which is what the multiply-and-add of pairs takes.
class BlockKey {
 public:
  explicit BlockKey(const std::array<HalfPlane, 3>& wedge) {
    for (std::size_t n = 0; n < wedge.size(); ++n) {
      const HalfPlane& half = wedge[n];
      sides_[n].normal =
          _mm_set_epi16(half.cr, half.cb, half.cr, half.cb, half.cr, half.cb, half.cr, half.cb);
      sides_[n].offset = _mm_set1_epi32(half.offset - 128 * (half.cb + half.cr));
    }
  }

  // Cb Y Cr Y: the luma between them is masked away.
  std::uint64_t Yuyv(const std::uint8_t* at) const {
    const __m128i low = _mm_set1_epi16(255);
    std::uint64_t outside = 0;
    for (int n = 0; n < kBlock; n += 4)
      outside |= Outside(_mm_and_si128(Load(at + 4 * static_cast<std::size_t>(n)), low)) << n;
    return ~outside;
  }

  std::uint64_t Nv12(const std::uint8_t* at) const {
    const __m128i zero = _mm_setzero_si128();
    std::uint64_t outside = 0;
    for (int n = 0; n < kBlock; n += 8) {
      const __m128i eight = Load(at + 2 * static_cast<std::size_t>(n));
      outside |= Outside(_mm_unpacklo_epi8(eight, zero)) << n;
      outside |= Outside(_mm_unpackhi_epi8(eight, zero)) << (n + 4);
    }
    return ~outside;
  }

  std::uint64_t Planar(const std::uint8_t* cb, const std::uint8_t* cr) const {
    Pairs pairs;
    for (std::size_t n = 0; n < kBlock; n += 16) {
      const __m128i some_cb = Load(cb + n);
      const __m128i some_cr = Load(cr + n);
      Store(&pairs[2 * n], _mm_unpacklo_epi8(some_cb, some_cr));
      Store(&pairs[2 * n + 16], _mm_unpackhi_epi8(some_cb, some_cr));
    }
    return Nv12(pairs.data());
  }

 private:
  static __m128i Load(const std::uint8_t* at) {
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(at));
  }
  static void Store(std::uint8_t* at, __m128i value) {
    _mm_storeu_si128(reinterpret_cast<__m128i*>(at), value);
  }

  // A sample is paint where it lies on no negative side: where the three signs or-ed are clear.
  std::uint64_t Outside(__m128i four) const {
    const auto side = [&](const Side& of) {
      return _mm_add_epi32(_mm_madd_epi16(four, of.normal), of.offset);
    };
    const __m128i signs = _mm_or_si128(_mm_or_si128(side(sides_[0]), side(sides_[1])), side(sides_[2]));
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(_mm_movemask_ps(_mm_castsi128_ps(signs))));
  }

  struct Side {
    __m128i normal;
    __m128i offset;
  };
  std::array<Side, 3> sides_;
};
#else
// The same anywhere: loops of a known length without branches, of which the compiler makes vectors.
class BlockKey {
 public:
  explicit BlockKey(const std::array<HalfPlane, 3>& wedge) : wedge_(wedge) {}

  std::uint64_t Yuyv(const std::uint8_t* at) const { return Strided(at, at + 2, 4); }
  std::uint64_t Nv12(const std::uint8_t* at) const { return Strided(at, at + 1, 2); }
  std::uint64_t Planar(const std::uint8_t* cb, const std::uint8_t* cr) const { return Strided(cb, cr, 1); }

 private:
  std::uint64_t Strided(const std::uint8_t* cb, const std::uint8_t* cr, std::size_t step) const {
    const auto [a, b, c] = wedge_;
    std::array<std::uint8_t, kBlock> paint;
    for (std::size_t i = 0; i < kBlock; ++i) {
      const int blue = cb[i * step] - 128;
      const int red = cr[i * step] - 128;
      const int signs = (blue * a.cb + red * a.cr + a.offset) | (blue * b.cb + red * b.cr + b.offset) |
                        (blue * c.cb + red * c.cr + c.offset);
      paint[i] = signs < 0 ? 0 : 1;
    }
    std::uint64_t bits = 0;
    for (std::size_t n = 0; n < kBlock; n += 8) {  // Eight bytes become eight bits by one multiplication.
      std::uint64_t eight = 0;
      std::memcpy(&eight, &paint[n], 8);
      bits |= (eight * 0x0102040810204080U >> 56) << n;
    }
    return bits;
  }

  std::array<HalfPlane, 3> wedge_;
};
#endif

struct RowWork {
  ChromaRow row;
  int width;         // Samples.
  std::size_t left;  // Bytes from row.cb to the end of the frame.
  Packing packing;
};

std::uint64_t KeyBlock(const RowWork& work, int x, const BlockKey& key) {
  const std::size_t from = static_cast<std::size_t>(x) * work.row.step;
  const ChromaRow at{work.row.cb + from, work.row.cr + from, work.row.step};
  const bool whole = x + kBlock <= work.width && from + kBlock * work.row.step <= work.left;
  if (whole && work.packing == Packing::kYuyv) return key.Yuyv(at.cb);
  if (whole && work.packing == Packing::kNv12) return key.Nv12(at.cb);
  if (whole && work.packing == Packing::kPlanar) return key.Planar(at.cb, at.cr);
  Pairs pairs;
  Gather(at, std::min(kBlock, work.width - x), pairs);
  return key.Nv12(pairs.data());
}

// A frame comes fresh from the camera, in no cache, and rows that are left out make it hard to foresee.
void Prefetch(const camera::Plane& plane, std::size_t at) {
  const std::size_t row = static_cast<std::size_t>(plane.width_px) * plane.step_bytes;
  if (at + row > plane.bytes.size()) return;
  for (std::size_t n = 0; n < row; n += kCacheLine_bytes) __builtin_prefetch(&plane.bytes[at + n]);
}

Packing PackingOf(const camera::Planes& planes) {
  const auto apart = planes.cr.bytes.data() - planes.cb.bytes.data();
  if (planes.cb.step_bytes == 4 && apart == 2) return Packing::kYuyv;
  if (planes.cb.step_bytes == 2 && apart == 1) return Packing::kNv12;
  return planes.cb.step_bytes == 1 ? Packing::kPlanar : Packing::kOther;
}

// At least three of a sample and its four neighbours: counted for 64 samples at once, bit by bit.
std::uint64_t Vote(std::uint64_t left, std::uint64_t here, std::uint64_t right, std::uint64_t above,
                   std::uint64_t below) {
  const std::uint64_t odd_in_row = left ^ here ^ right;
  const std::uint64_t two_in_row = (left & here) | (here & right) | (left & right);
  const std::uint64_t odd_in_column = above ^ below;
  const std::uint64_t two_in_column = above & below;
  return (two_in_row & two_in_column) | ((two_in_row | two_in_column) & (odd_in_row | odd_in_column));
}

bool SameShape(const camera::Plane& a, const camera::Plane& b) {
  return a.width_px == b.width_px && a.height_px == b.height_px && a.stride_bytes == b.stride_bytes &&
         a.step_bytes == b.step_bytes;
}

}  // namespace

Grid GridOf(const camera::Planes& planes) {
  const camera::Plane& c = planes.cb;
  if (!SameShape(c, planes.cr) || c.width_px <= 0 || c.height_px <= 0) return {};
  const float across = static_cast<float>(planes.y.width_px) / static_cast<float>(c.width_px);
  const float down = static_cast<float>(planes.y.height_px) / static_cast<float>(c.height_px);
  const int step = std::clamp(static_cast<int>(across / down + 0.5F), 1, c.height_px);
  return {c.width_px, c.height_px / step, step, across, down * static_cast<float>(step)};
}

void PaintMask::Read(const camera::Planes& planes, const PaintKey& key) {
  const BlockKey block_key(key.weak());
  grid_ = GridOf(planes);
  words_ = static_cast<std::size_t>(grid_.width + kBlock - 1) / kBlock;
  const auto rows = static_cast<std::size_t>(grid_.height);
  raw_.assign((rows + 2) * words_, 0);  // An empty row above and below.
  voted_.resize(rows * words_);
  const Packing packing = PackingOf(planes);
  for (std::size_t y = 0; y < rows; ++y) {
    const std::size_t at = y * static_cast<std::size_t>(grid_.row_step) * planes.cb.stride_bytes;
    const std::size_t end = std::min(planes.cb.bytes.size(), planes.cr.bytes.size()) - at;
    const RowWork work{{planes.cb.bytes.data() + at, planes.cr.bytes.data() + at, planes.cb.step_bytes},
                       grid_.width,
                       end,
                       packing};
    Prefetch(planes.cb, at + kRowsAhead * static_cast<std::size_t>(grid_.row_step) * planes.cb.stride_bytes);
    for (std::size_t n = 0; n < words_; ++n)
      raw_[(y + 1) * words_ + n] = KeyBlock(work, static_cast<int>(n) * kBlock, block_key);
  }
  VoteOn(rows);
}

void PaintMask::VoteOn(std::size_t rows) {
  for (std::size_t y = 0; y < rows; ++y) {
    const std::uint64_t* here = &raw_[(y + 1) * words_];
    for (std::size_t n = 0; n < words_; ++n) {
      if ((here[n] | *(here + n - words_) | here[n + words_]) == 0) {  // Most of a picture.
        voted_[y * words_ + n] = 0;
        continue;
      }
      const std::uint64_t before = n > 0 ? here[n - 1] >> 63 : 0;
      const std::uint64_t after = n + 1 < words_ ? here[n + 1] << 63 : 0;
      voted_[y * words_ + n] =
          Vote(here[n] << 1 | before, here[n], here[n] >> 1 | after, *(here + n - words_), here[n + words_]);
    }
  }
}

}  // namespace kaori::lips
