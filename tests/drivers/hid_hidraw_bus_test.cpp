// The hidraw bus against a made-up kernel: sysfs, udev events and nodes that answer ioctls.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <chrono>
#include <thread>

#include "drivers/decode/dial_box.h"
#include "drivers/hid/hidraw_bus.h"
#include "firmware/wire/dial_box.h"
#include "firmware/wire/stick_pod.h"
#include "tests/drivers/hid_mock_device.h"
#include "tests/drivers/service_manager.h"

namespace kaori::hid {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::uint8_t> BoxDescriptor() {
  return {wire::kDialBoxDescriptor.begin(), wire::kDialBoxDescriptor.end()};
}

class HidrawBusTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!tests::InMockKernel()) GTEST_SKIP() << "the library umockdev-preload could not be loaded";
    kernel_ = std::make_unique<tests::MockKernel>();
    bus_ = HidrawBus::Open(clock_).value();
  }
  bool has_notice() const {
    pollfd state{.fd = bus_->pollable(), .events = POLLIN, .revents = 0};
    return ::poll(&state, 1, 1000) > 0;  // The made-up netlink socket needs its thread's turn.
  }

  ManualClock clock_;
  tests::MockHidraw box_{BoxDescriptor()};
  tests::MockHidraw other_{BoxDescriptor()};
  std::unique_ptr<tests::MockKernel> kernel_;
  std::unique_ptr<HidrawBus> bus_;
};

TEST_F(HidrawBusTest, NamesDevicesByTheirUsbPort) {
  EXPECT_THAT(*bus_->Ports(), IsEmpty());
  kernel_->Plug("1-4.2", 0, "hidraw0", box_);
  kernel_->Plug("1-3", 0, "hidraw1", other_);
  EXPECT_TRUE(has_notice());
  EXPECT_THAT(*bus_->Ports(), ElementsAre("1-3", "1-4.2"));
}

TEST_F(HidrawBusTest, KeepsTheInterfacesOfOneDeviceApart) {
  kernel_->Plug("1-4.2", 0, "hidraw0", box_);
  kernel_->Plug("1-4.2", 1, "hidraw1", other_);
  EXPECT_THAT(*bus_->Ports(), ElementsAre("1-4.2", "1-4.2:1.1"));
}

TEST_F(HidrawBusTest, KeepsTheDevicesOfOneReceiverApart) {
  kernel_->Pair("dc:0c:2d:00:00:01", "hidraw0");
  kernel_->Pair("dc:0c:2d:00:00:02", "hidraw1");
  EXPECT_THAT(*bus_->Ports(),
              ElementsAre("00:1a:7d:da:71:13/dc:0c:2d:00:00:01", "00:1a:7d:da:71:13/dc:0c:2d:00:00:02"));
}

TEST_F(HidrawBusTest, SeesAPullAndAReplug) {
  kernel_->Plug("1-4.2", 0, "hidraw0", box_);
  ASSERT_TRUE(has_notice());
  EXPECT_THAT(*bus_->Ports(), ElementsAre("1-4.2"));
  kernel_->Unplug("1-4.2", 0, "hidraw0");
  ASSERT_TRUE(has_notice());
  EXPECT_THAT(*bus_->Ports(), IsEmpty());
  EXPECT_EQ(bus_->Open("1-4.2").error().cause, std::errc::no_such_device);
  kernel_->Plug("1-4.2", 0, "hidraw1", box_);  // The testbed keeps a node's name.
  ASSERT_TRUE(has_notice());
  EXPECT_THAT(*bus_->Ports(), ElementsAre("1-4.2"));
}

TEST_F(HidrawBusTest, ListsDevicesWithoutBeingTakenForAHang) {
  tests::WatchingManager manager;
  ASSERT_TRUE(bus_->Ports());
  EXPECT_THAT(manager.Beat(), ElementsAre(tests::kPatience));
  ASSERT_TRUE(bus_->Ports());
  EXPECT_THAT(manager.Beat(), IsEmpty()) << "nothing came or went, so nothing is listed";
}

TEST_F(HidrawBusTest, OpensADeviceThatIsReadAndWritten) {
  kernel_->Plug("1-4.2", 0, "hidraw0", box_);
  ASSERT_TRUE(bus_->Ports());
  const auto channel = bus_->Open("1-4.2");
  ASSERT_TRUE(channel) << channel.error().message();
  const ports::HidIdentity& identity = (*channel)->identity();
  EXPECT_EQ(identity.port, "1-4.2");
  EXPECT_EQ(identity.vendor, 0x1209);
  EXPECT_EQ(identity.product, 0x0001);
  EXPECT_EQ(identity.name, "Dial Box");
  EXPECT_EQ(identity.descriptor, BoxDescriptor());

  std::array<std::uint8_t, 64> into{};
  EXPECT_EQ((*channel)->Read(into).error().cause, std::errc::resource_unavailable_try_again);
  const auto report = wire::Encode(wire::DialBoxReport{.turned = {-3}});
  box_.Send({report.begin(), report.end()});
  const auto input = (*channel)->Read(into);
  ASSERT_TRUE(input) << input.error().message();
  auto decoder = decode::DialBoxDecoder::For(identity).value();
  EXPECT_EQ(decoder.Decode(std::span(into).first(input->bytes), input->at)->counts[0], -3);
  ASSERT_TRUE((*channel)->Write(decoder.LampReport(0x81)));
  // A thread of the channel writes, so that a device that does not answer keeps nobody waiting.
  for (int n = 0; n < 500 && box_.received().empty(); ++n)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_THAT(box_.received(), ElementsAre(0, 0x81, 0, 0, 0));
}

std::vector<std::uint8_t> StickDescriptor() {
  return {wire::kStickPodDescriptor.begin(), wire::kStickPodDescriptor.end()};
}

// As the kernel gives it: a report without a number begins with a 0.
std::vector<std::uint8_t> Held(const wire::StickPodReport& report) {
  const auto bytes = wire::Encode(report);
  std::vector<std::uint8_t> answer(bytes.begin(), bytes.end());
  answer.insert(answer.begin(), 0);
  return answer;
}

class HeldStick : public HidrawBusTest {
 protected:
  std::unique_ptr<ports::HidChannel> Plug() {
    const std::string port = "1-" + std::to_string(++plugs_);
    kernel_->Plug(port, 0, "hidraw" + std::to_string(plugs_), stick_);
    EXPECT_TRUE(has_notice());
    EXPECT_TRUE(bus_->Ports());
    return std::move(bus_->Open(port).value());
  }
  std::errc Cause(ports::HidChannel& channel) { return channel.Read(into_).error().cause; }

  tests::MockHidraw stick_{StickDescriptor()};
  int plugs_ = 0;
  std::array<std::uint8_t, 64> into_{};
};

TEST_F(HeldStick, HasItsPositionAtOnceAndItsReportsComeAfterwards) {
  const auto held = Held({.x = 1200, .y = -700});
  stick_.SetInitialReport(held);
  stick_.Send({1, 2, 3});
  const auto channel = Plug();
  pollfd state{.fd = channel->pollable(), .events = POLLIN, .revents = 0};
  EXPECT_EQ(::poll(&state, 1, 0), 1) << "the made-up node never is: it is the position that waits";
  ASSERT_EQ(channel->Read(into_)->bytes, held.size() - 1);
  EXPECT_TRUE(std::equal(held.begin() + 1, held.end(), into_.begin()));
  EXPECT_EQ(::poll(&state, 1, 0), 0) << "it was read";
  EXPECT_EQ(channel->Read(into_)->bytes, 3U);
  EXPECT_EQ(Cause(*channel), std::errc::resource_unavailable_try_again);
}

TEST_F(HeldStick, ThatStallsOrAnswersNonsenseHasNoInitialReport) {
  const auto whole = Held({.x = 5});
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{1}, whole.size() - 1}) {
    stick_.SetInitialReport({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(bytes)});
    const auto channel = Plug();
    EXPECT_EQ(Cause(*channel), std::errc::resource_unavailable_try_again) << bytes;
  }
  stick_.SetInitialReport(std::vector<std::uint8_t>(whole.size()));
  EXPECT_EQ(Cause(*Plug()), std::errc::resource_unavailable_try_again) << "zeros";
}

TEST_F(HeldStick, ThatDoesNotAnswerIsNeverAskedAgain) {
  stick_.SetInitialReport({}, ETIMEDOUT);
  for (int plugs = 0; plugs < 3; ++plugs) EXPECT_TRUE(Plug());
  EXPECT_EQ(stick_.requests(), 1);
}

TEST_F(HidrawBusTest, ABoxOfEndlessDialsIsNotAsked) {
  box_.SetInitialReport(std::vector<std::uint8_t>(21, 1));
  kernel_->Plug("1-4", 0, "hidraw0", box_);
  ASSERT_TRUE(bus_->Ports());
  ASSERT_TRUE(bus_->Open("1-4"));
  EXPECT_EQ(box_.requests(), 0);
}

}  // namespace
}  // namespace kaori::hid
