#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drivers/decode/keyboard.h"
#include "firmware/wire/keyboard.h"
#include "tests/drivers/hid_devices.h"

namespace kaori::decode {
namespace {

using tests::At;
using Bytes = std::vector<std::uint8_t>;

constexpr std::uint8_t kA = 0x04, kB = 0x05, kShift = 0xE1;

KeyboardDecoder Boot() {
  return KeyboardDecoder::For(tests::Plugged({})).value();
}
KeyboardDecoder RollOver() {
  return KeyboardDecoder::For(tests::Plugged(wire::kKeyboardDescriptor)).value();
}

bool Held(const KeyboardDecoder& keyboard, std::uint8_t usage) {
  return ((keyboard.sample().keys.down[usage / 32] >> (usage % 32)) & 1u) != 0;
}

TEST(Keyboard, ReadsTheBootProtocol) {
  auto keyboard = Boot();
  ASSERT_TRUE(keyboard.Decode(Bytes{0x02, 0, kA, 0, 0, 0, 0, kB}, At(1)));
  EXPECT_TRUE(Held(keyboard, kShift));
  EXPECT_TRUE(Held(keyboard, kA));
  EXPECT_TRUE(Held(keyboard, kB));
  ASSERT_TRUE(keyboard.Decode(Bytes{0, 0, kB, 0, 0, 0, 0, 0}, At(2)));
  EXPECT_FALSE(Held(keyboard, kShift));
  EXPECT_FALSE(Held(keyboard, kA));
  EXPECT_TRUE(Held(keyboard, kB));
  EXPECT_EQ(keyboard.sample().keys.pushes[kB], 1u);
}

TEST(Keyboard, ReadsEveryKeyAtOnce) {
  auto keyboard = RollOver();
  wire::KeyboardReport all;
  for (unsigned usage = 4; usage < 0xE8; ++usage) all.Hold(static_cast<std::uint8_t>(usage));
  ASSERT_TRUE(keyboard.Decode(wire::Encode(all), At(1)));
  EXPECT_EQ(keyboard.sample().keys.down, all.down);
  ASSERT_TRUE(keyboard.Decode(wire::Encode(wire::KeyboardReport{}), At(2)));
  for (const std::uint32_t word : keyboard.sample().keys.down) EXPECT_EQ(word, 0u);
}

TEST(Keyboard, IgnoresReportsThatCannotTellTheKeys) {
  auto keyboard = Boot();
  ASSERT_TRUE(keyboard.Decode(Bytes{0, 0, kA, 0, 0, 0, 0, 0}, At(1)));
  for (const std::uint8_t error : Bytes{1, 2, 3})
    ASSERT_TRUE(keyboard.Decode(Bytes{0xFF, 0, error, error, error, error, error, error}, At(2)));
  EXPECT_TRUE(Held(keyboard, kA));
  EXPECT_FALSE(Held(keyboard, kShift));
  for (unsigned usage = 0; usage < 4; ++usage) EXPECT_EQ(keyboard.sample().keys.pushes[usage], 0u);
}

TEST(Keyboard, LeavesNoKeyStuckWhenTheCableIsPulled) {
  auto keyboard = RollOver();
  wire::KeyboardReport report;
  report.Hold(kA);
  ASSERT_TRUE(keyboard.Decode(wire::Encode(report), At(1)));
  keyboard.Release();
  EXPECT_FALSE(Held(keyboard, kA));
  ASSERT_TRUE(keyboard.Decode(wire::Encode(report), At(2)));
  EXPECT_EQ(keyboard.sample().keys.pushes[kA], 2u);
}

TEST(Keyboard, RefusesTornReportsAndStaysAsItWas) {
  auto keyboard = Boot();
  ASSERT_TRUE(keyboard.Decode(Bytes{0, 0, kA, 0, 0, 0, 0, 0}, At(1)));
  for (const std::size_t length : {0u, 1u, 7u, 9u, 64u}) EXPECT_FALSE(keyboard.Decode(Bytes(length), At(2)));
  EXPECT_TRUE(Held(keyboard, kA));
  EXPECT_EQ(keyboard.sample().at, At(1));
}

// Report 1 is the boot array, report 2 a bitmap for the keys beyond six: a key is held while either says so.
TEST(Keyboard, JoinsAnArrayAndABitmapOfTwoReports) {
  const Bytes descriptor = {0x05, 0x01, 0x09, 0x06, 0xA1, 0x01, 0x05, 0x07, 0x85, 0x01, 0x19, 0x00,
                            0x29, 0xFF, 0x26, 0xFF, 0x00, 0x75, 0x08, 0x95, 0x02, 0x81, 0x00,  //
                            0x85, 0x02, 0x19, 0x00, 0x29, 0x7F, 0x25, 0x01, 0x75, 0x01, 0x95, 0x80,
                            0x81, 0x02, 0xC0};
  auto keyboard = KeyboardDecoder::For(tests::Plugged(descriptor)).value();
  Bytes bitmap(17);
  bitmap[0] = 2;
  bitmap[1] = 1u << kB;
  ASSERT_TRUE(keyboard.Decode(Bytes{1, kA, 0}, At(1)));
  ASSERT_TRUE(keyboard.Decode(bitmap, At(2)));
  EXPECT_TRUE(Held(keyboard, kA));
  EXPECT_TRUE(Held(keyboard, kB));
  ASSERT_TRUE(keyboard.Decode(Bytes{1, 0, 0}, At(3)));
  EXPECT_FALSE(Held(keyboard, kA));
  EXPECT_TRUE(Held(keyboard, kB));
}

}  // namespace
}  // namespace kaori::decode
