// A target of the bench: a box, the simulated devices that are plugged into it, and the in-guest agent.
#pragma once

#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>

#include "hw-sim/hil/board_view.h"
#include "hw-sim/hil/qemu.h"
#include "hw-sim/hil/serial_agent.h"
#include "hw-sim/hil/waiter.h"
#include "hw-sim/links/usbredir/usb_rig.h"

namespace kaori::hil {

// What the stage says in the log once it has drawn its first picture.
inline constexpr std::string_view kFirstPicture = "the first picture is drawn";

// Everything that a check can touch. Devices are played on while anything waits: whoever waits
// in another way stops them. One thread.
class Target final : public Waiter {
 public:
  // Makes the simulator; no machine runs and nothing is plugged in. Errors: those of the
  // folder for sockets and of the simulator.
  static Result<std::unique_ptr<Target>> Open(QemuOptions options, const Clock& clock);

  // As Waiter says.
  bool Until(const std::function<bool()>& done, Duration longest, int fd = -1) override;

  // Its devices hang at the machine's USB sockets.
  sim::UsbRig& rig() { return *rig_; }
  QemuDriver& machine() { return machine_; }
  SerialAgentDriver& agent() { return agent_; }
  // The clock of this computer; the guest has its own.
  const Clock& clock() const { return clock_; }

  // The board as it is now, by a question to the agent. Blocks until it answers, 90 s at most. Errors:
  // as AgentProtocol::Ask, and of a board that is not there yet.
  Result<BoardView> Board();

  // Asks `right` ten times a second until it is so. Errors: timed_out, named by `what`.
  Result<void> Await(const std::function<bool()>& right, Duration longest, const std::string& what);

  // Looks at the board until `right`, ten times a second; gives the last view. A look that fails is
  // tried again. Errors: timed_out, named by `what` and with what was seen last.
  Result<BoardView> UntilBoard(const std::function<bool(const BoardView&)>& right, Duration longest,
                               const std::string& what);

  // Waits until a frame has been drawn of what the board says now. Errors: those of the board, and as UntilBoard.
  Result<void> AwaitFrame(Duration longest, const std::string& what);

  // Waits until one line of the log of a machine without an agent has all of `parts`. False: it did not come
  // in time, or the machine ended before.
  bool UntilConsole(std::initializer_list<std::string_view> parts, Duration longest);
  // The same until the log says, by the stage or by the service manager, that the stage has drawn its first picture.
  bool UntilFirstPicture(Duration longest);

  // Await and UntilBoard wait no longer than this: in the control of a check nothing is expected to come.
  void SetPatience(Duration patience) { patience_ = patience; }
  // As long as each call is told.
  void ResetPatience() { patience_ = Duration::max(); }

  // Whoever moves while anything waits: called before each look at the devices. Empty: nobody.
  void SetInput(std::function<void(Time)> input) { input_ = std::move(input); }

  // Plugs in everything that a box has, or pulls everything. Errors: none but of our own.
  Result<void> PlugAll();
  Result<void> PullAll();

 private:
  Target(QemuOptions options, std::unique_ptr<sim::UsbRig> rig, const Clock& clock);

  const Clock& clock_;
  std::unique_ptr<sim::UsbRig> rig_;
  QemuDriver machine_;
  SerialAgentDriver agent_;
  // Null: nobody moves.
  std::function<void(Time)> input_;
  // Of UntilBoard; the longest there is where nobody set one.
  Duration patience_ = Duration::max();
};

}  // namespace kaori::hil
