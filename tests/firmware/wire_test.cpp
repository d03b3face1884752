#include <gtest/gtest.h>

#include "firmware/wire/dial_box.h"
#include "firmware/wire/keyboard.h"
#include "firmware/wire/stick_pod.h"
#include "firmware/wire/surface_feature.h"

namespace kaori::wire {
namespace {

TEST(DialBoxWire, PutsButtonsFirstAndDialsLittleEndian) {
  const auto bytes = Encode(DialBoxReport{.buttons_down = 0x80000001u, .turned = {-2, 0x0102}});
  EXPECT_EQ(bytes[0], 0x01);
  EXPECT_EQ(bytes[3], 0x80);
  EXPECT_EQ(bytes[4], 0xFE);
  EXPECT_EQ(bytes[5], 0xFF);
  EXPECT_EQ(bytes[6], 0x02);
  EXPECT_EQ(bytes[7], 0x01);
}

TEST(DialBoxWire, ComesBackFromItsBytes) {
  const DialBoxReport report{.buttons_down = 0xDEADBEEFu, .turned = {-32768, 32767, 0, -1, 1, 5, -5, 9}};
  const DialBoxReport back = DecodeDialBox(Encode(report));
  EXPECT_EQ(back.buttons_down, report.buttons_down);
  EXPECT_EQ(back.turned, report.turned);
  EXPECT_EQ(DecodeLamps(EncodeLamps(0xA5000001u)), 0xA5000001u);
}

TEST(SurfaceWire, AStatusComesBackFromItsBytes) {
  const SurfaceStatus status{.firmware_major = 1,
                             .firmware_minor = 300,
                             .serial = 70000,
                             .counts_per_turn = 256,
                             .hardware = 1,
                             .state = SurfaceState::kTries,
                             .bytes_taken = 0x01020304,
                             .double_steps = 5,
                             .chip_id = {1, 2, 3, 4, 5, 6, 7, 8},
                             .stepping = ChipStepping::kB1};
  const auto bytes = Encode(status);
  EXPECT_EQ(bytes[2], 300 & 0xFF);
  EXPECT_EQ(bytes[27], 8);
  EXPECT_EQ(bytes[28], 2);
  EXPECT_EQ(Encode(DecodeSurfaceStatus(bytes)), bytes);
  EXPECT_EQ(DecodeSurfaceStatus(bytes).double_steps, 5u);
}

TEST(SurfaceWire, ACommandAndItsImageComeBackFromTheirBytes) {
  SurfaceImage image{.product = 0x12090001, .length = 40'000, .version = 0x10002};
  image.sha256.fill(0xA5);
  SurfaceCommand command{
      .operation = SurfaceOperation::kBegin, .number = 3, .length = kSurfaceImageBytes, .offset = 9};
  std::ranges::copy(Encode(image), command.data.begin());
  const auto back = DecodeSurfaceCommand(Encode(command));
  EXPECT_EQ(back.operation, SurfaceOperation::kBegin);
  EXPECT_EQ(back.number, 3);
  EXPECT_EQ(back.offset, 9u);
  EXPECT_EQ(DecodeSurfaceImage(std::span(back.data).first<kSurfaceImageBytes>()), image);
}

TEST(StickPodWire, ComesBackFromItsBytes) {
  const auto back = DecodeStickPod(Encode(StickPodReport{
      .x = -32767, .y = 32767, .twist = -1, .slider = 65535, .hat = 3, .buttons_down = 0xA01}));
  EXPECT_EQ(back.x, -32767);
  EXPECT_EQ(back.y, 32767);
  EXPECT_EQ(back.twist, -1);
  EXPECT_EQ(back.slider, 65535);
  EXPECT_EQ(back.hat, 3);
  EXPECT_EQ(back.buttons_down, 0xA01);
}

TEST(KeyboardWire, SaysSixKeysAndModifiersInBootProtocol) {
  KeyboardReport report;
  report.Hold(0xE1);
  report.Hold(0x04);
  report.Hold(0x1D);
  const auto boot = EncodeBoot(report);
  EXPECT_EQ(boot, (std::array<std::uint8_t, 8>{0x02, 0, 0x04, 0x1D, 0, 0, 0, 0}));
}

TEST(KeyboardWire, SaysRollOverInBootProtocolFromTheSeventhKey) {
  KeyboardReport report;
  for (std::uint8_t usage = 4; usage < 10; ++usage) report.Hold(usage);
  EXPECT_EQ(EncodeBoot(report)[7], 9);
  report.Hold(10);
  EXPECT_EQ(EncodeBoot(report)[2], kErrorRollOver);
  EXPECT_EQ(EncodeBoot(report)[7], kErrorRollOver);
}

TEST(KeyboardWire, CarriesEveryKeyAtOnce) {
  KeyboardReport report;
  for (unsigned usage = 4; usage < 0xE8; ++usage) report.Hold(static_cast<std::uint8_t>(usage));
  EXPECT_EQ(DecodeKeyboard(Encode(report)).down, report.down);
}

}  // namespace
}  // namespace kaori::wire
