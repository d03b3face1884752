// The contract of ports::Scanout. That no call blocks shows in that the tests end.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <variant>

#include "drivers/base/clock.h"
#include "drivers/ports/scanout.h"
#include "tests/contracts/contract.h"

namespace kaori::contracts {

// A screen of 640 x 480 that is plugged in and has answered, and its vertical blank.
class ScanoutSubject : public AnySubject {
 public:
  virtual ports::Scanout& screen() = 0;
  // Time goes on to the next vertical blank.
  virtual void Blank() = 0;
  virtual void Unplug() = 0;
  virtual void PlugInAgain() = 0;
  // False where the device behind the implementation has no descriptor that becomes readable.
  virtual bool wakes() const { return true; }

  ManualClock clock;
};

class ScanoutContract : public Contract<ScanoutSubject> {
 protected:
  ports::Scanout& screen() { return subject_->screen(); }
  Result<ports::Flip> Frame(std::uint64_t number) {
    if (auto buffer = screen().Acquire(); !buffer) return tl::unexpected(buffer.error());
    if (auto presented = screen().Present(number); !presented) return tl::unexpected(presented.error());
    subject_->Blank();
    return screen().ReadFlip();
  }
};

TEST_P(ScanoutContract, LendsABufferOfItsSizeUntilPresent) {
  const auto buffer = screen().Acquire();
  ASSERT_TRUE(buffer) << buffer.error().message();
  EXPECT_EQ(buffer->width_px, 640);
  EXPECT_EQ(buffer->height_px, 480);
  if (std::holds_alternative<ports::PixelMemory>(buffer->target)) {
    EXPECT_EQ(buffer->memory().size(), std::size_t{640} * 480 * 4);
  }
  const auto again = screen().Acquire();
  ASSERT_TRUE(again) << "a second time before Present";
  EXPECT_EQ(again->memory().data(), buffer->memory().data());
}

TEST_P(ScanoutContract, APresentWithoutABufferIsRefused) {
  EXPECT_EQ(Cause(screen().Present(1)), std::errc::invalid_argument);
  ASSERT_TRUE(Frame(1));
  EXPECT_EQ(Cause(screen().Present(2)), std::errc::invalid_argument);
}

TEST_P(ScanoutContract, AFrameIsPresentedAtTheVerticalBlankAndToldOnce) {
  for (std::uint64_t number = 7; number < 12; ++number) {
    ASSERT_TRUE(screen().Acquire());
    ASSERT_TRUE(screen().Present(number));
    EXPECT_EQ(Cause(screen().ReadFlip()), std::errc::resource_unavailable_try_again);
    EXPECT_EQ(Cause(screen().Acquire()), std::errc::resource_unavailable_try_again);
    const Time presented = subject_->clock.now();
    subject_->Blank();
    const auto flip = screen().ReadFlip();
    ASSERT_TRUE(flip) << flip.error().message();
    EXPECT_EQ(flip->frame, number);
    EXPECT_GT(flip->at, presented);
    EXPECT_LE(flip->at, subject_->clock.now());
    EXPECT_NEAR(Seconds(flip->period), 1.0 / 60, 1e-3);
    EXPECT_EQ(Cause(screen().ReadFlip()), std::errc::resource_unavailable_try_again);
  }
}

TEST_P(ScanoutContract, IsReadableWhenThereIsAFlip) {
  if (!subject_->wakes()) GTEST_SKIP() << "the fake device has no descriptor that becomes readable";
  ASSERT_TRUE(screen().Acquire());
  ASSERT_TRUE(screen().Present(1));
  EXPECT_FALSE(IsReadable(screen().pollable()));
  subject_->Blank();
  EXPECT_TRUE(IsReadable(screen().pollable(), kLongestWait_ms));
}

TEST_P(ScanoutContract, SaysNoSuchDeviceEverAfterItWasUnpluggedAlsoOnceItIsBack) {
  ASSERT_TRUE(Frame(1));
  subject_->Unplug();
  Result<ports::Flip> gone = Frame(2);
  for (int n = 0; n < 100 && (gone || gone.error().cause != std::errc::no_such_device); ++n) {
    subject_->clock.Advance(std::chrono::milliseconds(50));
    gone = Frame(2);
  }
  ASSERT_EQ(Cause(gone), std::errc::no_such_device);
  for (const bool back : {false, true}) {
    if (back) subject_->PlugInAgain();
    subject_->clock.Advance(std::chrono::seconds(1));
    EXPECT_EQ(Cause(screen().Acquire()), std::errc::no_such_device) << back;
    EXPECT_EQ(Cause(screen().ReadFlip()), std::errc::no_such_device) << back;
  }
}

TEST_P(ScanoutContract, ItsOutputsHaveNamesWithoutSpacesAndTheirModes) {
  ASSERT_TRUE(Frame(1));
  for (const ports::Output& output : screen().outputs()) {
    EXPECT_EQ(output.connector.find_first_of(" \t\n"), output.connector.npos) << output.connector;
    EXPECT_FALSE(output.connector.empty());
    EXPECT_GT(output.width_px, 0);
    EXPECT_GT(output.height_px, 0);
    EXPECT_GT(output.rate_hz, 0);
  }
}

}  // namespace kaori::contracts
