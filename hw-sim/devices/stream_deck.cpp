#include "hw-sim/devices/stream_deck.h"

#include <turbojpeg.h>

#include <memory>
#include <numeric>
#include <utility>

#include "firmware/wire/bytes.h"

namespace kaori::sim {
namespace {

constexpr std::size_t kOutputBytes = 1024;  // Of every output report, its number included.
constexpr std::size_t kInputBytes = 512;
constexpr std::size_t kMiniInputBytes = 17;
constexpr std::size_t kJpegHead = 8, kMiniHead = 16;
// Report numbers and the commands behind them.
constexpr std::uint8_t kInput = 0x01, kOutput = 0x02;
constexpr std::uint8_t kJpegCommand = 0x07, kBitmapCommand = 0x01;
constexpr std::uint8_t kKeysCommand = 0x00, kDialsCommand = 0x03, kTurnEvent = 0x01;
constexpr int kDials = 4;
// A bitmap of Windows: the two letters it begins with, and a row's bytes are a multiple of four.
constexpr std::size_t kBitmapHead = 54, kBitmapDepthAt = 28;

// How a kind takes its pictures: turned by half a turn, with rows and columns swapped, or as they are.
enum class Way : std::uint8_t { kUpright, kHalfTurn, kSwapped };
struct Shape {
  std::uint16_t product;
  const char* name;
  int keys;
  int key_px;
  Way way;
};
// In the order of StreamDeck::Kind.
constexpr std::array<Shape, 4> kShapes{{{0x0080, "Stream Deck MK.2", 15, 72, Way::kHalfTurn},
                                        {0x006C, "Stream Deck XL", 32, 96, Way::kHalfTurn},
                                        {0x0084, "Stream Deck +", 8, 120, Way::kUpright},
                                        {0x0063, "Stream Deck Mini", 6, 80, Way::kSwapped}}};

const Shape& ShapeFor(StreamDeck::Kind kind) {
  return kShapes[static_cast<std::size_t>(kind)];
}

// Bytes of a vendor: report 1 comes, report 2 goes, and report 3 is for settings.
constexpr auto kDescriptor = std::to_array<std::uint8_t>({
    0x05, 0x0C, 0x09, 0x01, 0xA1, 0x01, 0x06, 0x00, 0xFF, 0x15, 0x00, 0x26, 0xFF, 0x00, 0x75, 0x08,  //
    0x85, 0x01, 0x09, 0x01, 0x96, 0xFF, 0x01, 0x81, 0x02,  // 511 bytes
    0x85, 0x02, 0x09, 0x02, 0x96, 0xFF, 0x03, 0x91, 0x02,  // 1023 bytes
    0x85, 0x03, 0x09, 0x03, 0x95, 0x1F, 0xB1, 0x02, 0xC0,  // 31 bytes
});
// The Mini's input report is shorter.
constexpr auto kMiniDescriptor = std::to_array<std::uint8_t>({
    0x05, 0x0C, 0x09, 0x01, 0xA1, 0x01, 0x06, 0x00, 0xFF, 0x15, 0x00, 0x26, 0xFF, 0x00, 0x75, 0x08,  //
    0x85, 0x01, 0x09, 0x01, 0x95, 0x10, 0x81, 0x02,              // 16 bytes
    0x85, 0x02, 0x09, 0x02, 0x96, 0xFF, 0x03, 0x91, 0x02, 0xC0,  // 1023 bytes
});

struct EndDecoder {
  void operator()(void* decoder) const { tjDestroy(decoder); }
};

// As it lies in the file; nothing where it is no JPEG of that size.
std::optional<KeyPicture> FromJpeg(std::span<const std::uint8_t> bytes, int side_px) {
  const std::unique_ptr<void, EndDecoder> decoder(tjInitDecompress());
  int width = 0, height = 0, sampling = 0, colours = 0;
  const auto size = static_cast<unsigned long>(bytes.size());
  if (tjDecompressHeader3(decoder.get(), bytes.data(), size, &width, &height, &sampling, &colours) != 0 ||
      width != side_px || height != side_px)
    return std::nullopt;
  KeyPicture picture{side_px, std::vector<std::uint8_t>(static_cast<std::size_t>(side_px * side_px * 3))};
  if (tjDecompress2(decoder.get(), bytes.data(), size, picture.rgb.data(), side_px, 0, side_px, TJPF_RGB,
                    0) != 0)
    return std::nullopt;
  return picture;
}

// Of 24 bits a point, without a table of colours, the bottom row first and blue before red.
std::optional<KeyPicture> FromBitmap(std::span<const std::uint8_t> bytes, int side_px) {
  const auto side = static_cast<std::size_t>(side_px);
  const std::size_t row = (side * 3 + 3) / 4 * 4;
  if (bytes.size() != kBitmapHead + row * side || bytes[0] != 'B' || bytes[1] != 'M' ||
      wire::GetU32(bytes, 2) != bytes.size() || wire::GetU32(bytes, 10) != kBitmapHead ||
      wire::GetU32(bytes, 18) != side || wire::GetU32(bytes, 22) != side ||
      wire::GetU16(bytes, kBitmapDepthAt) != 24 || wire::GetU32(bytes, 30) != 0)
    return std::nullopt;
  KeyPicture picture{side_px, {}};
  for (std::size_t y = side; y-- > 0;)
    for (std::size_t x = 0; x < side; ++x)
      for (std::size_t colour = 3; colour-- > 0;)
        picture.rgb.push_back(bytes[kBitmapHead + y * row + x * 3 + colour]);
  return picture;
}

// The point that lies at (x, y) of the key lies there in the picture that was sent.
std::size_t SentAt(Way way, std::size_t x, std::size_t y, std::size_t side) {
  if (way == Way::kHalfTurn) return (side - 1 - y) * side + side - 1 - x;
  return way == Way::kSwapped ? x * side + y : y * side + x;
}

KeyPicture AsSeen(const KeyPicture& sent, Way way) {
  KeyPicture seen{sent.side_px, {}};
  const auto side = static_cast<std::size_t>(sent.side_px);
  for (std::size_t y = 0; y < side; ++y)
    for (std::size_t x = 0; x < side; ++x) {
      const auto from = sent.rgb.begin() + static_cast<std::ptrdiff_t>(SentAt(way, x, y, side) * 3);
      seen.rgb.insert(seen.rgb.end(), from, from + 3);
    }
  return seen;
}

}  // namespace

double KeyPicture::brightness() const {
  return rgb.empty() ? 0 : std::accumulate(rgb.begin(), rgb.end(), 0.0) / static_cast<double>(rgb.size());
}

int StreamDeck::keys() const {
  return ShapeFor(kind_).keys;
}

HidDeviceName StreamDeck::device_name() const {
  constexpr std::uint16_t kElgato = 0x0FD9;
  const Shape& shape = ShapeFor(kind_);
  const std::span<const std::uint8_t> mini(kMiniDescriptor), others(kDescriptor);
  return {kElgato, shape.product, shape.name, kind_ == Kind::kMini ? mini : others, kOutputBytes};
}

void StreamDeck::Say(Report report) {
  if (std::exchange(tears_next_, false)) report.resize(report.size() / 2 - 5);
  waiting_.push_back(std::move(report));
}

void StreamDeck::Set(int key, bool down) {
  if (key < 0 || key >= keys()) return;
  const std::uint32_t bit = std::uint32_t{1} << static_cast<unsigned>(key);
  down_ = down ? down_ | bit : down_ & ~bit;
  Say(Standing());
}

// Of each dial how far it was turned, in a signed byte.
void StreamDeck::TurnDial(int dial, int clicks) {
  if (kind_ != Kind::kPlus || dial < 0 || dial >= kDials) return;
  Report turn(kInputBytes);
  turn[0] = kInput;
  turn[1] = kDialsCommand;
  wire::PutU16(turn, 2, 1 + kDials);
  turn[4] = kTurnEvent;
  turn[5 + static_cast<std::size_t>(dial)] = static_cast<std::uint8_t>(clicks);
  Say(std::move(turn));
}

std::optional<Time> StreamDeck::next_due() const {
  return waiting_.empty() ? std::nullopt : std::optional(Time{});
}

std::optional<Report> StreamDeck::NextReport(Time) {
  if (waiting_.empty()) return std::nullopt;
  Report report = std::move(waiting_.front());
  waiting_.pop_front();
  return report;
}

// Behind the number: the command, how many keys follow in 16 bits, and a byte for each of them; the Mini has the keys alone.
Report StreamDeck::Standing() const {
  Report report(kind_ == Kind::kMini ? kMiniInputBytes : kInputBytes);
  std::size_t at = 1;
  report[0] = kInput;
  if (kind_ != Kind::kMini) {
    report[1] = kKeysCommand;
    wire::PutU16(report, 2, static_cast<std::uint16_t>(keys()));
    at = 4;
  }
  for (int key = 0; key < keys(); ++key) report[at++] = static_cast<std::uint8_t>(down_ >> key & 1U);
  return report;
}

// The Mini's pages have no length: what lies behind the last byte of the bitmap is filling.
std::optional<StreamDeck::Page> StreamDeck::PageOf(std::span<const std::uint8_t> report) const {
  if (report.size() != kOutputBytes || report[0] != kOutput) return std::nullopt;
  Page page;
  if (kind_ == Kind::kMini) {
    if (report[1] != kBitmapCommand || report[5] == 0) return std::nullopt;
    page = {report[5] - std::size_t{1}, report[2], report[4] == 1, report.subspan(kMiniHead)};
  } else {
    const std::size_t bytes = wire::GetU16(report, 4);
    if (report[1] != kJpegCommand || bytes > kOutputBytes - kJpegHead) return std::nullopt;
    page = {report[2], wire::GetU16(report, 6), report[3] == 1, report.subspan(kJpegHead, bytes)};
  }
  if (page.key >= static_cast<std::size_t>(keys())) return std::nullopt;
  return page;
}

// Pages come in order, from 0 on; the last one says that it is, and the key shows the picture then.
void StreamDeck::HandleOutput(std::span<const std::uint8_t> report) {
  const auto page = PageOf(report);
  if (page && page->number == 0) coming_[page->key] = {};
  if (!page || page->number != coming_[page->key].pages) {
    ++wrong_pages_;
    return;
  }
  Coming& coming = coming_[page->key];
  coming.bytes.insert(coming.bytes.end(), page->bytes.begin(), page->bytes.end());
  ++coming.pages;
  if (!page->is_last) return;
  const Shape& shape = ShapeFor(kind_);
  if (kind_ == Kind::kMini && coming.bytes.size() >= 6)
    coming.bytes.resize(std::min<std::size_t>(coming.bytes.size(), wire::GetU32(coming.bytes, 2)));
  const auto sent =
      kind_ == Kind::kMini ? FromBitmap(coming.bytes, shape.key_px) : FromJpeg(coming.bytes, shape.key_px);
  coming = {};
  sent ? ++pictures_ : ++wrong_pictures_;
  if (sent) shown_[page->key] = AsSeen(*sent, shape.way);
}

void StreamDeck::PowerCycle() {
  waiting_.clear();
  coming_ = {};
  shown_ = {};
}

}  // namespace kaori::sim
