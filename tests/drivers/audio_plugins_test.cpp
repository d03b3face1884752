// Real ALSA without a sound card: its null and file plug-ins take our modes, give frames and write them down.
// They never overrun, sleep or get pulled, and have nothing to wait for: that is for a kernel's device, in a
// virtual machine.
#include <gtest/gtest.h>
#include <poll.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "drivers/audio/alsa_loudspeaker.h"
#include "drivers/audio/alsa_microphone.h"

namespace kaori::audio {
namespace {

namespace fs = std::filesystem;

class AlsaPlugins : public ::testing::Test {
 protected:
  AlsaPlugins() : folder_(fs::path(::testing::TempDir()) / ("kaori-alsa-" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
    std::ofstream(folder_ / "asound.conf")
        << "pcm.quiet { type null }\n"
        << "pcm.heard { type file slave.pcm { type null } file /dev/null infile \""
        << (folder_ / "in.raw").string() << "\" format raw }\n"
        << "pcm.written { type file slave.pcm { type null } file \"" << (folder_ / "out.raw").string()
        << "\" format raw }\n";
    ::setenv("ALSA_CONFIG_PATH", (folder_ / "asound.conf").c_str(), 1);
  }
  ~AlsaPlugins() override { fs::remove_all(folder_); }

  fs::path folder_;
  SteadyClock clock_;
};

TEST_F(AlsaPlugins, AMicrophoneGivesTheFramesOfAFile) {
  std::vector<std::int16_t> ramp(480);
  for (std::size_t n = 0; n < ramp.size(); ++n) ramp[n] = static_cast<std::int16_t>(n * 7);
  std::ofstream(folder_ / "in.raw", std::ios::binary)
      .write(reinterpret_cast<const char*>(ramp.data()), static_cast<std::streamsize>(ramp.size() * 2));
  const auto microphone = AlsaMicrophone::Open("heard", {}, clock_);
  ASSERT_TRUE(microphone) << microphone.error().message();
  EXPECT_EQ((*microphone)->format(), (ports::SoundFormat{48000, 1}));
  const auto block = (*microphone)->Read();
  ASSERT_TRUE(block) << block.error().message();
  EXPECT_EQ(std::vector(block->samples.begin(), block->samples.end()), ramp);
  EXPECT_LE(block->at, clock_.now());
  EXPECT_GT(block->at, clock_.now() - std::chrono::seconds(1));
}

TEST_F(AlsaPlugins, ALoudspeakerWritesItsFramesToAFile) {
  const std::vector<std::int16_t> frames{100, -100, 200, -200};
  {
    const auto loudspeaker = AlsaLoudspeaker::Open("written", {.channels = 2}, clock_);
    ASSERT_TRUE(loudspeaker) << loudspeaker.error().message();
    EXPECT_EQ((*loudspeaker)->format().channels, 2);
    const auto playout = (*loudspeaker)->Write(frames);
    ASSERT_TRUE(playout) << playout.error().message();
    EXPECT_EQ(playout->frames, 2u);
  }
  std::ifstream file(folder_ / "out.raw", std::ios::binary);
  std::vector<std::int16_t> written(frames.size());
  file.read(reinterpret_cast<char*>(written.data()), 8);
  EXPECT_EQ(file.gcount(), 8);
  EXPECT_EQ(written, frames);
}

TEST_F(AlsaPlugins, WhatIsNotThereIsNoSuchDevice) {
  EXPECT_EQ(AlsaMicrophone::Open("nobody", {}, clock_).error().cause, std::errc::no_such_device);
  EXPECT_EQ(AlsaLoudspeaker::Open("nobody", {}, clock_).error().cause, std::errc::no_such_device);
}

TEST_F(AlsaPlugins, ADeviceWithNothingToWaitForWakesNobody) {
  const auto microphone = AlsaMicrophone::Open("quiet", {}, clock_);
  ASSERT_TRUE(microphone);
  pollfd ready{(*microphone)->pollable(), POLLIN, 0};
  ASSERT_GE(ready.fd, 0);
  EXPECT_EQ(::poll(&ready, 1, 0), 0);
}

}  // namespace
}  // namespace kaori::audio
