// The contract of ports::Microphone. That no call blocks shows in that the tests end.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/ports/microphone.h"
#include "tests/contracts/contract.h"

namespace kaori::contracts {

// A microphone of one channel, and what it hears. A verb that returns false cannot be done to this one.
class MicrophoneSubject : public AnySubject {
 public:
  using Samples = std::vector<std::int16_t>;

  virtual ports::Microphone& microphone() = 0;
  // It hears these frames, which end now.
  virtual void Hear(const Samples& samples) = 0;
  virtual bool Overrun() { return false; }
  virtual bool Unplug() { return false; }
  virtual bool Break() { return false; }
  // False where frames never end, as those of ALSA's plug-ins.
  virtual bool falls_silent() const { return true; }

  // The clock that stamps are compared with.
  virtual Time now() const { return clock.now(); }
  ManualClock clock;
};

class MicrophoneContract : public Contract<MicrophoneSubject> {
 protected:
  using Samples = MicrophoneSubject::Samples;
  ports::Microphone& microphone() { return subject_->microphone(); }
};

TEST_P(MicrophoneContract, SaysTryAgainWhileThereIsNoFrame) {
  if (!subject_->falls_silent()) GTEST_SKIP() << "ALSA's plug-ins have frames without end";
  EXPECT_EQ(Cause(microphone().Read()), std::errc::resource_unavailable_try_again);
}

TEST_P(MicrophoneContract, HasADescriptorFromTheStart) {
  subject_->Hear({1});
  if (microphone().pollable() < 0) GTEST_SKIP() << "the fake device has no descriptor";
  static_cast<void>(IsReadable(microphone().pollable()));
}

TEST_P(MicrophoneContract, GivesTheFramesInTheirOrderStampedWithTheTimeOfTheFirst) {
  Samples ramp(480);
  for (std::size_t n = 0; n < ramp.size(); ++n) ramp[n] = static_cast<std::int16_t>(n * 7);
  subject_->Hear(ramp);
  const auto block = microphone().Read();
  ASSERT_TRUE(block) << block.error().message();
  EXPECT_EQ(Samples(block->samples.begin(), block->samples.end()), ramp);
  EXPECT_FALSE(block->xrun);
  EXPECT_LE(block->at, subject_->now());
  EXPECT_GT(block->at, subject_->now() - std::chrono::seconds(1));
}

TEST_P(MicrophoneContract, ItsFormatIsOneThatReadersKnowAndItStays) {
  subject_->Hear({1, 2, 3});
  ASSERT_TRUE(microphone().Read());
  const ports::SoundFormat format = microphone().format();
  EXPECT_EQ(format, (ports::SoundFormat{48000, 1}));
  subject_->Hear({1, 2, 3});
  static_cast<void>(microphone().Read());
  EXPECT_EQ(microphone().format(), format);
}

TEST_P(MicrophoneContract, GoesOnAfterAnOverrunAndSaysSoOnce) {
  subject_->Hear({1});
  ASSERT_TRUE(microphone().Read());
  if (!subject_->Overrun()) GTEST_SKIP() << "ALSA's plug-ins never overrun";
  static_cast<void>(microphone().Read());
  subject_->Hear({5});
  auto block = microphone().Read();
  ASSERT_TRUE(block) << block.error().message();
  EXPECT_TRUE(block->xrun);
  subject_->Hear({6});
  block = microphone().Read();
  ASSERT_TRUE(block) << block.error().message();
  EXPECT_FALSE(block->xrun);
}

TEST_P(MicrophoneContract, SaysNoSuchDeviceEverAfterItWasUnplugged) {
  subject_->Hear({1});
  ASSERT_TRUE(microphone().Read());
  if (!subject_->Unplug()) GTEST_SKIP() << "ALSA's plug-ins have no cable";
  for (int n = 0; n < 3; ++n) EXPECT_EQ(Cause(microphone().Read()), std::errc::no_such_device);
}

TEST_P(MicrophoneContract, SaysIoErrorEverAfterItsStreamBroke) {
  subject_->Hear({1});
  ASSERT_TRUE(microphone().Read());
  if (!subject_->Break()) GTEST_SKIP() << "ALSA's plug-ins never break";
  for (int n = 0; n < 3; ++n) EXPECT_EQ(Cause(microphone().Read()), std::errc::io_error);
}

}  // namespace kaori::contracts
