// What the contracts of sound leave to real ALSA without a sound card. Its plug-ins have no descriptor: that
// a device wakes the program is tested with a kernel's device, in a virtual machine.
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
    std::ofstream(folder_ / "asound.conf") << "pcm.quiet { type null }\n";
    ::setenv("ALSA_CONFIG_PATH", (folder_ / "asound.conf").c_str(), 1);
  }
  ~AlsaPlugins() override { fs::remove_all(folder_); }

  fs::path folder_;
  SteadyClock clock_;
};

TEST_F(AlsaPlugins, WhatIsNotThereIsNoSuchDevice) {
  EXPECT_EQ(AlsaMicrophone::Open("nobody", {}, clock_).error().cause, std::errc::no_such_device);
  EXPECT_EQ(AlsaLoudspeaker::Open("nobody", {}, clock_).error().cause, std::errc::no_such_device);
}

TEST_F(AlsaPlugins, ADeviceWithoutADescriptorIsNeverReadable) {
  const auto microphone = AlsaMicrophone::Open("quiet", {}, clock_);
  ASSERT_TRUE(microphone);
  pollfd ready{(*microphone)->pollable(), POLLIN, 0};
  ASSERT_GE(ready.fd, 0);
  EXPECT_EQ(::poll(&ready, 1, 0), 0);
}

}  // namespace
}  // namespace kaori::audio
