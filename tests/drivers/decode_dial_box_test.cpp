#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drivers/decode/dial_box.h"
#include "firmware/wire/dial_box.h"
#include "tests/drivers/hid_devices.h"

namespace kaori::decode {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using tests::At;
using Bytes = std::vector<std::uint8_t>;

DialBoxDecoder Ours() {
  return DialBoxDecoder::For(tests::Plugged(wire::kDialBoxDescriptor)).value();
}

ports::HidIdentity Owned(std::uint16_t vendor, std::uint16_t product) {
  return {.port = "1-1", .vendor = vendor, .product = product, .name = "", .descriptor = {}};
}

TEST(DialBox, AddsUpItsTurns) {
  auto box = Ours();
  EXPECT_EQ(box.dials(), 8u);
  for (int n = 0; n < 3; ++n)
    ASSERT_TRUE(
        box.Decode(wire::Encode(wire::DialBoxReport{.turned = {5, -7, 0, 0, 0, 0, 0, 32767}}), At(n)));
  EXPECT_THAT(box.sample().counts, ElementsAre(15, -21, 0, 0, 0, 0, 0, 98301));
  EXPECT_EQ(box.sample().at, At(2));
}

TEST(DialBox, CountsPushesAsButtonsGoDown) {
  auto box = Ours();
  for (const std::uint32_t down : {0x80000001u, 0x80000001u, 0x1u, 0x80000001u})
    ASSERT_TRUE(box.Decode(wire::Encode(wire::DialBoxReport{.buttons_down = down}), At(1)));
  EXPECT_EQ(box.sample().buttons.down[0], 0x80000001u);
  EXPECT_EQ(box.sample().buttons.pushes[0], 1u);
  EXPECT_EQ(box.sample().buttons.pushes[31], 2u);
}

TEST(DialBox, KeepsItsCountsWhenTheCableIsPulled) {
  auto box = Ours();
  ASSERT_TRUE(box.Decode(wire::Encode(wire::DialBoxReport{.buttons_down = 4, .turned = {9}}), At(1)));
  box.Release();
  EXPECT_EQ(box.sample().counts[0], 9);
  EXPECT_EQ(box.sample().buttons.down[0], 0u);
  EXPECT_EQ(box.sample().buttons.pushes[2], 1u);
  auto another = DialBoxDecoder::For(tests::Plugged(wire::kDialBoxDescriptor), box.sample()).value();
  ASSERT_TRUE(another.Decode(wire::Encode(wire::DialBoxReport{.turned = {-2}}), At(2)));
  EXPECT_EQ(another.sample().counts[0], 7);
}

TEST(DialBox, WrapsItsCountsInsteadOfOverflowing) {
  DialSample far;
  far.counts[0] = 2147483647;
  auto box = DialBoxDecoder::For(tests::Plugged(wire::kDialBoxDescriptor), far).value();
  ASSERT_TRUE(box.Decode(wire::Encode(wire::DialBoxReport{.turned = {1}}), At(1)));
  EXPECT_EQ(box.sample().counts[0], -2147483647 - 1);
}

TEST(DialBox, RefusesTornShortAndLongReportsAndStaysAsItWas) {
  auto box = Ours();
  ASSERT_TRUE(box.Decode(wire::Encode(wire::DialBoxReport{.buttons_down = 1, .turned = {3}}), At(1)));
  for (std::size_t length = 0; length <= 64; ++length) {
    if (length == wire::kDialBoxReportBytes) continue;
    const auto refused = box.Decode(Bytes(length, 0xFF), At(2));
    ASSERT_FALSE(refused) << length;
    EXPECT_EQ(refused.error().cause, std::errc::bad_message);
    EXPECT_EQ(refused.error().message().find('\n'), std::string::npos);
  }
  EXPECT_EQ(box.sample().counts[0], 3);
  EXPECT_EQ(box.sample().at, At(1));
  EXPECT_THAT(box.Decode(Bytes(7), At(2)).error().attempt, HasSubstr("7 bytes where 20 are due"));
}

TEST(DialBox, SwitchesItsLamps) {
  EXPECT_THAT(Ours().LampReport(0x80000102u), ElementsAre(0x00, 0x02, 0x01, 0x00, 0x80));
}

TEST(DialBox, RefusesAStickByName) {
  const auto refused = DialBoxDecoder::For(tests::Plugged(tests::kAttack3));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().cause, std::errc::not_supported);
  EXPECT_THAT(refused.error().attempt, HasSubstr("1-4.2"));
}

TEST(PowerMate, TurnsAndIsPushed) {
  auto mate = DialBoxDecoder::For(Owned(0x077D, 0x0410)).value();
  ASSERT_TRUE(mate.Decode(Bytes{0x01, 0xFD, 0, 0, 0, 0}, At(1)));
  EXPECT_EQ(mate.sample().counts[0], -3);
  EXPECT_EQ(mate.sample().buttons.down[0], 1u);
  EXPECT_TRUE(mate.LampReport(1).empty());
}

TEST(ShuttleXpress, CountsItsJogWheelOverTheWrap) {
  auto shuttle = DialBoxDecoder::For(Owned(0x0B33, 0x0020)).value();
  for (const std::uint8_t jog : Bytes{250, 254, 3, 1})
    ASSERT_TRUE(shuttle.Decode(Bytes{7, jog, 0, 0x10, 0}, At(1)));
  EXPECT_EQ(shuttle.sample().counts[0], 7);
  EXPECT_EQ(shuttle.sample().buttons.down[0], 0x10u);
}

// Between two reports the jog wheel may have gone either
// way to the opposite position: that counts as backwards.
TEST(ShuttleXpress, HalfATurnIsBackwardsAndOneCountLessIsForwards) {
  constexpr int kPositions = 256;
  for (const auto& [moved, counts] :
       {std::pair{kPositions / 2 - 1, 127}, {kPositions / 2, -128}, {129, -127}}) {
    auto shuttle = DialBoxDecoder::For(Owned(0x0B33, 0x0020)).value();
    for (const int jog : {20, 20 + moved})
      ASSERT_TRUE(shuttle.Decode(Bytes{0, static_cast<std::uint8_t>(jog), 0, 0, 0}, At(1)));
    EXPECT_EQ(shuttle.sample().counts[0], counts) << moved;
  }
}

TEST(ShuttleXpress, DoesNotJumpAfterAReplug) {
  auto shuttle = DialBoxDecoder::For(Owned(0x0B33, 0x0020)).value();
  for (const std::uint8_t jog : Bytes{10, 12}) ASSERT_TRUE(shuttle.Decode(Bytes{0, jog, 0, 0, 0}, At(1)));
  shuttle.Release();
  for (const std::uint8_t jog : Bytes{100, 101}) ASSERT_TRUE(shuttle.Decode(Bytes{0, jog, 0, 0, 0}, At(2)));
  EXPECT_EQ(shuttle.sample().counts[0], 3);
}

}  // namespace
}  // namespace kaori::decode
