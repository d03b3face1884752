// The contract of ports::Loudspeaker. That no call blocks shows in that the tests end.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/ports/loudspeaker.h"
#include "tests/contracts/contract.h"

namespace kaori::contracts {

// A loudspeaker of two channels with an empty queue, and who
// listens. A verb that returns false cannot be done to this one.
class LoudspeakerSubject : public AnySubject {
 public:
  using Samples = std::vector<std::int16_t>;

  virtual ports::Loudspeaker& loudspeaker() = 0;
  // What it was given so far; after a call the loudspeaker may be closed.
  virtual Samples Played() = 0;
  // Leaves room for so many frames.
  virtual bool LeaveRoom(std::size_t /*frames*/) { return false; }
  virtual bool RunEmpty() { return false; }
  virtual bool Unplug() { return false; }
  virtual bool Break() { return false; }

  // The clock that stamps are compared with.
  virtual Time now() const { return clock.now(); }
  ManualClock clock;
};

class LoudspeakerContract : public Contract<LoudspeakerSubject> {
 protected:
  using Samples = LoudspeakerSubject::Samples;
  ports::Loudspeaker& loudspeaker() { return subject_->loudspeaker(); }
  const Samples frames_{1, -1, 2, -2, 3, -3};
};

TEST_P(LoudspeakerContract, QueuesFramesInTheirOrderAndTellsWhenTheFirstIsHeard) {
  const Time before = subject_->now();
  const auto playout = loudspeaker().Write(frames_);
  ASSERT_TRUE(playout) << playout.error().message();
  EXPECT_EQ(playout->frames, 3U);
  EXPECT_GE(playout->at, before);
  EXPECT_LT(playout->at, before + std::chrono::seconds(1));
  EXPECT_FALSE(playout->xrun);
  EXPECT_EQ(loudspeaker().format(), (ports::SoundFormat{48000, 2}));
  EXPECT_EQ(subject_->Played(), frames_);
}

TEST_P(LoudspeakerContract, RefusesWhatIsNotWholeFrames) {
  ASSERT_TRUE(loudspeaker().Write(frames_));
  EXPECT_EQ(Cause(loudspeaker().Write(Samples{1, 2, 3})), std::errc::invalid_argument);
  EXPECT_EQ(Cause(loudspeaker().Write({})), std::errc::invalid_argument);
}

TEST_P(LoudspeakerContract, QueuesWhatHasRoomAndThenSaysTryAgain) {
  if (!subject_->LeaveRoom(2)) GTEST_SKIP() << "ALSA's plug-ins have room without end";
  const auto playout = loudspeaker().Write(frames_);
  ASSERT_TRUE(playout) << playout.error().message();
  EXPECT_EQ(playout->frames, 2U);
  EXPECT_EQ(Cause(loudspeaker().Write(frames_)), std::errc::resource_unavailable_try_again);
}

TEST_P(LoudspeakerContract, PlaysOnAfterItRanEmptyAndSaysSoOnce) {
  ASSERT_TRUE(loudspeaker().Write(frames_));
  if (!subject_->RunEmpty()) GTEST_SKIP() << "ALSA's plug-ins never run empty";
  auto playout = loudspeaker().Write(frames_);
  ASSERT_TRUE(playout) << playout.error().message();
  EXPECT_TRUE(playout->xrun);
  playout = loudspeaker().Write(frames_);
  ASSERT_TRUE(playout) << playout.error().message();
  EXPECT_FALSE(playout->xrun);
}

TEST_P(LoudspeakerContract, SaysNoSuchDeviceEverAfterItWasUnplugged) {
  ASSERT_TRUE(loudspeaker().Write(frames_));
  if (!subject_->Unplug()) GTEST_SKIP() << "ALSA's plug-ins have no cable";
  for (int n = 0; n < 3; ++n) EXPECT_EQ(Cause(loudspeaker().Write(frames_)), std::errc::no_such_device);
}

TEST_P(LoudspeakerContract, SaysIoErrorEverAfterItsStreamBroke) {
  ASSERT_TRUE(loudspeaker().Write(frames_));
  if (!subject_->Break()) GTEST_SKIP() << "ALSA's plug-ins never break";
  for (int n = 0; n < 3; ++n) EXPECT_EQ(Cause(loudspeaker().Write(frames_)), std::errc::io_error);
}

}  // namespace kaori::contracts
