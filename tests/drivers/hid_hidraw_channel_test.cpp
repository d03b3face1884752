// A seqpacket socket stands in for a hidraw node: packets in, packets out, and a hang-up.
#include <gtest/gtest.h>

#include <poll.h>
#include <sys/socket.h>

#include "drivers/hid/hidraw_channel.h"

namespace kaori::hid {
namespace {

using Bytes = std::vector<std::uint8_t>;

class HidrawChannelTest : public ::testing::Test {
 protected:
  HidrawChannelTest() {
    std::array<int, 2> ends{};
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, ends.data()), 0);
    device_ = UniqueFd(ends[0]);
    channel_ = std::make_unique<HidrawChannel>(
        UniqueFd(ends[1]), ports::HidIdentity{.port = "1-4.2", .name = "box", .descriptor = {}}, clock_);
  }
  void Send(const Bytes& report) {
    ASSERT_EQ(::send(device_.get(), report.data(), report.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(report.size()));
  }
  bool readable() const {
    pollfd state{.fd = channel_->pollable(), .events = POLLIN, .revents = 0};
    return ::poll(&state, 1, 0) > 0;
  }

  ManualClock clock_;
  UniqueFd device_;
  std::unique_ptr<HidrawChannel> channel_;
  std::array<std::uint8_t, 64> into_{};
};

TEST_F(HidrawChannelTest, ReadsOneReportAtATimeWithTheTimeOfItsArrival) {
  EXPECT_EQ(channel_->Read(into_).error().cause, std::errc::resource_unavailable_try_again);
  Send({1, 2, 3});
  Send({4});
  clock_.Advance(std::chrono::milliseconds(7));
  EXPECT_TRUE(readable());
  const auto first = channel_->Read(into_);
  ASSERT_TRUE(first) << first.error().message();
  EXPECT_EQ(first->bytes, 3u);
  EXPECT_EQ(first->at, clock_.now());
  EXPECT_EQ(into_[2], 3);
  EXPECT_EQ(channel_->Read(into_)->bytes, 1u);
  EXPECT_FALSE(readable());
}

TEST_F(HidrawChannelTest, WritesWholeReports) {
  ASSERT_TRUE(channel_->Write(Bytes{0, 0xA5, 1, 2, 3}));
  EXPECT_EQ(::recv(device_.get(), into_.data(), into_.size(), 0), 5);
  EXPECT_EQ(into_[1], 0xA5);
  EXPECT_EQ(channel_->Write({}).error().cause, std::errc::invalid_argument);
}

TEST_F(HidrawChannelTest, GivesWhatWasSentBeforeThePullAndThenSaysGoneForEver) {
  Send({9});
  device_.reset();
  EXPECT_TRUE(readable());
  EXPECT_TRUE(channel_->Read(into_));
  for (int n = 0; n < 3; ++n) {
    EXPECT_EQ(channel_->Read(into_).error().cause, std::errc::no_such_device);
    EXPECT_EQ(channel_->Write(Bytes{0, 1}).error().cause, std::errc::no_such_device);
  }
  EXPECT_EQ(channel_->Read(into_).error().message(), "use 1-4.2: No such device");
}

TEST(HidrawChannel, CallsAFailedTransferAnIoErrorWhileTheDeviceIsThere) {
  SteadyClock clock;
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const UniqueFd writer(ends[1]);
  // The reading end of a pipe refuses a write with EBADF: an error that is no hang-up.
  HidrawChannel channel(UniqueFd{ends[0]}, {.port = "1-1", .name = "", .descriptor = {}}, clock);
  EXPECT_EQ(channel.Write(Bytes{0, 1}).error().cause, std::errc::io_error);
  EXPECT_EQ(channel.Write(Bytes{0, 1}).error().cause, std::errc::io_error);
}

}  // namespace
}  // namespace kaori::hid
