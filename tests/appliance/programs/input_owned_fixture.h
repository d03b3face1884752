// A fixture: the input service with the surfaces that people own, and nothing else plugged in.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/epoll.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "appliance/core/board/snapshot.h"
#include "appliance/programs/input/input_service.h"
#include "drivers/hid/local_bus.h"
#include "hw-sim/links/local/hid_port.h"
#include "tests/appliance/core/board_file.h"

namespace kaori::input {

// The files that ship, which are all sound.
inline std::vector<SurfaceMap> ShippedMaps() {
  std::vector<SurfaceMap> maps;
  EXPECT_THAT(ReadSurfaceMaps(KAORI_SURFACES, maps), ::testing::IsEmpty());
  return maps;
}

// Without the rig: only what a test plugs in is there.
class OwnedDevices : public ::testing::Test {
 protected:
  OwnedDevices() : board_(file_.Open()), epoll_(::epoll_create1(EPOLL_CLOEXEC)) {
    std::filesystem::create_directories(links());
    settings_.sticks[0].slider_reversed = true;
  }
  std::string links() const { return (file_.folder() / "links").string(); }
  void PlugIn(const std::string& port, sim::HidDevice& device) {
    cables_.push_back(std::make_unique<sim::HidPort>(links() + "/hid." + port, epoll_.get(), device, clock_));
    ASSERT_TRUE(cables_.back()->Plug());
  }
  void Start() {
    bus_ = hid::LocalHidBus::Watch(links()).value();
    service_.emplace(board_, InputWriters::Acquire(board_).value(),
                     InputSources{.buses = {bus_.get()}, .lines = {}, .maps = maps_}, settings_, clock_);
    Play(std::chrono::milliseconds(30));
  }
  void Play(Duration time) {
    for (Duration t{}; t < time; t += std::chrono::milliseconds(1)) {
      clock_.Advance(std::chrono::milliseconds(1));
      for (auto& cable : cables_) cable->Pump(clock_.now());
      if (service_) service_->Step();
    }
  }
  board::Snapshot Board() const { return board::ReadAll(board_); }

  board::BoardFile file_;
  board::Board board_;
  ManualClock clock_;
  UniqueFd epoll_;
  InputSettings settings_;
  std::vector<SurfaceMap> maps_ = ShippedMaps();
  std::vector<std::unique_ptr<sim::HidPort>> cables_;
  std::unique_ptr<ports::HidBus> bus_;
  std::optional<InputService> service_;
};

}  // namespace kaori::input
