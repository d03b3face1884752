// A rig in a folder of its own, with a clock that is turned by hand, and drivers plugged into it.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/hid/local_bus.h"
#include "hw-sim/links/local/rig.h"

namespace kaori::sim {

class TempFolder {
 public:
  TempFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "kaori-link-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) std::abort();
    path_ = name;
  }
  ~TempFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

struct StampedReport {
  Time at{};
  std::vector<std::uint8_t> bytes;
  friend bool operator==(const StampedReport&, const StampedReport&) = default;
};

inline int OpenDescriptors() {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd"))
    count += entry.exists() ? 1 : 0;
  return count;
}

// Every report that waits in the channel.
inline std::vector<StampedReport> ReadAll(ports::HidChannel& channel) {
  std::vector<StampedReport> reports;
  std::array<std::uint8_t, 64> buffer;
  while (const auto input = channel.Read(buffer))
    reports.push_back(
        {input->at, {buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(input->bytes)}});
  return reports;
}

class LinkFixture : public ::testing::Test {
 protected:
  void SetUp() override {
    auto opened = Rig::Open({.folder = folder.path(), .screen_width_px = 64, .screen_height_px = 48}, clock);
    ASSERT_TRUE(opened) << opened.error().message();
    rig = std::move(*opened);
    auto watched = hid::LocalHidBus::Watch(folder.path());
    ASSERT_TRUE(watched) << watched.error().message();
    bus = std::move(*watched);
  }

  // The channel at `port`; nothing where no device answers.
  std::unique_ptr<ports::HidChannel> Channel(const std::string& port) {
    EXPECT_TRUE(bus->Ports());
    rig->Pump();
    EXPECT_TRUE(bus->Ports());
    auto channel = bus->Open(port);
    return channel ? std::move(*channel) : nullptr;
  }

  void Step(Duration by) {
    clock.Advance(by);
    rig->Pump();
  }

  TempFolder folder;
  ManualClock clock;
  std::unique_ptr<Rig> rig;
  std::unique_ptr<ports::HidBus> bus;
};

}  // namespace kaori::sim
