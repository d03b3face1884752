// A desk before the simulated devices, on the local link, in one thread and in simulated time.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "appliance/core/board/snapshot.h"
#include "appliance/programs/input/input_desk.h"
#include "drivers/hid/local_bus.h"
#include "hw-sim/links/local/rig.h"
#include "tests/appliance/core/board_file.h"

namespace kaori::input {

class InputBench : public ::testing::Test {
 protected:
  InputBench() : board_(file_.Open()) {
    rig_ = sim::Rig::Open({.folder = links()}, clock_).value();
    StartDesk();
    Play(std::chrono::milliseconds(20));
  }

  std::string links() const { return (file_.folder() / "links").string(); }

  void StartDesk() {
    bus_ = hid::LocalHidBus::Watch(links()).value();
    desk_.emplace(board_, DeskWriters::Acquire(board_).value(), DeskSources{.buses = {bus_.get()}, .lines = {}},
                  settings_, clock_);
  }

  // The program dies; the board stays.
  void KillDesk() {
    desk_.reset();
    bus_.reset();
  }

  // Lets time pass in steps of a millisecond.
  void Play(Duration time) {
    for (Duration t{}; t < time; t += std::chrono::milliseconds(1)) {
      clock_.Advance(std::chrono::milliseconds(1));
      rig_->Pump();
      if (desk_) desk_->Step();
    }
  }

  board::Snapshot Board() const { return board::ReadAll(board_); }

  board::BoardFile file_;
  board::Board board_;
  ManualClock clock_;
  InputSettings settings_;
  std::unique_ptr<sim::Rig> rig_;
  std::unique_ptr<ports::HidBus> bus_;
  std::optional<InputDesk> desk_;
};

}  // namespace kaori::input
