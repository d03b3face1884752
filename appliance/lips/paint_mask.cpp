#include "appliance/lips/paint_mask.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace kaori::lips {
namespace {

constexpr int kBlock = 64;  // Samples that become one word of bits.

enum class Packing { kYuyv, kNv12, kPlanar, kOther };

struct ChromaRow {
  const std::uint8_t* cb;
  const std::uint8_t* cr;
  std::size_t step;
};

using Levels = std::array<std::int16_t, kBlock>;
using Wedge = std::array<HalfPlane, 3>;

// Loops of a known length without branches: the compiler makes vectors of them (see CMakeLists.txt).
[[gnu::always_inline]] inline void UnpackYuyv(const std::uint8_t* at, Levels& cb, Levels& cr) {
  std::array<std::uint32_t, kBlock> words;
  std::memcpy(words.data(), at, sizeof(words));
  for (int i = 0; i < kBlock; ++i) cb[i] = static_cast<std::int16_t>((words[i] & 255) - 128);
  for (int i = 0; i < kBlock; ++i) cr[i] = static_cast<std::int16_t>((words[i] >> 16 & 255) - 128);
}

[[gnu::always_inline]] inline void UnpackNv12(const std::uint8_t* at, Levels& cb, Levels& cr) {
  std::array<std::uint16_t, kBlock> words;
  std::memcpy(words.data(), at, sizeof(words));
  for (int i = 0; i < kBlock; ++i) cb[i] = static_cast<std::int16_t>((words[i] & 255) - 128);
  for (int i = 0; i < kBlock; ++i) cr[i] = static_cast<std::int16_t>((words[i] >> 8) - 128);
}

[[gnu::always_inline]] inline void UnpackPlanar(const ChromaRow& row, Levels& cb, Levels& cr) {
  std::array<std::uint8_t, kBlock> bytes;
  std::memcpy(bytes.data(), row.cb, kBlock);
  for (int i = 0; i < kBlock; ++i) cb[i] = static_cast<std::int16_t>(bytes[i] - 128);
  std::memcpy(bytes.data(), row.cr, kBlock);
  for (int i = 0; i < kBlock; ++i) cr[i] = static_cast<std::int16_t>(bytes[i] - 128);
}

// The rest of a row, and shapes that no camera of ours sends: sample by sample, neutral beyond the end.
void UnpackSome(const ChromaRow& row, int count, Levels& cb, Levels& cr) {
  cb.fill(0);
  cr.fill(0);
  for (int i = 0; i < count; ++i) {
    cb[static_cast<std::size_t>(i)] =
        static_cast<std::int16_t>(row.cb[static_cast<std::size_t>(i) * row.step] - 128);
    cr[static_cast<std::size_t>(i)] =
        static_cast<std::int16_t>(row.cr[static_cast<std::size_t>(i) * row.step] - 128);
  }
}

// A sample is paint where it lies on no negative side: the sign of the three sides or-ed.
[[gnu::always_inline]] inline std::uint64_t KeyBlock(const Levels& cb, const Levels& cr, const Wedge& wedge) {
  const auto [a, b, c] = wedge;
  std::array<std::uint8_t, kBlock> paint;
  for (int i = 0; i < kBlock; ++i) {
    const auto first = static_cast<std::int16_t>(cb[i] * a.cb + cr[i] * a.cr + a.offset);
    const auto second = static_cast<std::int16_t>(cb[i] * b.cb + cr[i] * b.cr + b.offset);
    const auto third = static_cast<std::int16_t>(cb[i] * c.cb + cr[i] * c.cr + c.offset);
    const auto outside = static_cast<std::uint16_t>(first | second | third);
    paint[i] = static_cast<std::uint8_t>((outside >> 15) ^ 1);
  }
  std::uint64_t bits = 0;
  for (int i = 0; i < 8; ++i) {  // Eight bytes of 0 or 1 become eight bits by one multiplication.
    std::uint64_t eight = 0;
    std::memcpy(&eight, &paint[static_cast<std::size_t>(i) * 8], 8);
    bits |= (eight * 0x0102040810204080U >> 56) << (8 * i);
  }
  return bits;
}

struct RowWork {
  ChromaRow row;
  int width;         // Samples.
  std::size_t left;  // Bytes from row.cb to the end of the frame.
  Packing packing;
};

[[gnu::always_inline]] inline void KeyRowBody(const RowWork& work, const Wedge& wedge, std::uint64_t* out) {
  Levels cb;
  Levels cr;
  for (int x = 0; x < work.width; x += kBlock) {
    const std::size_t from = static_cast<std::size_t>(x) * work.row.step;
    const ChromaRow at{work.row.cb + from, work.row.cr + from, work.row.step};
    const bool whole = x + kBlock <= work.width && from + kBlock * work.row.step <= work.left;
    if (whole && work.packing == Packing::kYuyv)
      UnpackYuyv(at.cb, cb, cr);
    else if (whole && work.packing == Packing::kNv12)
      UnpackNv12(at.cb, cb, cr);
    else if (whole && work.packing == Packing::kPlanar)
      UnpackPlanar(at, cb, cr);
    else
      UnpackSome(at, std::min(kBlock, work.width - x), cb, cr);
    *out++ = KeyBlock(cb, cr, wedge);
  }
}

using KeyRow = void (*)(const RowWork&, const Wedge&, std::uint64_t*);

void KeyRowPlain(const RowWork& work, const Wedge& wedge, std::uint64_t* out) {
  KeyRowBody(work, wedge, out);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void KeyRowWide(const RowWork& work, const Wedge& wedge, std::uint64_t* out) {
  KeyRowBody(work, wedge, out);
}
KeyRow FastestKeyRow() {
  return __builtin_cpu_supports("avx2") ? KeyRowWide : KeyRowPlain;
}
#else
KeyRow FastestKeyRow() {
  return KeyRowPlain;
}
#endif

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
  static const KeyRow key_row = FastestKeyRow();
  grid_ = GridOf(planes);
  words_ = static_cast<std::size_t>(grid_.width + kBlock - 1) / kBlock;
  const auto rows = static_cast<std::size_t>(grid_.height);
  raw_.assign((rows + 2) * words_, 0);  // An empty row above and below.
  voted_.resize(rows * words_);
  const Packing packing = PackingOf(planes);
  for (std::size_t y = 0; y < rows; ++y) {
    const std::size_t at = y * static_cast<std::size_t>(grid_.row_step) * planes.cb.stride_bytes;
    const std::size_t end = std::min(planes.cb.bytes.size(), planes.cr.bytes.size()) - at;
    key_row({{planes.cb.bytes.data() + at, planes.cr.bytes.data() + at, planes.cb.step_bytes},
             grid_.width,
             end,
             packing},
            key.weak(), &raw_[(y + 1) * words_]);
  }
  for (std::size_t y = 0; y < rows; ++y) {
    const std::uint64_t* here = &raw_[(y + 1) * words_];
    for (std::size_t n = 0; n < words_; ++n) {
      const std::uint64_t before = n > 0 ? here[n - 1] >> 63 : 0;
      const std::uint64_t after = n + 1 < words_ ? here[n + 1] << 63 : 0;
      voted_[y * words_ + n] =
          Vote(here[n] << 1 | before, here[n], here[n] >> 1 | after, *(here + n - words_), here[n + words_]);
    }
  }
}

}  // namespace kaori::lips
