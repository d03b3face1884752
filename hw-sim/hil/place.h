// A place on the bench: a box, the devices that are plugged into it, and who looks at it.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "hw-sim/hil/board_view.h"
#include "hw-sim/hil/qemu.h"
#include "hw-sim/hil/serial_witness.h"
#include "hw-sim/hil/waiter.h"
#include "hw-sim/links/usbredir/usb_rig.h"

namespace kaori::hil {

// One thread: devices are played on while anything waits.
class Place final : public Waiter {
 public:
  // Errors: those of the folder for sockets and of the simulator.
  static Result<std::unique_ptr<Place>> Open(QemuOptions options, const Clock& clock);

  bool Until(const std::function<bool()>& done, Duration longest, int fd = -1) override;

  sim::UsbRig& rig() { return *rig_; }
  QemuDriver& machine() { return machine_; }
  SerialWitnessDriver& witness() { return witness_; }
  const Clock& clock() const { return clock_; }

  // The board as it is now. Errors: as WitnessProtocol::Ask, and of a board that is not there yet.
  Result<BoardView> Board();

  // Looks at the board until `right`; gives the last view. Errors: timed_out, named by `what`.
  Result<BoardView> UntilBoard(const std::function<bool(const BoardView&)>& right, Duration longest,
                               const std::string& what);

  // Whoever moves while anything waits: called before each look at the devices. Empty: nobody.
  void SetHands(std::function<void(Time)> hands) { hands_ = std::move(hands); }

  // Plugs in everything that a box has. Errors: none but of our own.
  Result<void> PlugAll();
  Result<void> PullAll();

 private:
  Place(QemuOptions options, std::unique_ptr<sim::UsbRig> rig, const Clock& clock);

  const Clock& clock_;
  std::unique_ptr<sim::UsbRig> rig_;
  QemuDriver machine_;
  SerialWitnessDriver witness_;
  std::function<void(Time)> hands_;
};

}  // namespace kaori::hil
