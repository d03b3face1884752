// Simulated USB devices: their descriptors, a camera's stream, and a bridge with lines.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "firmware/wire/bytes.h"
#include "firmware/wire/keyboard.h"
#include "hw-sim/devices/gpio_bridge.h"
#include "hw-sim/devices/input_devices.h"
#include "hw-sim/devices/usb_descriptors.h"
#include "hw-sim/devices/usb_hid.h"
#include "hw-sim/devices/uvc_camera.h"
#include "hw-sim/devices/uvc_descriptors.h"

namespace kaori::sim {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;

constexpr Duration kPeriod = 33'333'300ns;

struct Desk {
  ManualClock clock;
  DeviceContext context{clock, {}};
  InputDevices devices{context, {64, 48, ports::PixelFormat::kYuyv}};
};

// Every descriptor in it is whole, and the header tells the length of all.
void ExpectWhole(const UsbBytes& configuration) {
  ASSERT_GE(configuration.size(), 9U);
  EXPECT_EQ(wire::GetU16(configuration, 2), configuration.size());
  std::size_t at = 0;
  while (at < configuration.size() && configuration[at] > 0) at += configuration[at];
  EXPECT_EQ(at, configuration.size());
}

TEST(UsbDevices, HaveWholeDescriptors) {
  Desk desk;
  ExpectWhole(UsbHid(desk.devices.dial_box).descriptors().configuration);
  ExpectWhole(UsbHid(desk.devices.left_stick).descriptors().configuration);
  ExpectWhole(UvcCamera(desk.devices.camera, kPeriod).descriptors().configuration);
  ExpectWhole(GpioBridge().descriptors().configuration);
}

TEST(UsbDevices, SayTheirNameInUtf16AndHaveNoSerialNumber) {
  Desk desk;
  const UsbHid stick(desk.devices.left_stick);
  const auto device = AnswerStandard(stick.descriptors(), {0x80, 6, 0x0100, 0, 18});
  ASSERT_TRUE(device);
  EXPECT_EQ(device->size(), 18U);
  EXPECT_EQ((*device)[16], 0) << "two equal pods are told apart by their ports alone";
  const auto maker = AnswerStandard(stick.descriptors(), {0x80, 6, 0x0301, 0x0409, 255});
  EXPECT_THAT(*maker, ElementsAre(12, 3, 'K', 0, 'a', 0, 'o', 0, 'r', 0, 'i', 0));
}

TEST(UsbDevices, TornConfigurationsAreReadAsFarAsTheyAreWhole) {
  Desk desk;
  UsbBytes configuration = UsbHid(desk.devices.dial_box).descriptors().configuration;
  configuration.resize(configuration.size() - 3);
  const UsbContents contents = ContentsOf(configuration);
  EXPECT_EQ(contents.interfaces.size(), 1U);
  EXPECT_EQ(contents.endpoints.size(), 1U);
}

TEST(UsbHid, HasAnEndpointOutOnlyForDevicesThatTakeReports) {
  Desk desk;
  EXPECT_EQ(ContentsOf(UsbHid(desk.devices.keyboard).descriptors().configuration).endpoints.size(), 2U);
  EXPECT_EQ(ContentsOf(UsbHid(desk.devices.pointer).descriptors().configuration).endpoints.size(), 1U);
}

TEST(UsbHid, SaysOfAKeyboardAloneThatItIsOne) {
  Desk desk;
  const auto protocol = [](HidDevice& device) {
    return ContentsOf(UsbHid(device).descriptors().configuration).interfaces.at(0).protocol;
  };
  EXPECT_EQ(protocol(desk.devices.keyboard), 1);
  EXPECT_EQ(protocol(desk.devices.dial_box), 0);
  EXPECT_EQ(protocol(desk.devices.pointer), 0);
}

TEST(UsbHid, GivesTheStandingReportWhenItIsAskedFor) {
  Desk desk;
  UsbHid keyboard(desk.devices.keyboard);
  desk.devices.keyboard.Press(0x04);
  const auto report = keyboard.Answer({0xA1, 0x01, 0x0100, 0, 64}, {});
  ASSERT_TRUE(report);
  EXPECT_EQ(report->size(), wire::kKeyboardReportBytes);
  EXPECT_NE(std::ranges::count(*report, 0), static_cast<std::ptrdiff_t>(report->size()));
}

// What a host makes of a stream: frames without headers, and whether every payload kept the rules.
struct Viewer {
  UvcCamera& camera;
  std::size_t room = 16384;
  UsbBytes frame{};
  std::vector<UsbBytes> frames{};
  std::vector<bool> parities{};
  std::size_t in_payload = 0;
  bool ends = false;

  void Watch(Time now) {
    while (const auto transfer = camera.NextIn(UvcCamera::kIn, room, now)) Collect(*transfer);
  }
  void Collect(std::span<const std::uint8_t> transfer) {
    auto data = transfer;
    if (in_payload == 0 && !data.empty()) {
      ASSERT_EQ(data[0], 2);
      if (frame.empty()) parities.push_back((data[1] & 1) != 0);
      ends = (data[1] & 2) != 0;
      data = data.subspan(2);
    }
    frame.insert(frame.end(), data.begin(), data.end());
    in_payload += transfer.size();
    if (transfer.size() == room && in_payload < UvcCamera::kPayloadBytes) return;
    in_payload = 0;
    if (ends) frames.push_back(std::exchange(frame, {}));
  }
};

TEST(UvcCamera, StreamsThePicturesThatTheCameraShoots) {
  Desk desk;
  UvcCamera camera(desk.devices.camera, kPeriod);
  Viewer viewer{camera};
  for (int n = 0; n < 3; ++n) {
    viewer.Watch(desk.clock.now());
    desk.clock.Advance(kPeriod);
  }
  ASSERT_EQ(viewer.frames.size(), 3U);
  UsbBytes expected(desk.devices.camera.frame_bytes());
  desk.devices.camera.Shoot(2, expected);
  EXPECT_EQ(viewer.frames[2], expected);
  EXPECT_NE(viewer.parities[0], viewer.parities[1]);
  EXPECT_NE(viewer.parities[1], viewer.parities[2]);
}

TEST(UvcCamera, CutsALargePictureIntoPayloads) {
  ManualClock clock;
  const DeviceContext context{clock, {}};
  LipCamera large({640, 480, ports::PixelFormat::kYuyv}, context);
  UvcCamera camera(large, kPeriod);
  Viewer viewer{camera};
  viewer.Watch(clock.now());
  ASSERT_EQ(viewer.frames.size(), 1U);
  EXPECT_EQ(viewer.frames[0].size(), 614400U);
}

TEST(UvcCamera, EndsAPayloadThatFillsItsLastTransferWithAnEmptyOne) {
  Desk desk;
  UvcCamera camera(desk.devices.camera, kPeriod);
  Viewer viewer{camera, desk.devices.camera.frame_bytes() + 2};
  viewer.Watch(desk.clock.now());
  ASSERT_EQ(viewer.frames.size(), 1U);
  EXPECT_EQ(viewer.frames[0].size(), desk.devices.camera.frame_bytes());
}

TEST(UvcCamera, DoesNotCatchUpWithWhatWasNotFetched) {
  Desk desk;
  UvcCamera camera(desk.devices.camera, kPeriod);
  Viewer viewer{camera};
  viewer.Watch(desk.clock.now());
  desk.clock.Advance(10 * kPeriod);
  viewer.Watch(desk.clock.now());
  EXPECT_EQ(viewer.frames.size(), 2U);
}

TEST(UvcCamera, StartsAnewWhenTheHostEndedTheStream) {
  Desk desk;
  UvcCamera camera(desk.devices.camera, kPeriod);
  ASSERT_TRUE(camera.NextIn(UvcCamera::kIn, 512, desk.clock.now()));
  ASSERT_TRUE(camera.Answer({0x02, 0x01, 0, UvcCamera::kIn, 0}, {}));
  Viewer viewer{camera};
  viewer.Watch(desk.clock.now());
  EXPECT_EQ(viewer.frames.size(), 1U) << "the half frame is forgotten";
}

TEST(UvcCamera, SendsNothingWhileItStalls) {
  Desk desk;
  UvcCamera camera(desk.devices.camera, kPeriod);
  desk.devices.camera.Stall(true);
  EXPECT_FALSE(camera.NextIn(UvcCamera::kIn, 512, desk.clock.now()));
  EXPECT_FALSE(camera.next_due(desk.clock.now()));
}

TEST(UvcCamera, OffersTheOneWayInWhichItStreams) {
  Desk desk;
  UvcCamera camera(desk.devices.camera, kPeriod);
  const auto probe = camera.Answer({0xA1, 0x81, 0x0100, 1, 34}, {});
  ASSERT_TRUE(probe);
  ASSERT_EQ(probe->size(), 34U);
  EXPECT_EQ(wire::GetU32(*probe, 4), 333333U);
  EXPECT_EQ(wire::GetU32(*probe, 18), 64U * 48 * 2);
  EXPECT_EQ(wire::GetU32(*probe, 22), UvcCamera::kPayloadBytes);
  EXPECT_FALSE(camera.Answer({0xA1, 0x81, 0x0300, 1, 34}, {})) << "no still pictures";
}

TEST(UvcDescriptors, AreThoseThatLinuxStreamedFrom) {
  const UsbBytes configuration = UvcConfiguration({320, 240, 333333, 16384, 0x81});
  ASSERT_EQ(configuration.size(), 158U);
  const UsbContents contents = ContentsOf(configuration);
  ASSERT_EQ(contents.interfaces.size(), 2U);
  ASSERT_EQ(contents.endpoints.size(), 1U);
  EXPECT_EQ(contents.endpoints[0].transfer, UsbTransfer::kBulk);
  EXPECT_EQ(contents.endpoints[0].interface, 1);
}

UsbBytes Ask(GpioBridge& bridge, std::uint8_t report) {
  return bridge.Answer({0xA1, 0x01, static_cast<std::uint16_t>(0x0300 | report), 0, 64}, {})
      .value_or(UsbBytes{});
}
void Tell(GpioBridge& bridge, const UsbBytes& report) {
  const auto setup = UsbSetup{0x21, 0x09, static_cast<std::uint16_t>(0x0300 | report[0]), 0, 0};
  EXPECT_TRUE(bridge.Answer(setup, report));
}

TEST(GpioBridge, ShowsAClosedSwitchAsALowLine) {
  GpioBridge bridge;
  EXPECT_THAT(Ask(bridge, 3), ElementsAre(3, 0xFF));
  bridge.Close(2);
  EXPECT_THAT(Ask(bridge, 3), ElementsAre(3, 0xFB));
  bridge.Open(2);
  EXPECT_THAT(Ask(bridge, 3), ElementsAre(3, 0xFF));
}

TEST(GpioBridge, DrivesTheLinesThatTheHostMadeOutputs) {
  GpioBridge bridge;
  Tell(bridge, {2, 0x10, 0x10, 0, 0});
  EXPECT_TRUE(bridge.drives(4));
  EXPECT_FALSE(bridge.drives(3));
  Tell(bridge, {4, 0x00, 0x10});
  EXPECT_FALSE(bridge.high(4));
  Tell(bridge, {4, 0xFF, 0x10});
  EXPECT_TRUE(bridge.high(4));
  EXPECT_TRUE(bridge.high(3));
}

TEST(GpioBridge, SetsNoLineThatTheMaskLeavesOut) {
  GpioBridge bridge;
  Tell(bridge, {2, 0x30, 0x30, 0, 0});
  Tell(bridge, {4, 0x00, 0x20});
  EXPECT_TRUE(bridge.high(4));
  EXPECT_FALSE(bridge.high(5));
}

TEST(GpioBridge, ForgetsItsOutputsWithItsPower) {
  GpioBridge bridge;
  Tell(bridge, {2, 0x10, 0x10, 0, 0});
  bridge.Close(0);
  bridge.PowerCycle();
  EXPECT_FALSE(bridge.drives(4));
  EXPECT_FALSE(bridge.high(0)) << "the switch stays where the foot left it";
}

TEST(GpioBridge, SaysWhatItIsAndStallsWhatItIsNot) {
  GpioBridge bridge;
  EXPECT_THAT(Ask(bridge, 5), ElementsAre(5, 0x0C, 0x02));
  EXPECT_EQ(Ask(bridge, 6).size(), 14U);
  EXPECT_FALSE(bridge.Answer({0xA1, 0x01, 0x0310, 0, 64}, {}));
  EXPECT_FALSE(bridge.Answer({0x21, 0x09, 0x0304, 0, 1}, UsbBytes{4}));
}

TEST(GpioBridge, HasTheReportDescriptorOfThePart) {
  GpioBridge bridge;
  const auto descriptor = bridge.Answer({0x81, 0x06, 0x2200, 0, 512}, {});
  ASSERT_TRUE(descriptor);
  EXPECT_EQ(descriptor->size(), 233U);
  EXPECT_TRUE(ShapeOf(*descriptor).numbers_reports);
}

}  // namespace
}  // namespace kaori::sim
