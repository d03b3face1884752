// The contract of ports::HidChannel. That no call blocks shows in that the tests end.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <span>
#include <thread>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/ports/hid_channel.h"
#include "tests/contracts/contract.h"

namespace kaori::contracts {

// A channel, and the device behind it: a dial box on some port.
class HidSubject : public AnySubject {
 public:
  using Bytes = std::vector<std::uint8_t>;

  virtual ports::HidChannel& channel() = 0;
  // The device sends an input report, and is unplugged.
  virtual void Send(const Bytes& report) = 0;
  virtual void Unplug() = 0;
  // False where the device behind the implementation has no descriptor that becomes readable.
  virtual bool wakes() const { return true; }
  // The output report that the device received last, without the report id; awaited, where it is on its way.
  virtual Bytes received() = 0;

  ManualClock clock;
};

class HidChannelContract : public Contract<HidSubject> {
 protected:
  using Bytes = HidSubject::Bytes;
  ports::HidChannel& channel() { return subject_->channel(); }

  // The next report, awaited as a program does.
  Result<ports::HidInput> Read() { return Read(into_); }
  Result<ports::HidInput> Read(std::span<std::uint8_t> into) {
    AwaitNews();
    auto input = channel().Read(into);
    for (int n = 0; n < 1000 && Cause(input) == std::errc::resource_unavailable_try_again; ++n) {
      std::this_thread::sleep_for(
          std::chrono::milliseconds(1));  // A fake device answers in a thread of its own.
      input = channel().Read(into);
    }
    return input;
  }
  void AwaitNews() {
    if (subject_->wakes()) {
      EXPECT_TRUE(IsReadable(channel().pollable(), kLongestWait_ms));
    }
  }

  std::array<std::uint8_t, 64> into_{};
};

TEST_P(HidChannelContract, KnowsWhoItIsFromTheStart) {
  EXPECT_FALSE(channel().identity().port.empty());
  EXPECT_FALSE(channel().identity().descriptor.empty());
}

TEST_P(HidChannelContract, SaysTryAgainWhileThereIsNoReport) {
  EXPECT_EQ(Cause(channel().Read(into_)), std::errc::resource_unavailable_try_again);
  if (subject_->wakes()) {
    EXPECT_FALSE(IsReadable(channel().pollable()));
  }
}

TEST_P(HidChannelContract, GivesReportsWholeInTheirOrderAndStamped) {
  subject_->clock.Advance(std::chrono::milliseconds(7));
  subject_->Send({1, 2, 3});
  subject_->Send({4});
  const auto first = Read();
  ASSERT_TRUE(first) << first.error().message();
  EXPECT_EQ(Bytes(into_.begin(), into_.begin() + 3), (Bytes{1, 2, 3}));
  EXPECT_EQ(first->bytes, 3U);
  EXPECT_EQ(first->at, subject_->clock.now());
  const auto second = Read();
  ASSERT_TRUE(second) << second.error().message();
  EXPECT_EQ(second->bytes, 1U);
  EXPECT_EQ(into_[0], 4);
  EXPECT_EQ(Cause(channel().Read(into_)), std::errc::resource_unavailable_try_again);
}

TEST_P(HidChannelContract, CutsOffWhatDoesNotFit) {
  subject_->Send({1, 2, 3, 4});
  subject_->Send({5});
  const auto input = Read(std::span(into_).first(2));
  ASSERT_TRUE(input) << input.error().message();
  EXPECT_EQ(input->bytes, 2U);
  EXPECT_EQ(Bytes(into_.begin(), into_.begin() + 3), (Bytes{1, 2, 0}));
  ASSERT_TRUE(Read());
  EXPECT_EQ(into_[0], 5) << "and the rest of it is no report";
}

TEST_P(HidChannelContract, SendsAWholeReport) {
  const Bytes report{0, 0x81, 2, 3, 0x40};
  const auto sent = channel().Write(report);
  ASSERT_TRUE(sent) << sent.error().message();
  EXPECT_EQ(subject_->received(), (Bytes{0x81, 2, 3, 0x40}));
}

TEST_P(HidChannelContract, SendsReportsInTheirOrderAndSaysTryAgainWhileTooManyAreUnderWay) {
  for (std::uint8_t n = 1; n < 20; ++n) {
    auto sent = channel().Write(Bytes{0, n});
    for (int tries = 0; tries < 1000 && Cause(sent) == std::errc::resource_unavailable_try_again; ++tries) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      static_cast<void>(channel().Read(into_));  // As a program does meanwhile.
      sent = channel().Write(Bytes{0, n});
    }
    ASSERT_TRUE(sent) << sent.error().message();
    EXPECT_EQ(subject_->received(), (Bytes{n}));
  }
}

TEST_P(HidChannelContract, RefusesAnEmptyReport) {
  EXPECT_EQ(Cause(channel().Write({})), std::errc::invalid_argument);
}

TEST_P(HidChannelContract, GivesWhatArrivedBeforeItWasUnpluggedAndThenSaysNoSuchDeviceEverAfter) {
  subject_->Send({9});
  AwaitNews();
  subject_->Unplug();
  ASSERT_TRUE(Read());
  EXPECT_EQ(into_[0], 9);
  AwaitNews();
  for (int n = 0; n < 3; ++n) EXPECT_EQ(Cause(channel().Read(into_)), std::errc::no_such_device);
  EXPECT_EQ(Cause(channel().Write(Bytes{0, 1})), std::errc::no_such_device);
  EXPECT_EQ(Cause(channel().Read(into_)), std::errc::no_such_device);
  EXPECT_FALSE(channel().identity().port.empty()) << "who it was is still known";
}

}  // namespace kaori::contracts
