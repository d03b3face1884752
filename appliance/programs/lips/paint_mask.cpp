#include "appliance/programs/lips/paint_mask.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>

#include "appliance/programs/lips/paint_block.h"

namespace kaori::lips {
namespace {

constexpr std::size_t kCacheLine_bytes = 64;
constexpr std::size_t kRowsAhead = 2;  // How many rows of the grid are prefetched while one is keyed.

// How far samples are read beyond the last one's chroma: YUYV is read up to the next luma.
constexpr std::size_t kReadBeyond_bytes = 4;

// Told by where the bytes lie, so that the reader of frames need not name its format. Nothing for layouts
// that only the plain form reads.
std::optional<Packing> PackingOf(const decode::Planes& planes) {
  const auto apart = planes.cr.bytes.data() - planes.cb.bytes.data();
  if (planes.cb.step_bytes == 4 && apart == 2) return Packing::kYuyv;
  if (planes.cb.step_bytes == 2 && apart == 1) return Packing::kNv12;
  if (planes.cb.step_bytes == 1) return Packing::kPlanar;
  return std::nullopt;
}

// One row of chroma that is being keyed.
struct RowWork {
  ChromaRow row;
  int width;         // Samples.
  std::size_t left;  // Bytes from row.cb to the end of the frame.
};

// How many whole blocks lie within the row and the frame. The vector forms read 64 samples at a time and up
// to the end of the last group; the last row of a frame may end before that.
std::size_t WholeBlocks(const RowWork& work) {
  const auto in_row = static_cast<std::size_t>(work.width / kBlock);
  return std::min(in_row, work.left / (static_cast<std::size_t>(kBlock) * work.row.step));
}

// The rest of a row, and layouts that no known camera sends: sample by sample, neutral beyond the end.
std::uint64_t KeyRest(const RowWork& work, std::size_t block, const Wedge& wedge) {
  std::array<std::uint8_t, std::size_t{2} * kBlock + kReadBeyond_bytes> pairs;
  pairs.fill(128);
  const std::size_t from = block * kBlock;
  const std::size_t count = std::min<std::size_t>(kBlock, static_cast<std::size_t>(work.width) - from);
  for (std::size_t n = 0; n < count; ++n) {
    pairs[2 * n] = work.row.cb[(from + n) * work.row.step];
    pairs[2 * n + 1] = work.row.cr[(from + n) * work.row.step];
  }
  std::uint64_t bits = 0;
  PlainKey(Packing::kNv12)({pairs.data(), pairs.data() + 1, 2}, 1, wedge, &bits);
  return bits;
}

// A new frame is in no cache, and skipped rows keep the processor from prefetching it by itself.
void Prefetch(const decode::Plane& plane, std::size_t at) {
  const std::size_t row = static_cast<std::size_t>(plane.width_px) * plane.step_bytes;
  if (at + row > plane.bytes.size()) return;
  for (std::size_t n = 0; n < row; n += kCacheLine_bytes) __builtin_prefetch(&plane.bytes[at + n]);
}

// Set where at least three of a sample and its four neighbours are set; 64 samples are counted at once, bit
// by bit. A full adder for the three in the row, a half adder for the two in the column: three or more of
// five.
std::uint64_t Vote(std::uint64_t left, std::uint64_t here, std::uint64_t right, std::uint64_t above,
                   std::uint64_t below) {
  const std::uint64_t odd_in_row = left ^ here ^ right;
  const std::uint64_t two_in_row = (left & here) | (here & right) | (left & right);
  const std::uint64_t odd_in_column = above ^ below;
  const std::uint64_t two_in_column = above & below;
  return (two_in_row & two_in_column) | ((two_in_row | two_in_column) & (odd_in_row | odd_in_column));
}

bool SameShape(const decode::Plane& a, const decode::Plane& b) {
  return a.width_px == b.width_px && a.height_px == b.height_px && a.stride_bytes == b.stride_bytes &&
         a.step_bytes == b.step_bytes;
}

}  // namespace

// Rows are left out until a sample covers about as much of the picture down as across.
Grid GridOf(const decode::Planes& planes) {
  const decode::Plane& c = planes.cb;
  if (!SameShape(c, planes.cr) || c.width_px <= 0 || c.height_px <= 0) return {};
  const float across = static_cast<float>(planes.y.width_px) / static_cast<float>(c.width_px);
  const float down = static_cast<float>(planes.y.height_px) / static_cast<float>(c.height_px);
  const int step = std::clamp(static_cast<int>(across / down + 0.5F), 1, c.height_px);
  return {c.width_px, c.height_px / step, step, across, down * static_cast<float>(step)};
}

// The raw bits have an empty row at each end, so that the vote needs no test at the edges.
void PaintMask::Read(const decode::Planes& planes, const PaintKey& key) {
  grid_ = GridOf(planes);
  words_ = static_cast<std::size_t>(grid_.width + kBlock - 1) / kBlock;
  const auto rows = static_cast<std::size_t>(grid_.height);
  raw_.assign((rows + 2) * words_, 0);  // There is an empty row above and below.
  voted_.resize(rows * words_);
  const auto packing = PackingOf(planes);
  const KeyBlocks key_blocks = packing ? WidestKey(*packing) : nullptr;
  const std::size_t row_bytes = static_cast<std::size_t>(grid_.row_step) * planes.cb.stride_bytes;
  for (std::size_t y = 0; y < rows; ++y) {
    const std::size_t at = y * row_bytes;
    const std::size_t end = std::min(planes.cb.bytes.size(), planes.cr.bytes.size()) - at;
    const RowWork work{
        {planes.cb.bytes.data() + at, planes.cr.bytes.data() + at, planes.cb.step_bytes}, grid_.width, end};
    Prefetch(planes.cb, at + kRowsAhead * row_bytes);
    const std::size_t whole = key_blocks != nullptr ? WholeBlocks(work) : 0;
    if (whole > 0) key_blocks(work.row, whole, key.weak(), &raw_[(y + 1) * words_]);
    for (std::size_t n = whole; n < words_; ++n) raw_[(y + 1) * words_ + n] = KeyRest(work, n, key.weak());
  }
  VoteOn(rows);
}

// Runs are counted on the way, by their first bits, so that Regions::Find can refuse noise before it looks at
// anything.
void PaintMask::VoteOn(std::size_t rows) {
  runs_ = 0;
  for (std::size_t y = 0; y < rows; ++y) {
    const std::uint64_t* here = &raw_[(y + 1) * words_];
    std::uint64_t last = 0;  // The bit to the left.
    for (std::size_t n = 0; n < words_; ++n) {
      if ((here[n] | *(here + n - words_) | here[n + words_]) == 0) {  // This holds for most of a picture.
        voted_[y * words_ + n] = last = 0;
        continue;
      }
      const std::uint64_t before = n > 0 ? here[n - 1] >> 63 : 0;
      const std::uint64_t after = n + 1 < words_ ? here[n + 1] << 63 : 0;
      const std::uint64_t word =
          Vote(here[n] << 1 | before, here[n], here[n] >> 1 | after, *(here + n - words_), here[n + words_]);
      runs_ += static_cast<std::size_t>(std::popcount(word & ~(word << 1 | last)));
      last = word >> 63;
      voted_[y * words_ + n] = word;
    }
  }
}

}  // namespace kaori::lips
