#include "appliance/programs/boot/still.h"
#include "appliance/core/last_face/last_face.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace kaori::boot {
namespace {

// More than any screen; it keeps the sizes below within 64 bits.
constexpr int kLongestSide_px = 8192;
constexpr int kColours = 3;

// Reads a PPM's header, field by field.
class Header {
 public:
  explicit Header(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  bool Begins(std::string_view mark) {
    if (bytes_.size() < mark.size() || !std::equal(mark.begin(), mark.end(), bytes_.begin())) return false;
    at_ = mark.size();
    return true;
  }
  // A number after one white space; 0 where there is none or it is too large.
  int Number() {
    int number = 0;
    for (++at_; at_ < bytes_.size() && bytes_[at_] >= '0' && bytes_[at_] <= '9'; ++at_) {
      number = number * 10 + (bytes_[at_] - '0');
      if (number > kLongestSide_px) return 0;
    }
    return number;
  }
  // What stands behind one more white space.
  std::span<const std::uint8_t> Rest() const {
    return at_ < bytes_.size() ? bytes_.subspan(at_ + 1) : std::span<const std::uint8_t>();
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

// Between two pixels of a row or two rows: the first, the second, and how much of it, of 256.
struct Between {
  int first = 0, second = 0, share = 0;
};

// Where the middle of pixel `at` of a screen `to` pixels wide lies among `from` pixels of the still, which
// become `stretched` pixels on the screen, in its middle. Whole numbers in 1/256 of a pixel, so that the
// picture is the same on every machine.
Between Place(int at, int to, int from, int stretched) {
  const std::int64_t twice = 2 * std::int64_t{at} + 1 - to + stretched;  // Of half a stretched pixel.
  const std::int64_t place = twice * from * 128 / stretched - 128;       // Of 1/256 of a pixel of the still.
  const std::int64_t within = std::clamp<std::int64_t>(place, 0, (std::int64_t{from} - 1) * 256);
  const int first = static_cast<int>(within / 256);
  return {first, std::min(first + 1, from - 1), static_cast<int>(within % 256)};
}

// 256 times the mean, so that two of them give 65536 times it: LayRow shifts by 16 bits.
int Mix(int a, int b, int share) {
  return a * (256 - share) + b * share;
}

// Bilinear. The screen wants blue first and an unused fourth byte.
void LayRow(const Still& still, const Between& rows, std::span<const Between> columns, std::uint8_t* to) {
  const auto row = [&](int y) {
    return still.rgb.data() +
           static_cast<std::size_t>(y) * static_cast<std::size_t>(still.width_px) * kColours;
  };
  const std::uint8_t* const upper = row(rows.first);
  const std::uint8_t* const lower = row(rows.second);
  for (const Between& column : columns) {
    const int left = column.first * kColours;
    const int right = column.second * kColours;
    for (int colour = 0; colour < kColours; ++colour) {
      const int above = Mix(upper[left + colour], upper[right + colour], column.share);
      const int below = Mix(lower[left + colour], lower[right + colour], column.share);
      to[kColours - 1 - colour] = static_cast<std::uint8_t>(Mix(above, below, rows.share) >> 16);
    }
    to[kColours] = 0;
    to += kColours + 1;
  }
}

}  // namespace

// The members are filled in the order in which they stand in the file, width before height.
std::optional<Still> ReadStill(std::span<const std::uint8_t> file) {
  Header header(file);
  if (!header.Begins("P6")) return std::nullopt;
  Still still{.width_px = header.Number(), .height_px = header.Number(), .rgb = {}};
  if (header.Number() != 255 || still.width_px == 0 || still.height_px == 0) return std::nullopt;
  const auto wanted =
      static_cast<std::size_t>(still.width_px) * static_cast<std::size_t>(still.height_px) * kColours;
  const auto rest = header.Rest();
  if (rest.size() < wanted) return std::nullopt;
  still.rgb = rest.first(wanted);
  return still;
}

// The stage will not resume a face of another show, so that the splash must not show it either.
std::optional<Still> ReadLastStill(std::span<const std::uint8_t> file,
                                   std::span<const std::uint8_t> pack_begin) {
  const auto face = last_face::Read(file);
  if (!face || face->show != Fnv1a(pack_begin)) return std::nullopt;
  return ReadStill(face->picture);
}

// Columns are worked out once for all rows. Places outside of the still are those of its edge.
void LayStill(const Still& still, const ScreenMemory& screen) {
  const auto stretched_px = static_cast<int>(
      std::max<std::int64_t>(std::int64_t{still.width_px} * screen.height_px / still.height_px, 1));
  std::vector<Between> columns;
  columns.reserve(static_cast<std::size_t>(screen.width_px));
  for (int x = 0; x < screen.width_px; ++x)
    columns.push_back(Place(x, screen.width_px, still.width_px, stretched_px));
  for (int y = 0; y < screen.height_px; ++y) {
    const Between rows = Place(y, screen.height_px, still.height_px, screen.height_px);
    LayRow(still, rows, columns, screen.bytes + static_cast<std::size_t>(y) * screen.pitch_bytes);
  }
}

}  // namespace kaori::boot
