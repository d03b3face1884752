// What the contract of HidChannel leaves to hidraw.
#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include "drivers/hid/hidraw_channel.h"

namespace kaori::hid {
namespace {

using Bytes = std::vector<std::uint8_t>;

// Writes until the fault of a report before is told.
std::errc NextFailure(HidrawChannel& channel) {
  for (int n = 0; n < 3000; ++n) {
    const auto written = channel.Write(Bytes{0, 1});
    if (!written && written.error().cause != std::errc::resource_unavailable_try_again)
      return written.error().cause;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return {};
}

TEST(HidrawChannel, CallsAFailedTransferAnIoErrorWhileTheDeviceIsThere) {
  SteadyClock clock;
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const UniqueFd writer(ends[1]);
  // The reading end of a pipe refuses a write with EBADF: an error that is no hang-up.
  HidrawChannel channel(UniqueFd{ends[0]}, {.port = "1-1", .name = "", .descriptor = {}}, clock);
  EXPECT_EQ(NextFailure(channel), std::errc::io_error);
  EXPECT_EQ(NextFailure(channel), std::errc::io_error);
}

// A socket whose peer reads no more refuses a write with EPIPE, as the kernel does for a device that stalls.
TEST(HidrawChannel, ARefusedReportIsNoPulledCable) {
  std::signal(SIGPIPE, SIG_IGN);  // Of the socket's own; a device has none.
  SteadyClock clock;
  std::array<int, 2> ends{};
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, ends.data()), 0);
  UniqueFd peer(ends[1]);
  HidrawChannel channel(UniqueFd{ends[0]}, {.port = "1-1", .name = "", .descriptor = {}}, clock);
  ASSERT_EQ(::shutdown(peer.get(), SHUT_RD), 0);
  EXPECT_EQ(NextFailure(channel), std::errc::io_error);
  ASSERT_EQ(::write(peer.get(), Bytes{7}.data(), 1), 1);
  Bytes report(8);
  const auto read = channel.Read(report);
  ASSERT_TRUE(read) << "what it sends is still heard";
  EXPECT_EQ(read->bytes, 1U);
  EXPECT_EQ(NextFailure(channel), std::errc::io_error);
  peer.reset();
  EXPECT_EQ(NextFailure(channel), std::errc::no_such_device);
}

// A full pipe in place of a device that takes nothing.
TEST(HidrawChannel, ADeviceThatDoesNotAnswerKeepsNobodyWaiting) {
  std::signal(SIGPIPE, SIG_IGN);  // Of the pipe's own; a device has none.
  SteadyClock clock;
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  UniqueFd reader(ends[0]);
  ASSERT_GT(::fcntl(ends[1], F_SETPIPE_SZ, 4096), 0);
  ASSERT_EQ(::write(ends[1], Bytes(4096).data(), 4096), 4096);
  HidrawChannel channel(UniqueFd{ends[1]}, {.port = "1-1", .name = "", .descriptor = {}}, clock);
  const Time began = clock.now();
  EXPECT_TRUE(channel.Write(Bytes{0, 1}));
  for (int n = 0; n < 100; ++n)
    EXPECT_EQ(channel.Write(Bytes{0, 2}).error().cause, std::errc::resource_unavailable_try_again);
  EXPECT_LT(clock.now() - began, std::chrono::seconds(2));
  reader.reset();  // It was pulled: the report under way ends.
  EXPECT_EQ(channel.Write(Bytes{0, 3}).error().cause, std::errc::no_such_device);
}

}  // namespace
}  // namespace kaori::hid
