#include "drivers/decode/pointer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drivers/decode/recognise.h"
#include "firmware/wire/pointer.h"
#include "tests/drivers/hid_devices.h"

namespace kaori::decode {
namespace {

using ::testing::FloatNear;
using tests::At;
using Bytes = std::vector<std::uint8_t>;

// The mouse of HID 1.11, appendix E.10, with a wheel: 3 buttons, X and Y of 8 bits, relative.
constexpr auto kMouse = std::to_array<std::uint8_t>({
    0x05, 0x01, 0x09, 0x02, 0xA1, 0x01, 0x09, 0x01, 0xA1, 0x00,              // Mouse, Pointer
    0x05, 0x09, 0x19, 0x01, 0x29, 0x03, 0x15, 0x00, 0x25, 0x01, 0x95, 0x03,  // Buttons 1..3
    0x75, 0x01, 0x81, 0x02, 0x95, 0x01, 0x75, 0x05, 0x81, 0x01,              // and 5 bits of padding
    0x05, 0x01, 0x09, 0x30, 0x09, 0x31, 0x09, 0x38, 0x15, 0x81, 0x25, 0x7F,  // X, Y, Wheel: -127..127
    0x75, 0x08, 0x95, 0x03, 0x81, 0x06, 0xC0, 0xC0,                          // 3 x 8 bits, relative
});

PointerDecoder Mouse(const PointerSample& before = {}) {
  return PointerDecoder::For(tests::Plugged(kMouse), {.counts_across = 1000, .counts_down = 500}, before)
      .value();
}
PointerDecoder Tablet() {
  return PointerDecoder::For(tests::Plugged(wire::kPointerDescriptor)).value();
}

TEST(Pointer, IsKnownByItsDescriptor) {
  EXPECT_EQ(Recognise(ReadReportLayout(kMouse).value()), DeviceKind::kPointer);
  EXPECT_EQ(Recognise(ReadReportLayout(wire::kPointerDescriptor).value()), DeviceKind::kPointer);
  EXPECT_FALSE(PointerDecoder::For(tests::Plugged(tests::kAttack3))) << "a joystick is none";
}

TEST(Pointer, AMouseAddsUpItsMovements) {
  auto mouse = Mouse();
  ASSERT_TRUE(mouse.Decode(Bytes{0, 100, 0, 0}, At(1)));
  ASSERT_TRUE(mouse.Decode(Bytes{0, 100, 0xCE, 0}, At(2)));  // -50.
  EXPECT_THAT(mouse.sample().x, FloatNear(0.7F, 1e-5F));
  EXPECT_THAT(mouse.sample().y, FloatNear(0.4F, 1e-5F)) << "up is towards 0";
  EXPECT_EQ(mouse.sample().at, At(2));
}

TEST(Pointer, AMouseStaysOnThePictureAndTurnsRoundAtOnce) {
  auto mouse = Mouse();
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(mouse.Decode(Bytes{0, 127, 0x81, 0}, At(i)));
  EXPECT_EQ(mouse.sample().x, 1);
  EXPECT_EQ(mouse.sample().y, 0);
  ASSERT_TRUE(
      mouse.Decode(Bytes{0, 0x9C, 50, 0}, At(30)));  // -100 counts: not after the way beyond the edge.
  EXPECT_THAT(mouse.sample().x, FloatNear(0.9F, 1e-5F));
  EXPECT_THAT(mouse.sample().y, FloatNear(0.1F, 1e-5F));
}

TEST(Pointer, ATabletTellsItsPositionFromEdgeToEdge) {
  auto tablet = Tablet();
  ASSERT_TRUE(tablet.Decode(wire::Encode(wire::PointerReport{.x = 0, .y = wire::kPointerEnd}), At(1)));
  EXPECT_EQ(tablet.sample().x, 0);
  EXPECT_EQ(tablet.sample().y, 1);
  ASSERT_TRUE(tablet.Decode(wire::Encode(wire::PointerReport{.x = 16384, .y = 49151}), At(2)));
  EXPECT_THAT(tablet.sample().x, FloatNear(0.25F, 1e-4F));
  EXPECT_THAT(tablet.sample().y, FloatNear(0.75F, 1e-4F));
}

TEST(Pointer, CountsThePushesOfThreeButtons) {
  auto tablet = Tablet();
  for (const std::uint8_t down : Bytes{1, 0, 1, 5, 7, 0}) {
    ASSERT_TRUE(tablet.Decode(wire::Encode(wire::PointerReport{.buttons_down = down}), At(1)));
  }
  EXPECT_EQ(tablet.sample().buttons.pushes[0], 2U);
  EXPECT_EQ(tablet.sample().buttons.pushes[1], 1U);
  EXPECT_EQ(tablet.sample().buttons.pushes[2], 1U);
  EXPECT_EQ(tablet.sample().buttons.down[0], 0U);
}

TEST(Pointer, AddsUpTheNotchesOfTheWheel) {
  auto mouse = Mouse();
  for (const std::uint8_t notches : Bytes{3, 0xFF, 0x80})
    ASSERT_TRUE(mouse.Decode(Bytes{0, 0, 0, notches}, At(1)));
  EXPECT_EQ(mouse.sample().wheel, 2) << "3 on, 1 back; -128 lies outside the logical range and says nothing";
}

TEST(Pointer, KeepsItsPositionAndReleasesItsButtonsWhenTheCableIsPulled) {
  auto mouse = Mouse();
  ASSERT_TRUE(mouse.Decode(Bytes{1, 100, 100, 2}, At(1)));
  mouse.Release();
  EXPECT_EQ(mouse.sample().buttons.down[0], 0U);
  auto again = Mouse(mouse.sample());
  EXPECT_THAT(again.sample().x, FloatNear(0.6F, 1e-5F));
  ASSERT_TRUE(again.Decode(Bytes{0, 100, 0, 1}, At(5)));
  EXPECT_THAT(again.sample().x, FloatNear(0.7F, 1e-5F));
  EXPECT_THAT(again.sample().y, FloatNear(0.7F, 1e-5F));
  EXPECT_EQ(again.sample().wheel, 3);
}

TEST(Pointer, RefusesTornReportsAndStaysAsItWas) {
  auto tablet = Tablet();
  ASSERT_TRUE(tablet.Decode(wire::Encode(wire::PointerReport{.buttons_down = 1, .x = 9999}), At(1)));
  const float x = tablet.sample().x;
  for (const std::size_t length : {0U, 1U, 5U, 7U, 64U}) EXPECT_FALSE(tablet.Decode(Bytes(length), At(2)));
  EXPECT_EQ(tablet.sample().x, x);
  EXPECT_EQ(tablet.sample().buttons.down[0], 1U);
  EXPECT_EQ(tablet.sample().at, At(1));
}

// A touchpad that is a mouse in report 1 and a tablet in report 2.
TEST(Pointer, JoinsAMouseAndATabletOfOneDevice) {
  const Bytes descriptor = {0x05, 0x01, 0x09, 0x02, 0xA1, 0x01, 0x85, 0x01, 0x09, 0x30, 0x09,
                            0x31, 0x15, 0x81, 0x25, 0x7F, 0x75, 0x08, 0x95, 0x02, 0x81, 0x06,  //
                            0x85, 0x02, 0x09, 0x30, 0x09, 0x31, 0x15, 0x00, 0x25, 0x64,        // 0..100
                            0x81, 0x02, 0xC0};
  auto both =
      PointerDecoder::For(tests::Plugged(descriptor), {.counts_across = 100, .counts_down = 100}).value();
  ASSERT_TRUE(both.Decode(Bytes{2, 20, 60}, At(1)));
  ASSERT_TRUE(both.Decode(Bytes{1, 10, 0xF6}, At(2)));
  EXPECT_THAT(both.sample().x, FloatNear(0.3F, 1e-5F));
  EXPECT_THAT(both.sample().y, FloatNear(0.5F, 1e-5F));
}

}  // namespace
}  // namespace kaori::decode
