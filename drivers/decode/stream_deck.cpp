#include "drivers/decode/stream_deck.h"

#include <algorithm>
#include <array>

#include "firmware/wire/bytes.h"

namespace kaori::decode {
namespace {

constexpr std::uint16_t kElgato = 0x0FD9;
constexpr std::size_t kPage = 1024;
constexpr std::size_t kHead = 8;

struct KnownDeck {
  std::uint16_t product;
  StreamDeck deck;
};
// V2, MK.2, XL, XL V2, Neo, +.
constexpr std::array<KnownDeck, 6> kDecks{{{0x006D, {15, 72, true}},
                                           {0x0080, {15, 72, true}},
                                           {0x006C, {32, 96, true}},
                                           {0x008F, {32, 96, true}},
                                           {0x009A, {8, 96, true}},
                                           {0x0084, {8, 120, false}}}};

}  // namespace

StreamDeck StreamDeckOf(std::uint16_t vendor, std::uint16_t product) {
  const auto* const found = std::ranges::find(kDecks, product, &KnownDeck::product);
  return vendor == kElgato && found != kDecks.end() ? found->deck : StreamDeck{};
}

// The last page is marked in its byte 3, and filled with zeros to its length. An empty JPEG still gives one
// page, which ends a picture of nothing.
std::vector<std::vector<std::uint8_t>> PicturePages(int key, std::span<const std::uint8_t> jpeg) {
  std::vector<std::vector<std::uint8_t>> pages;
  do {
    const auto part = jpeg.first(std::min(jpeg.size(), kPage - kHead));
    jpeg = jpeg.subspan(part.size());
    auto& page = pages.emplace_back(kPage);
    page[0] = 0x02;
    page[1] = 0x07;
    page[2] = static_cast<std::uint8_t>(key);
    page[3] = jpeg.empty() ? 1 : 0;
    wire::PutU16(page, 4, static_cast<std::uint16_t>(part.size()));
    wire::PutU16(page, 6, static_cast<std::uint16_t>(pages.size() - 1));
    std::ranges::copy(part, page.begin() + kHead);
  } while (!jpeg.empty());
  return pages;
}

}  // namespace kaori::decode
