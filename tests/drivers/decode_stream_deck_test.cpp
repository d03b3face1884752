// What a Stream Deck is sent and sends, as bytes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "drivers/decode/known_descriptors.h"
#include "drivers/decode/stream_deck.h"

namespace kaori::decode {
namespace {

using ::testing::ElementsAre;
using Bytes = std::vector<std::uint8_t>;

const StreamDeck kMk2 = StreamDeckOf(0x0FD9, 0x0080), kMini = StreamDeckOf(0x0FD9, 0x0063),
                 kPlus = StreamDeckOf(0x0FD9, 0x0084);

Bytes Head(const Bytes& page, std::ptrdiff_t bytes) {
  return {page.begin(), page.begin() + bytes};
}

TEST(StreamDeck, AJpegIsCutIntoPagesOfAThousandBytes) {
  const auto pages = PicturePages(kMk2, 7, Bytes(1016 + 5, 0xAB));
  ASSERT_EQ(pages.size(), 2U);
  EXPECT_EQ(pages[0].size(), 1024U);
  EXPECT_THAT(Head(pages[0], 8), ElementsAre(2, 7, 7, 0, 0xF8, 0x03, 0, 0));
  EXPECT_THAT(Head(pages[1], 8), ElementsAre(2, 7, 7, 1, 5, 0, 1, 0));
}

TEST(StreamDeck, ABitmapOfTheMiniHasALongerHeadAndKeysFromOne) {
  const auto pages = PicturePages(kMini, 5, Bytes(1008 + 1, 0xAB));
  ASSERT_EQ(pages.size(), 2U);
  EXPECT_EQ(pages[1].size(), 1024U);
  EXPECT_THAT(Head(pages[0], 17), ElementsAre(2, 1, 0, 0, 0, 6, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xAB));
  EXPECT_THAT(Head(pages[1], 18), ElementsAre(2, 1, 1, 0, 1, 6, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xAB, 0));
}

TEST(StreamDeck, APictureThatFillsItsPagesHasNoPageMore) {
  EXPECT_EQ(PicturePages(kMk2, 0, Bytes(2 * 1016)).size(), 2U);
  EXPECT_EQ(PicturePages(kMk2, 0, {}).size(), 1U) << "an end without a beginning";
}

TEST(StreamDeck, ATurnedDialIsNoKey) {
  Bytes report(512);
  report[0] = 1;
  report[2] = 8;
  EXPECT_EQ(DeckReportOf(kPlus, report), DeckReport::kKeys);
  report[1] = 3;
  report[4] = report[5] = 1;
  EXPECT_EQ(DeckReportOf(kPlus, report), DeckReport::kOther);
}

TEST(StreamDeck, AReportThatIsCutShortOrOfAnotherNumberIsTorn) {
  Bytes report(512);
  report[0] = 1;
  report[2] = 15;
  EXPECT_EQ(DeckReportOf(kMk2, report), DeckReport::kKeys);
  EXPECT_EQ(DeckReportOf(kMk2, std::span(report).first(18)), DeckReport::kTorn);
  EXPECT_EQ(DeckReportOf(kMk2, {}), DeckReport::kTorn);
  EXPECT_EQ(DeckReportOf(kMini, std::span(report).first(6)), DeckReport::kTorn);
  report[2] = 14;
  EXPECT_EQ(DeckReportOf(kMk2, report), DeckReport::kTorn) << "a key is missing";
  report[2] = 15;
  report[0] = 2;
  EXPECT_EQ(DeckReportOf(kMk2, report), DeckReport::kTorn);
}

TEST(StreamDeck, EveryDeckHasAShapeThatPicturesAreMadeForAndADescriptorOfOurs) {
  constexpr std::array<std::uint16_t, 8> kProducts{0x006D, 0x0080, 0x006C, 0x008F,
                                                   0x009A, 0x0084, 0x0063, 0x0090};
  for (const std::uint16_t product : kProducts) {
    const StreamDeck deck = StreamDeckOf(0x0FD9, product);
    EXPECT_GT(deck.keys, 0);
    EXPECT_TRUE(std::ranges::any_of(
        kDeckShapes, [&](const DeckShape& shape) { return shape.key_px == deck.shape.key_px; }));
    EXPECT_FALSE(KnownDescriptor(0x0FD9, product).empty()) << product;
  }
  EXPECT_EQ(StreamDeckOf(0x0FD9, 0x1234).keys, 0);
  EXPECT_EQ(StreamDeckOf(0x1234, 0x0080).keys, 0);
}

}  // namespace
}  // namespace kaori::decode
