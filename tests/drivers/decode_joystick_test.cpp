#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "drivers/decode/joystick.h"
#include "firmware/wire/stick_pod.h"
#include "tests/drivers/hid_devices.h"

namespace kaori::decode {
namespace {

using tests::At;
using Bytes = std::vector<std::uint8_t>;

constexpr StickSettings kRaw{.dead_zone = 0};

JoystickDecoder Stick(std::span<const std::uint8_t> descriptor, const StickSettings& settings = kRaw) {
  return JoystickDecoder::For(tests::Plugged(descriptor), settings).value();
}

TEST(StickPod, GivesAxesHatAndButtonsTheBoardsWay) {
  auto stick = Stick(wire::kStickPodDescriptor);
  const auto sample = stick.Decode(
      wire::Encode(wire::StickPodReport{
          .x = 32767, .y = -32767, .twist = -16384, .slider = 65535, .hat = 7, .buttons_down = 0x801}),
      At(3));
  ASSERT_TRUE(sample) << sample.error().message();
  EXPECT_FLOAT_EQ(sample->x, 1);
  EXPECT_FLOAT_EQ(sample->y, 1);  // Pushed forwards.
  EXPECT_NEAR(sample->twist, -0.5, 1e-4);
  EXPECT_FLOAT_EQ(sample->slider, 1);
  EXPECT_EQ(sample->hat, 7);
  EXPECT_EQ(sample->buttons.down[0], 0x801u);
  EXPECT_EQ(sample->at, At(3));
}

TEST(StickPod, HasACentredHatInTheNullState) {
  auto stick = Stick(wire::kStickPodDescriptor);
  ASSERT_TRUE(stick.Decode(wire::Encode(wire::StickPodReport{.hat = 0}), At(1)));
  EXPECT_EQ(stick.sample().hat, 0);
  ASSERT_TRUE(stick.Decode(wire::Encode(wire::StickPodReport{}), At(1)));
  EXPECT_EQ(stick.sample().hat, -1);
}

TEST(StickPod, IsNeutralAfterAReplugUntilItsFirstReport) {
  auto stick = Stick(wire::kStickPodDescriptor);
  ASSERT_TRUE(
      stick.Decode(wire::Encode(wire::StickPodReport{
                       .x = 32767, .y = 32767, .twist = 9000, .slider = 65535, .hat = 2, .buttons_down = 1}),
                   At(1)));
  stick.Release();
  EXPECT_EQ(stick.sample().x, 0);
  EXPECT_EQ(stick.sample().y, 0);
  EXPECT_EQ(stick.sample().twist, 0);
  EXPECT_EQ(stick.sample().hat, -1);
  EXPECT_EQ(stick.sample().buttons.down[0], 0u);
  EXPECT_FLOAT_EQ(stick.sample().slider, 1);  // A slider has no neutral.
  // An axis at its end is not garbage.
  ASSERT_TRUE(stick.Decode(wire::Encode(wire::StickPodReport{.x = -32767}), At(2)));
  EXPECT_FLOAT_EQ(stick.sample().x, -1);
}

TEST(StickPod, RefusesTornReportsAndStaysAsItWas) {
  auto stick = Stick(wire::kStickPodDescriptor);
  ASSERT_TRUE(stick.Decode(wire::Encode(wire::StickPodReport{.x = 32767}), At(1)));
  for (const std::size_t length : {0u, 1u, 9u, 11u, 64u}) EXPECT_FALSE(stick.Decode(Bytes(length), At(2)));
  EXPECT_FLOAT_EQ(stick.sample().x, 1);
  EXPECT_EQ(stick.sample().at, At(1));
}

TEST(StickPod, CalibratesItsCentreAndStillReachesBothEnds) {
  auto stick = Stick(wire::kStickPodDescriptor);
  ASSERT_TRUE(stick.Decode(wire::Encode(wire::StickPodReport{.x = 3000}), At(1)));
  EXPECT_GT(stick.sample().x, 0.05f);
  stick.CalibrateCentre();
  EXPECT_EQ(stick.sample().x, 0);
  ASSERT_TRUE(stick.Decode(wire::Encode(wire::StickPodReport{.x = 32767}), At(2)));
  EXPECT_FLOAT_EQ(stick.sample().x, 1);
  ASSERT_TRUE(stick.Decode(wire::Encode(wire::StickPodReport{.x = -32767}), At(2)));
  EXPECT_FLOAT_EQ(stick.sample().x, -1);
}

TEST(StickPod, DoesNotMistakeAHeldStickForItsCentre) {
  auto stick = Stick(wire::kStickPodDescriptor);
  ASSERT_TRUE(stick.Decode(wire::Encode(wire::StickPodReport{.x = 20000, .y = 3000}), At(1)));
  stick.CalibrateCentre();
  EXPECT_NEAR(stick.sample().x, 0.61, 0.01);
  EXPECT_EQ(stick.sample().y, 0);
}

TEST(StickPod, GoesOnWithTheCentresOfItsPredecessor) {
  auto stick = Stick(wire::kStickPodDescriptor);
  const auto report = wire::Encode(wire::StickPodReport{.x = 3000, .y = -2001, .twist = -777});
  ASSERT_TRUE(stick.Decode(report, At(1)));
  stick.CalibrateCentre();
  auto next = Stick(wire::kStickPodDescriptor);
  next.SetCentres(stick.centres());
  ASSERT_TRUE(next.Decode(report, At(2)));
  EXPECT_EQ(next.sample().x, 0);
  EXPECT_EQ(next.sample().y, 0);
  EXPECT_EQ(next.sample().twist, 0);
  next.SetCentres({0.9f, std::nanf(""), -2});
  for (const float centre : next.centres()) EXPECT_EQ(centre, 0);
}

TEST(StickShape, IsStillInTheDeadZoneAndLeavesItWithoutAJump) {
  const StickSettings settings{.dead_zone = 0.1f};
  EXPECT_EQ(Shape(0.0999f, settings), 0);
  EXPECT_EQ(Shape(-0.0999f, settings), 0);
  EXPECT_NEAR(Shape(0.1001f, settings), 0, 0.001);
  EXPECT_FLOAT_EQ(Shape(1, settings), 1);
  EXPECT_FLOAT_EQ(Shape(-1, settings), -1);
}

TEST(StickShape, RisesMonotonicallyWithEveryCurve) {
  for (const float curve : {0.0f, 0.5f, 1.0f}) {
    float before = -1;
    for (int n = -100; n <= 100; ++n) {
      const float now = Shape(static_cast<float>(n) / 100, {.dead_zone = 0.05f, .curve = curve});
      EXPECT_GE(now, before);
      before = now;
    }
  }
  EXPECT_LT(Shape(0.5f, {.dead_zone = 0, .curve = 1}), 0.2f);
}

TEST(StickShape, SaysOneWhereAWornStickEnds) {
  EXPECT_FLOAT_EQ(Shape(0.9f, {.dead_zone = 0, .reach = 0.9f}), 1);
  EXPECT_FLOAT_EQ(Shape(1.0f, {.dead_zone = 0, .reach = 0.9f}), 1);
}

TEST(StickShape, SurvivesSettingsThatMakeNoSense) {
  for (const float odd : {-5.0f, 0.0f, 1.0f, 5.0f})
    EXPECT_LE(std::abs(Shape(0.7f, {.dead_zone = odd, .reach = odd, .curve = odd})), 1.0f);
}

TEST(Extreme3dPro, IsReadByItsDescriptor) {
  auto stick = Stick(tests::kExtreme3dPro);
  // X 1023, Y 0, hat 2, twist 255, buttons 1 and 8, slider 0, buttons 9 and 12.
  ASSERT_TRUE(stick.Decode(Bytes{0xFF, 0x03, 0x20, 0xFF, 0x81, 0x00, 0x09}, At(1)));
  EXPECT_FLOAT_EQ(stick.sample().x, 1);
  EXPECT_FLOAT_EQ(stick.sample().y, 1);
  EXPECT_EQ(stick.sample().hat, 2);
  EXPECT_FLOAT_EQ(stick.sample().twist, 1);
  EXPECT_FLOAT_EQ(stick.sample().slider, 0);
  EXPECT_EQ(stick.sample().buttons.down[0], 0x981u);
  // At rest: X and Y 512, hat 8, twist 128.
  ASSERT_TRUE(stick.Decode(Bytes{0x00, 0x02, 0x88, 0x80, 0x00, 0xFF, 0x00}, At(2)));
  EXPECT_EQ(stick.sample().x, 0);
  EXPECT_EQ(stick.sample().y, 0);
  EXPECT_EQ(stick.sample().twist, 0);
  EXPECT_EQ(stick.sample().hat, -1);
  EXPECT_FLOAT_EQ(stick.sample().slider, 1);
}

TEST(Attack3, HasItsThrottleOnZAndRestsInTheDeadZone) {
  auto stick = Stick(tests::kAttack3, {});
  ASSERT_TRUE(stick.Decode(Bytes{0x82, 0x7F, 0x00, 0x00, 0x00}, At(1)));
  EXPECT_EQ(stick.sample().x, 0);
  EXPECT_EQ(stick.sample().y, 0);
  ASSERT_TRUE(stick.Decode(Bytes{0x00, 0xFF, 0xFF, 0x01, 0x04}, At(2)));
  EXPECT_FLOAT_EQ(stick.sample().x, -1);
  EXPECT_FLOAT_EQ(stick.sample().y, -1);
  EXPECT_FLOAT_EQ(stick.sample().slider, 1);
  EXPECT_EQ(stick.sample().buttons.down[0], 0x401u);
}

TEST(T16000m, IsReadByItsDescriptor) {
  auto stick = Stick(tests::kT16000m, {.dead_zone = 0, .slider_reversed = true});
  ASSERT_TRUE(stick.Decode(Bytes{0x01, 0x80, 0x0F, 0x00, 0x20, 0xFF, 0x3F, 0x80, 0x00}, At(1)));
  EXPECT_EQ(stick.sample().x, 0);
  EXPECT_FLOAT_EQ(stick.sample().y, -1);
  EXPECT_EQ(stick.sample().hat, -1);
  EXPECT_EQ(stick.sample().twist, 0);
  EXPECT_FLOAT_EQ(stick.sample().slider, 1);
  EXPECT_EQ(stick.sample().buttons.down[0], 0x8001u);
}

// Two reports: an axis in each, and the buttons split between them.
TEST(Joystick, ReadsAxesAndButtonsOfSeveralReports) {
  const Bytes descriptor = {0x05, 0x01, 0x09, 0x04, 0xA1, 0x01, 0x15, 0x81, 0x25, 0x7F, 0x75, 0x08, 0x95,
                            0x01, 0x85, 0x01, 0x09, 0x30, 0x81, 0x02, 0x85, 0x02, 0x09, 0x31, 0x81, 0x02,  //
                            0x05, 0x09, 0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x08,                    //
                            0x85, 0x01, 0x19, 0x01, 0x29, 0x08, 0x81, 0x02, 0x85, 0x02, 0x19, 0x09, 0x29,
                            0x10, 0x81, 0x02, 0xC0};
  auto stick = Stick(descriptor);
  ASSERT_TRUE(stick.Decode(Bytes{1, 127, 0x01}, At(1)));
  EXPECT_FLOAT_EQ(stick.sample().x, 1);
  EXPECT_EQ(stick.sample().y, 0);
  ASSERT_TRUE(stick.Decode(Bytes{2, 127, 0x80}, At(2)));
  EXPECT_FLOAT_EQ(stick.sample().x, 1);
  EXPECT_FLOAT_EQ(stick.sample().y, -1);
  EXPECT_EQ(stick.sample().buttons.down[0], 0x8001u);
  ASSERT_TRUE(stick.Decode(Bytes{1, 127, 0x00}, At(3)));
  EXPECT_EQ(stick.sample().buttons.down[0], 0x8000u);
}

TEST(Joystick, StretchesAFourWayHatOverTheEighths) {
  const Bytes descriptor = {0x05, 0x01, 0x09, 0x04, 0xA1, 0x01, 0x09, 0x30, 0x09, 0x31, 0x26, 0xFF, 0x00,
                            0x75, 0x08, 0x95, 0x02, 0x81, 0x02, 0x09, 0x39, 0x15, 0x01, 0x25, 0x04,  //
                            0x95, 0x01, 0x81, 0x42, 0xC0};
  auto stick = Stick(descriptor);
  for (const auto& [raw, eighth] :
       std::vector<std::pair<std::uint8_t, int>>{{1, 0}, {2, 2}, {3, 4}, {4, 6}, {0, -1}}) {
    ASSERT_TRUE(stick.Decode(Bytes{0, 0, raw}, At(1)));
    EXPECT_EQ(stick.sample().hat, eighth);
  }
}

}  // namespace
}  // namespace kaori::decode
