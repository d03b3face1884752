// The libusb bus and channel against a made-up kernel's usbfs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "drivers/decode/dial_box.h"
#include "drivers/hid/libusb_bus.h"
#include "drivers/hid/libusb_channel.h"
#include "firmware/wire/dial_box.h"
#include "tests/drivers/hid_mock_usb.h"

namespace kaori::hid {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Bytes = std::vector<std::uint8_t>;

class LibusbTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!tests::InMockKernel()) GTEST_SKIP() << "the library umockdev-preload could not be loaded";
    kernel_ = std::make_unique<tests::MockKernel>();
    bus_ = LibusbBus::Open(clock_).value();
  }
  std::unique_ptr<ports::HidChannel> Opened(bool has_out_endpoint = true) {
    box_ = std::make_unique<tests::MockUsb>(tests::MockUsb::Options{
        {wire::kDialBoxDescriptor.begin(), wire::kDialBoxDescriptor.end()}, has_out_endpoint, "Dial Box"});
    box_->Plug(*kernel_);
    auto channel = bus_->Open("1-4");
    EXPECT_TRUE(channel) << channel.error().message();
    return channel ? std::move(*channel) : nullptr;
  }
  // The device's notices go through another thread of libusb: asks until they have come.
  std::vector<std::string> PortsWith(std::size_t count) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(2);
    std::vector<std::string> ports = bus_->Ports().value();
    while (ports.size() != count && std::chrono::steady_clock::now() < end) ports = bus_->Ports().value();
    return ports;
  }

  ManualClock clock_;
  std::unique_ptr<tests::MockKernel> kernel_;
  std::unique_ptr<tests::MockUsb> box_;
  std::unique_ptr<LibusbBus> bus_;
  std::array<std::uint8_t, 64> into_{};
};

TEST_F(LibusbTest, SeesAPlugAndAPull) {
  EXPECT_THAT(*bus_->Ports(), IsEmpty());
  EXPECT_EQ(bus_->Open("1-4").error().cause, std::errc::no_such_device);
  Opened().reset();
  EXPECT_THAT(PortsWith(1), ElementsAre("1-4"));
  box_->Unplug(*kernel_);
  EXPECT_THAT(PortsWith(0), IsEmpty());
}

TEST_F(LibusbTest, ReadsReportsInTheirOrder) {
  const auto channel = Opened();
  ASSERT_NE(channel, nullptr);
  EXPECT_EQ(channel->identity().vendor, 0x1209);
  EXPECT_EQ(channel->identity().port, "1-4");
  EXPECT_EQ(channel->identity().name, "Dial Box");
  auto decoder = decode::DialBoxDecoder::For(channel->identity()).value();
  EXPECT_EQ(channel->Read(into_).error().cause, std::errc::resource_unavailable_try_again);
  for (int n = 1; n <= 100; ++n) {
    const auto report = wire::Encode(wire::DialBoxReport{.turned = {1, static_cast<std::int16_t>(n)}});
    ASSERT_TRUE(box_->Send({report.begin(), report.end()})) << n;
    if (n % 5 != 0) continue;  // Up to five wait together.
    while (const auto input = channel->Read(into_))
      ASSERT_TRUE(decoder.Decode(std::span(into_).first(input->bytes), input->at));
  }
  EXPECT_EQ(decoder.sample().counts[0], 100);
  EXPECT_EQ(decoder.sample().counts[1], 5050);
}

TEST_F(LibusbTest, LeavesReportsWithTheDeviceWhenNobodyReads) {
  const auto channel = Opened();
  ASSERT_NE(channel, nullptr);
  std::size_t sent = 0;
  while (box_->Send(Bytes(20, 1))) ++sent;
  EXPECT_EQ(sent, LibusbChannel::kReads);
  std::size_t read = 0;
  while (channel->Read(into_)) ++read;
  EXPECT_EQ(read, sent);
  EXPECT_EQ(box_->waiting(), LibusbChannel::kReads);
}

TEST_F(LibusbTest, SwitchesLampsByTheOutEndpoint) {
  const auto channel = Opened();
  ASSERT_NE(channel, nullptr);
  ASSERT_TRUE(channel->Write(Bytes{0, 0x81, 0, 0, 0x40}));
  EXPECT_THAT(box_->received(), ElementsAre(0x81, 0, 0, 0x40));
  EXPECT_EQ(channel->Write({}).error().cause, std::errc::invalid_argument);
}

TEST_F(LibusbTest, SwitchesLampsBySetReportWithoutAnOutEndpoint) {
  const auto channel = Opened(false);
  ASSERT_NE(channel, nullptr);
  ASSERT_TRUE(channel->Write(Bytes{0, 0x81, 0, 0, 0x40}));
  EXPECT_THAT(box_->received(), ElementsAre(0x21, 0x09, 0x00, 0x02, 0, 0, 4, 0, 0x81, 0, 0, 0x40));
}

}  // namespace
}  // namespace kaori::hid
