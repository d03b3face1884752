// What the contract of HidChannel leaves to hidraw.
#include <gtest/gtest.h>

#include <unistd.h>

#include "drivers/hid/hidraw_channel.h"

namespace kaori::hid {
namespace {

using Bytes = std::vector<std::uint8_t>;

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
