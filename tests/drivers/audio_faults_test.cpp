// What the contracts of sound leave to ALSA: its stamps,
// its suspended buses and its stalls, on a fake device.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drivers/audio/alsa_loudspeaker.h"
#include "drivers/audio/alsa_microphone.h"
#include "tests/drivers/audio_fake_pcm.h"

namespace kaori::audio {
namespace {

using std::chrono::milliseconds;
using ::testing::ElementsAre;

class AlsaTest : public ::testing::Test {
 protected:
  std::unique_ptr<AlsaMicrophone> Microphone() {
    return std::move(AlsaMicrophone::Open("hw:1", {}, clock_, tests::Opener(sound_)).value());
  }
  std::unique_ptr<AlsaLoudspeaker> Loudspeaker() {
    return std::move(AlsaLoudspeaker::Open("hw:1", {}, clock_, tests::Opener(sound_)).value());
  }
  static std::errc Cause(const auto& result) { return result ? std::errc{} : result.error().cause; }

  ManualClock clock_;
  tests::FakeSound sound_;
};

TEST_F(AlsaTest, AMicrophoneStampsItsFirstFrameAsLongAgoAsFramesWait) {
  const auto microphone = Microphone();
  EXPECT_EQ(sound_.started, 1);
  sound_.stamp = clock_.now() - milliseconds(2);
  sound_.delay_frames = 240;
  sound_.heard = {1, 2, 3};
  const auto block = microphone->Read();
  ASSERT_TRUE(block);
  EXPECT_EQ(block->at, clock_.now() - milliseconds(7));
  EXPECT_THAT(block->samples, ElementsAre(1, 2, 3));
  EXPECT_FALSE(block->xrun);
  EXPECT_EQ(Cause(microphone->Read()), std::errc::resource_unavailable_try_again);
}

TEST_F(AlsaTest, AMicrophoneWithoutStampsUsesTheClock) {
  const auto microphone = Microphone();
  sound_.delay_frames = 48;
  sound_.heard = {1};
  EXPECT_EQ(microphone->Read()->at, clock_.now() - milliseconds(1));
}

TEST_F(AlsaTest, AMicrophoneThatWasSuspendedResumesWithItsBus) {
  const auto microphone = Microphone();
  sound_.failing = -ESTRPIPE;
  sound_.resume_answer = -EAGAIN;
  EXPECT_EQ(Cause(microphone->Read()), std::errc::resource_unavailable_try_again);
  EXPECT_EQ(sound_.prepared, 0);
  sound_.resume_answer = -ENOSYS;  // It cannot resume: it begins anew.
  EXPECT_EQ(Cause(microphone->Read()), std::errc::resource_unavailable_try_again);
  EXPECT_EQ(sound_.prepared, 1);
  sound_.heard = {5};
  EXPECT_TRUE(microphone->Read()->xrun);
}

TEST_F(AlsaTest, AMicrophoneThatIsPulledStaysGoneUntilItIsOpenedAnew) {
  auto microphone = Microphone();
  sound_.failing = -ENODEV;
  EXPECT_EQ(Cause(microphone->Read()), std::errc::no_such_device);
  sound_.failing = 0;
  sound_.heard = {5};
  EXPECT_EQ(Cause(microphone->Read()), std::errc::no_such_device);
  microphone.reset();
  EXPECT_EQ(sound_.closed, 1);
  EXPECT_TRUE(Microphone()->Read());
}

TEST_F(AlsaTest, AMicrophoneThatIsPulledWhileItRecoversIsGone) {
  const auto microphone = Microphone();
  sound_.failing = -EPIPE;
  sound_.prepare_answer = -ENODEV;
  EXPECT_EQ(Cause(microphone->Read()), std::errc::no_such_device);
}

TEST_F(AlsaTest, AMicrophoneThatStallsHasBroken) {
  const auto microphone = Microphone();
  clock_.Advance(milliseconds(900));
  EXPECT_EQ(Cause(microphone->Read()), std::errc::resource_unavailable_try_again);
  sound_.heard = {1};
  EXPECT_TRUE(microphone->Read());
  clock_.Advance(milliseconds(1001));
  EXPECT_EQ(microphone->Read().error().attempt, "wait any longer for hw:1");
  sound_.heard = {1};
  EXPECT_EQ(Cause(microphone->Read()), std::errc::io_error);
}

TEST_F(AlsaTest, ALoudspeakerTellsByTheKernelsStampWhenAFrameIsHeard) {
  sound_.format.channels = 2;
  const auto loudspeaker = Loudspeaker();
  sound_.stamp = clock_.now() - milliseconds(1);
  sound_.delay_frames = 480;
  sound_.room_frames = 2;
  const std::vector<std::int16_t> frames{1, -1, 2, -2, 3, -3};
  const auto playout = loudspeaker->Write(frames);
  ASSERT_TRUE(playout);
  EXPECT_EQ(playout->frames, 2u);
  EXPECT_EQ(playout->at, clock_.now() + milliseconds(9));
  EXPECT_THAT(sound_.played, ElementsAre(1, -1, 2, -2));
  EXPECT_EQ(Cause(loudspeaker->Write(frames)), std::errc::resource_unavailable_try_again);
}

}  // namespace
}  // namespace kaori::audio
