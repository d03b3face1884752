// The contract of ports::Camera. That no call blocks shows in that the tests end.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>

#include "drivers/base/clock.h"
#include "drivers/ports/camera.h"
#include "tests/contracts/contract.h"

namespace kaori::contracts {

// A camera that streams YUYV, and what is before its lens.
class CameraSubject : public AnySubject {
 public:
  virtual ports::Camera& camera() = 0;
  // A frame is exposed whose bytes all are `grey`, read out at `at`. False: the camera had no free buffer.
  virtual bool Expose(std::uint8_t grey, Time at) = 0;
  // A frame arrives damaged.
  virtual void ExposeTorn() = 0;
  virtual void Unplug() = 0;
  // False where the device behind the implementation has no descriptor that becomes readable.
  virtual bool wakes() const { return true; }
  // False where the implementation does not tell a stall: the device's owner does.
  virtual bool tells_stalls() const { return true; }

  ManualClock clock;
};

class CameraContract : public Contract<CameraSubject> {
 protected:
  ports::Camera& camera() { return subject_->camera(); }
  Time now() const { return subject_->clock.now(); }
};

TEST_P(CameraContract, SaysTryAgainWhileThereIsNoFrame) {
  EXPECT_EQ(Cause(camera().Next()), std::errc::resource_unavailable_try_again);
  EXPECT_FALSE(IsReadable(camera().pollable()));
}

TEST_P(CameraContract, IsReadableWhenThereIsAFrame) {
  if (!subject_->wakes()) GTEST_SKIP() << "the fake device has no descriptor that becomes readable";
  static_cast<void>(camera().Next());
  ASSERT_TRUE(subject_->Expose(1, now()));
  EXPECT_TRUE(IsReadable(camera().pollable(), kLongestWait_ms));
}

TEST_P(CameraContract, GivesTheNewestFrameWithTheTimeOfItsExposureAndDropsTheOthers) {
  for (const int age_ms : {3, 2, 1})
    ASSERT_TRUE(
        subject_->Expose(static_cast<std::uint8_t>(age_ms), now() - std::chrono::milliseconds(age_ms)));
  const auto frame = camera().Next();
  ASSERT_TRUE(frame) << frame.error().message();
  EXPECT_EQ(frame->bytes[7], 1);
  EXPECT_EQ(frame->at, now() - std::chrono::milliseconds(1));
  EXPECT_EQ(Cause(camera().Next()), std::errc::resource_unavailable_try_again);
}

TEST_P(CameraContract, AFrameHasAllTheBytesThatItsFormatNeeds) {
  ASSERT_TRUE(subject_->Expose(1, now()));
  const auto frame = camera().Next();
  ASSERT_TRUE(frame) << frame.error().message();
  EXPECT_EQ(frame->format.pixels, ports::PixelFormat::kYuyv);
  EXPECT_GE(frame->stride_bytes, static_cast<std::uint32_t>(frame->format.width_px) * 2);
  EXPECT_GE(frame->bytes.size(), std::size_t{frame->stride_bytes} * std::size_t(frame->format.height_px));
}

TEST_P(CameraContract, ALostFrameIsAGapInTheSequence) {
  ASSERT_TRUE(subject_->Expose(1, now()));
  const auto first = camera().Next();
  ASSERT_TRUE(first) << first.error().message();
  const std::uint32_t sequence = first->sequence;
  for (int n = 0; n < 3; ++n) static_cast<void>(subject_->Expose(2, now()));
  const auto later = camera().Next();
  ASSERT_TRUE(later) << later.error().message();
  EXPECT_EQ(later->sequence, sequence + 3);
}

TEST_P(CameraContract, DropsATornFrameSaysSoOnceAndGoesOn) {
  subject_->ExposeTorn();
  EXPECT_EQ(Cause(camera().Next()), std::errc::bad_message);
  EXPECT_EQ(Cause(camera().Next()), std::errc::resource_unavailable_try_again);
  ASSERT_TRUE(subject_->Expose(5, now()));
  EXPECT_TRUE(camera().Next());
}

TEST_P(CameraContract, NeverRunsOutOfBuffers) {
  for (int n = 0; n < 300; ++n) {
    if (n % 7 == 0) {
      subject_->ExposeTorn();
      ASSERT_FALSE(camera().Next());
    }
    ASSERT_TRUE(subject_->Expose(static_cast<std::uint8_t>(n), now())) << n;
    ASSERT_TRUE(camera().Next()) << n;
  }
}

TEST_P(CameraContract, FailsEverAfterItWasUnplugged) {
  ASSERT_TRUE(subject_->Expose(1, now()));
  ASSERT_TRUE(camera().Next());
  subject_->Unplug();
  for (int n = 0; n < 3; ++n) EXPECT_EQ(Cause(camera().Next()), std::errc::no_such_device);
}

TEST_P(CameraContract, AStreamThatStallsIsBrokenEverAfter) {
  if (!subject_->tells_stalls())
    GTEST_SKIP() << "the simulator's link ends with its camera, and never stalls";
  ASSERT_TRUE(subject_->Expose(1, now()));
  ASSERT_TRUE(camera().Next());
  subject_->clock.Advance(std::chrono::milliseconds(900));
  EXPECT_EQ(Cause(camera().Next()), std::errc::resource_unavailable_try_again);
  subject_->clock.Advance(std::chrono::milliseconds(200));
  EXPECT_EQ(Cause(camera().Next()), std::errc::io_error);
  static_cast<void>(subject_->Expose(1, now()));
  EXPECT_EQ(Cause(camera().Next()), std::errc::io_error);
}

}  // namespace kaori::contracts
