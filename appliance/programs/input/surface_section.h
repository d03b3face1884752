// The section of the dial box on the board, which several devices may play together.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "appliance/core/board/board.h"
#include "appliance/programs/input/carried_switches.h"

namespace kaori::input {

// Turns of all devices add up, a button is held while one of them holds it, and pushes of each count. It goes
// on from what the board holds, over plugs and restarts: buttons that were held then count as the first
// device's. One thread.
class SurfaceSection {
 public:
  // The board is not kept. `devices` is how many there may be; they are called by their numbers.
  SurfaceSection(const board::Board& board, board::Writer<board::Surface> writer, int counts_per_turn,
                 std::size_t devices);

  int counts_per_turn() const { return surface_.value.counts_per_turn; }

  // A device comes: the section is live from here on. Or it goes: what it held is let go, and without another
  // one the section is stale. Both publish.
  void Plug(std::size_t device, Time now);
  void Unplug(std::size_t device, Time now);

  // What a device did; published by Publish.
  void Turn(std::size_t dial, std::int32_t counts, Time at);
  void Switch(std::size_t device, const decode::Switches<1>& now, Time at);
  // Lets go what the device holds, without a time of its own: that nobody holds it any more is no new input.
  void Release(std::size_t device);
  void Publish();

 private:
  struct Device {
    CarriedSwitches<1> buttons;
    bool is_plugged = false;
  };
  void Write();

  board::Writer<board::Surface> writer_;
  board::Stamped<board::Surface> surface_;  // As it was published last, but for buttons_down.
  std::vector<Device> devices_;
  bool changed_ = false;
};

}  // namespace kaori::input
