// The contract of ports::BlockDevice.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "drivers/ports/block_device.h"
#include "tests/contracts/contract.h"

namespace kaori::contracts {

// A device of 64 KiB, full of zeros.
class BlockDeviceSubject : public AnySubject {
 public:
  static constexpr std::uint64_t kBytes = std::uint64_t{64} << 10U;
  virtual ports::BlockDevice& device() = 0;
};

class BlockDeviceContract : public Contract<BlockDeviceSubject> {
 protected:
  using Bytes = std::vector<std::uint8_t>;
  ports::BlockDevice& device() { return subject_->device(); }
  Bytes Read(std::uint64_t at, std::size_t length) {
    Bytes read(length);
    EXPECT_TRUE(device().Read(at, read));
    return read;
  }
};

TEST_P(BlockDeviceContract, GivesWhatWasWrittenBeforeAndAfterAFlush) {
  EXPECT_EQ(device().bytes(), BlockDeviceSubject::kBytes);
  const Bytes written(1000, 7);
  ASSERT_TRUE(device().Write(3000, written));
  EXPECT_EQ(Read(3000, 1000), written);
  ASSERT_TRUE(device().Flush());
  EXPECT_EQ(Read(3000, 1000), written);
}

TEST_P(BlockDeviceContract, ChangesNothingButWhatItWasToldToWrite) {
  ASSERT_TRUE(device().Write(512, Bytes(512, 9)));
  ASSERT_TRUE(device().Flush());
  EXPECT_EQ(Read(0, 512), Bytes(512, 0));
  EXPECT_EQ(Read(1024, 4096), Bytes(4096, 0));
}

TEST_P(BlockDeviceContract, RefusesToReachBehindItsEndAndWritesNothingThen) {
  constexpr std::uint64_t kEnd = BlockDeviceSubject::kBytes;
  Bytes some(2, 1);
  EXPECT_EQ(Cause(device().Write(kEnd - 1, some)), std::errc::invalid_argument);
  EXPECT_EQ(Cause(device().Read(kEnd - 1, some)), std::errc::invalid_argument);
  EXPECT_EQ(Cause(device().Write(UINT64_MAX, some)), std::errc::invalid_argument);
  EXPECT_EQ(Read(kEnd - 1, 1), Bytes(1, 0));
  EXPECT_TRUE(device().Write(kEnd - 2, some));
}

}  // namespace kaori::contracts
