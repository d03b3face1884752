// The simulated microphone and loudspeaker, and the drivers at the other end of their links.
#include <cmath>
#include <numeric>

#include "drivers/audio/local_loudspeaker.h"
#include "drivers/audio/local_microphone.h"
#include "drivers/base/packet_socket.h"
#include "tests/hw-sim/link_fixture.h"

namespace kaori::sim {
namespace {

using namespace std::chrono_literals;

double Level_db(std::span<const std::int16_t> samples) {
  double power = 0;
  for (const std::int16_t sample : samples) power += double{1} * sample * sample;
  return 10 * std::log10(power / static_cast<double>(samples.size()) / 32768 / 32768);
}

class SoundLink : public LinkFixture {
 protected:
  void SetUp() override {
    LinkFixture::SetUp();
    microphone = audio::LocalMicrophone::Open(folder.path()).value();
    loudspeaker = audio::LocalLoudspeaker::Open(folder.path(), clock).value();
    rig->Pump();
  }
  // Every frame that waits, and the time of the first.
  struct Got {
    std::optional<Time> at;
    std::vector<std::int16_t> samples;
    int xruns = 0;
  };
  Got ReadSound() {
    Got got;
    while (const auto block = microphone->Read()) {
      if (!got.at) got.at = block->at;
      got.xruns += block->xrun ? 1 : 0;
      got.samples.insert(got.samples.end(), block->samples.begin(), block->samples.end());
    }
    return got;
  }
  Got RunMicrophone(Duration time) {
    Got got;
    for (Duration passed{}; passed < time; passed += 1ms) {
      Step(1ms);
      Got more = ReadSound();
      if (!got.at) got.at = more.at;
      got.xruns += more.xruns;
      got.samples.insert(got.samples.end(), more.samples.begin(), more.samples.end());
    }
    return got;
  }
  std::vector<std::int16_t> Stereo(std::size_t frames, std::int16_t value) const {
    return std::vector<std::int16_t>(frames * 2, value);
  }

  std::unique_ptr<ports::Microphone> microphone;
  std::unique_ptr<ports::Loudspeaker> loudspeaker;
};

TEST_F(SoundLink, HearsTheVoiceFromTheMomentAtWhichItBegins) {
  RunMicrophone(50ms);
  Step(2ms);
  const Time begins = clock.now();
  rig->microphone().Say(0, 1);
  const Got got = RunMicrophone(300ms);
  ASSERT_TRUE(got.at);
  EXPECT_EQ(microphone->format(), (ports::SoundFormat{48000, 1}));
  const auto before = static_cast<std::size_t>(std::lround(Seconds(begins - *got.at) * 48000));
  ASSERT_LT(before + 480, got.samples.size());
  EXPECT_LT(Level_db(std::span(got.samples).first(before)), -60) << "a quiet room";
  EXPECT_GT(Level_db(std::span(got.samples).subspan(before, 480)), -30) << "and within 10 ms a voice";
  EXPECT_NEAR(Level_db(std::span(got.samples).last(4800)), -20, 2);
}

TEST_F(SoundLink, ACrystalThatRunsFastGivesMoreFrames) {
  EXPECT_NEAR(static_cast<double>(RunMicrophone(1s).samples.size()), 48000, 300);
  rig->microphone().SetDrift(20000);
  EXPECT_NEAR(static_cast<double>(RunMicrophone(1s).samples.size()), 48960, 300);
}

TEST_F(SoundLink, BlocksThatAreLostAreToldAndStampsGoOn) {
  RunMicrophone(20ms);
  rig->microphone().LoseBlocks(3);
  const Got got = RunMicrophone(100ms);
  EXPECT_EQ(got.xruns, 1);
  EXPECT_EQ(got.samples.size(), 4800U - 3 * 240);
  rig->microphone().Stall(true);
  EXPECT_EQ(RunMicrophone(500ms).samples.size(), 0U);
  rig->microphone().Stall(false);
  const Got after = RunMicrophone(50ms);
  EXPECT_GE(after.samples.size(), 1920U);
  EXPECT_GE(*after.at, clock.now() - 50ms);
}

TEST_F(SoundLink, AMicrophoneThatIsPulledIsGoneAndComesBack) {
  ASSERT_TRUE(rig->Unplug("microphone"));
  const auto gone = microphone->Read();
  ASSERT_FALSE(gone);
  EXPECT_EQ(gone.error().cause, std::errc::no_such_device);
  EXPECT_FALSE(audio::LocalMicrophone::Open(folder.path()));
  ASSERT_TRUE(rig->Plug("microphone"));
  microphone = audio::LocalMicrophone::Open(folder.path()).value();
  rig->Pump();
  EXPECT_GT(RunMicrophone(50ms).samples.size(), 0U);
}

TEST_F(SoundLink, TheLoudspeakerPlaysWhatItIsGivenAndTheDriverKnowsWhen) {
  ASSERT_TRUE(loudspeaker->Write(Stereo(240, 0)));
  EXPECT_EQ(loudspeaker->format(), (ports::SoundFormat{48000, 2}));
  rig->Pump();
  Time promised{};
  for (int n = 0; n < 40; ++n) {
    const auto out = loudspeaker->Write(Stereo(240, n == 20 ? 8000 : 100));
    ASSERT_TRUE(out);
    EXPECT_EQ(out->frames, 240U);
    EXPECT_FALSE(out->xrun);
    if (n == 20) promised = out->at;
    Step(5ms);
  }
  Time heard{};
  for (const auto& block : rig->loudspeaker().DrainHeard())
    for (std::size_t n = 0; n < block.samples.size() && heard == Time{}; n += 2)
      if (block.samples[n] == 8000)
        heard = block.at + FromSeconds(block.frame_s * static_cast<double>(n / 2));
  ASSERT_NE(heard, Time{});
  EXPECT_NEAR(Seconds(promised - heard), 0, 1e-4);
}

TEST_F(SoundLink, TheLoudspeakerHasOnlySoMuchRoomAndSaysThatItRanDry) {
  std::size_t taken = 0;
  for (int n = 0; n < 100; ++n)
    if (const auto out = loudspeaker->Write(Stereo(480, 1)))
      taken += out->frames;
    else
      EXPECT_EQ(out.error().cause, std::errc::resource_unavailable_try_again);
  EXPECT_EQ(taken, Loudspeaker::kRoomFrames);
  for (int n = 0; n < 200; ++n) Step(1ms);
  EXPECT_EQ(rig->loudspeaker().dry(), 1U);
  const auto out = loudspeaker->Write(Stereo(240, 1));
  ASSERT_TRUE(out);
  EXPECT_TRUE(out->xrun);
  EXPECT_LE(out->at - clock.now(), 1ms);
  Step(1ms);
  EXPECT_FALSE(loudspeaker->Write(Stereo(240, 1))->xrun);
}

TEST_F(SoundLink, ALoudspeakerThatIsPulledIsGone) {
  ASSERT_TRUE(loudspeaker->Write(Stereo(240, 1)));
  ASSERT_TRUE(rig->Unplug("loudspeaker"));
  const auto gone = loudspeaker->Write(Stereo(240, 1));
  ASSERT_FALSE(gone);
  EXPECT_EQ(gone.error().cause, std::errc::no_such_device);
}

TEST_F(SoundLink, RefusesHalfAFrameAndNone) {
  ASSERT_TRUE(loudspeaker->Write(Stereo(240, 1)));
  const std::vector<std::int16_t> half(3);
  EXPECT_EQ(loudspeaker->Write(half).error().cause, std::errc::invalid_argument);
  EXPECT_EQ(loudspeaker->Write({}).error().cause, std::errc::invalid_argument);
}

// A peer that says anything at all.
class Nonsense : public ::testing::TestWithParam<std::vector<std::uint8_t>> {};

TEST_P(Nonsense, EndsTheStreamAndNeverHarmsTheProgram) {
  const TempFolder folder;
  const ManualClock clock;
  const std::string end = folder.path() + "/microphone.microphone";
  const auto listener = ListenForPackets(end).value();
  auto microphone = audio::LocalMicrophone::Open(folder.path()).value();
  const auto peer = AcceptPeer(listener.get()).value();
  ASSERT_TRUE(SendPacket(peer.get(), GetParam()));
  EXPECT_EQ(microphone->Read().error().cause, std::errc::io_error);
  EXPECT_EQ(microphone->Read().error().cause, std::errc::io_error) << "every later call says the same";

  const auto other = ListenForPackets(folder.path() + "/loudspeaker.loudspeaker").value();
  auto loudspeaker = audio::LocalLoudspeaker::Open(folder.path(), clock).value();
  const auto far = AcceptPeer(other.get()).value();
  ASSERT_TRUE(SendPacket(far.get(), GetParam()));
  const std::vector<std::int16_t> frames(480);
  EXPECT_EQ(loudspeaker->Write(frames).error().cause, std::errc::io_error);
  EXPECT_EQ(loudspeaker->Write(frames).error().cause, std::errc::io_error);
}

std::vector<std::uint8_t> Bytes(std::initializer_list<std::uint32_t> words) {
  std::vector<std::uint8_t> bytes(words.size() * 4);
  std::size_t at = 0;
  for (const std::uint32_t word : words) wire::PutU32(bytes, std::exchange(at, at + 4), word);
  return bytes;
}
INSTANTIATE_TEST_SUITE_P(Packets, Nonsense,
                         ::testing::Values(std::vector<std::uint8_t>{1, 2, 3}, Bytes({1, 2, 3}),
                                           Bytes({1, 2, 3, 4}), Bytes({wire::kMicrophoneHello, 48000, 9}),
                                           Bytes({wire::kMicrophoneHello, 0, 1}),
                                           Bytes({wire::kLoudspeakerHello, 48000, 2, 0}),
                                           Bytes({wire::kLoudspeakerHello, 48000, 99, 2880}),
                                           Bytes({wire::kLoudspeakerHello, 0xFFFFFFFF, 2, 2880})));

}  // namespace
}  // namespace kaori::sim
