#include "drivers/decode/stream_deck.h"

#include <algorithm>

#include "firmware/wire/bytes.h"

namespace kaori::decode {
namespace {

constexpr std::uint16_t kElgato = 0x0FD9;
constexpr std::size_t kPage = 1024;
constexpr std::size_t kJpegHead = 8, kBitmapHead = 16;
// Numbers of the two kinds of reports, and the commands behind them.
constexpr std::uint8_t kInput = 0x01, kOutput = 0x02, kJpegPage = 0x07, kBitmapPage = 0x01, kKeys = 0x00;

struct KnownDeck {
  std::uint16_t product;
  StreamDeck deck;
};
// V2, MK.2; XL, XL V2, Neo; +; Mini, Mini MK.2.
constexpr std::array<KnownDeck, 8> kDecks{{{0x006D, {15, kDeckShapes[0]}},
                                           {0x0080, {15, kDeckShapes[0]}},
                                           {0x006C, {32, kDeckShapes[1]}},
                                           {0x008F, {32, kDeckShapes[1]}},
                                           {0x009A, {8, kDeckShapes[1]}},
                                           {0x0084, {8, kDeckShapes[2]}},
                                           {0x0063, {6, kDeckShapes[3]}},
                                           {0x0090, {6, kDeckShapes[3]}}}};

struct PageHead {
  std::size_t number = 0;
  bool is_last = false;
  std::size_t bytes = 0;  // Of the picture, in this page.
};

void WriteHead(const StreamDeck& deck, int key, const PageHead& head, std::span<std::uint8_t> page) {
  page[0] = kOutput;
  if (deck.shape.is_bitmap) {
    page[1] = kBitmapPage;
    page[2] = static_cast<std::uint8_t>(head.number);
    page[4] = head.is_last ? 1 : 0;
    page[5] = static_cast<std::uint8_t>(key + 1);
    return;
  }
  page[1] = kJpegPage;
  page[2] = static_cast<std::uint8_t>(key);
  page[3] = head.is_last ? 1 : 0;
  wire::PutU16(page, 4, static_cast<std::uint16_t>(head.bytes));
  wire::PutU16(page, 6, static_cast<std::uint16_t>(head.number));
}

}  // namespace

StreamDeck StreamDeckOf(std::uint16_t vendor, std::uint16_t product) {
  const auto* const found = std::ranges::find(kDecks, product, &KnownDeck::product);
  return vendor == kElgato && found != kDecks.end() ? found->deck : StreamDeck{};
}

// Behind its number a report of keys has the command 0 and how many keys follow; the Mini's has the keys alone.
DeckReport DeckReportOf(const StreamDeck& deck, std::span<const std::uint8_t> report) {
  const std::size_t head = deck.shape.is_bitmap ? 1 : 4;
  if (report.size() < head + static_cast<std::size_t>(deck.keys) || report[0] != kInput)
    return DeckReport::kTorn;
  if (deck.shape.is_bitmap) return DeckReport::kKeys;
  if (report[1] != kKeys) return DeckReport::kOther;
  return wire::GetU16(report, 2) >= deck.keys ? DeckReport::kKeys : DeckReport::kTorn;
}

// The last page is marked, and each is filled with zeros to its length. An empty picture still gives one page,
// which ends a picture of nothing.
std::vector<std::vector<std::uint8_t>> PicturePages(const StreamDeck& deck, int key,
                                                    std::span<const std::uint8_t> picture) {
  const std::size_t head = deck.shape.is_bitmap ? kBitmapHead : kJpegHead;
  std::vector<std::vector<std::uint8_t>> pages;
  do {
    const auto part = picture.first(std::min(picture.size(), kPage - head));
    picture = picture.subspan(part.size());
    const PageHead says{pages.size(), picture.empty(), part.size()};
    auto& page = pages.emplace_back(kPage);
    WriteHead(deck, key, says, page);
    std::ranges::copy(part, page.begin() + static_cast<std::ptrdiff_t>(head));
  } while (!picture.empty());
  return pages;
}

}  // namespace kaori::decode
