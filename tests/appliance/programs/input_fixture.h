// A fixture: the input service reads the simulated devices over the local link, in one thread and simulated
// time.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "appliance/core/board/snapshot.h"
#include "appliance/programs/input/input_service.h"
#include "drivers/hid/local_bus.h"
#include "hw-sim/links/local/rig.h"
#include "tests/appliance/core/board_file.h"

namespace kaori::input {

class InputFixture : public ::testing::Test {
 protected:
  InputFixture() : board_(file_.Open()) {
    rig_ = sim::Rig::Open({.folder = links()}, clock_).value();
    StartService();
    Play(std::chrono::milliseconds(20));
  }

  std::string links() const { return (file_.folder() / "links").string(); }

  void StartService() {
    bus_ = hid::LocalHidBus::Watch(links()).value();
    service_.emplace(board_, InputWriters::Acquire(board_).value(),
                     InputSources{.buses = {bus_.get()}, .lines = {}, .has_keyboards = has_keyboards_},
                     settings_, clock_);
  }

  // Ends the service as if its program had died; the board stays.
  void KillService() {
    service_.reset();
    bus_.reset();
  }

  // Lets simulated time pass in steps of one millisecond.
  void Play(Duration time) {
    for (Duration t{}; t < time; t += std::chrono::milliseconds(1)) {
      clock_.Advance(std::chrono::milliseconds(1));
      rig_->Pump();
      if (service_) service_->Step();
    }
  }

  board::Snapshot Board() const { return board::ReadAll(board_); }

  board::BoardFile file_;
  board::Board board_;
  ManualClock clock_;
  InputSettings settings_;
  bool has_keyboards_ = true;
  std::unique_ptr<sim::Rig> rig_;
  std::unique_ptr<ports::HidBus> bus_;
  std::optional<InputService> service_;
};

}  // namespace kaori::input
