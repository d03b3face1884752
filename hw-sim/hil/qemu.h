// A box in QEMU, without acceleration: the image as it ships; with the in-guest agent the bench's disk is
// beside it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/base/json.h"
#include "hw-sim/hil/machine_lines.h"
#include "hw-sim/hil/process.h"
#include "hw-sim/hil/protocols.h"
#include "hw-sim/hil/qemu_command.h"
#include "hw-sim/hil/qmp.h"
#include "hw-sim/hil/setup.h"
#include "hw-sim/hil/vnc_screen.h"
#include "hw-sim/hil/waiter.h"
#include "hw-sim/hil/x_screen.h"

namespace kaori::hil {

// Owns the process of the machine and the line to its monitor. One thread: that of the waiter, in which
// simulated devices play on while anything here waits.
class QemuDriver final : public PowerProtocol, public VideoProtocol, public UnauthorisedDeviceProtocol {
 public:
  // Starts nothing. The waiter outlives the driver.
  QemuDriver(QemuOptions options, Waiter& waiter) : options_(std::move(options)), waiter_(waiter) {}

  // Of the next time that power comes; a machine that runs stays as it is.
  void SetUp(const Setup& setup) { setup_ = setup; }
  const Setup& setup() const { return setup_; }

  // Starts QEMU and waits until its monitor answers, a minute at most; the guest's start is not
  // waited for. Errors: those of the image's files and of starting the program; timed_out;
  // not_supported (the bench lacks what the setup wants).
  Result<void> On() override;
  // Kills QEMU: the guest notices nothing, as with a pulled plug.
  void Off() override;
  Result<void> Shoot(int head, const std::string& file) override;
  Result<void> PlugScreen(int head, int width_px, int height_px) override;
  Result<void> PlugUnauthorised(UnauthorisedDevice device) override;
  Result<void> PlugStick(const std::string& image, bool writable) override;
  Result<void> PlugFailingStick(const std::string& image, const StickFault& fault) override;
  Result<void> PullUnauthorised() override;
  // A short press of the machine's power button. Errors: as Qmp::Do; no_such_device, it is off.
  Result<void> PressPower();
  // Sets the level of a line of the machine's own GPIO controller. Errors: as MachineLines; no_such_device, also
  // where it is off or has no such controller.
  Result<void> SetLine(int line, bool high);

  // The processors' time of QEMU since it was started; zero while it is off.
  Duration worked() const { return process_ ? process_->worked() : Duration{}; }
  // Takes the processors away from the whole machine, and gives them back.
  void Freeze(bool frozen) const;
  // Its process has not ended; the guest may be dead all the same.
  bool runs() const { return process_ && process_->runs(); }
  const QemuOptions& options() const { return options_; }
  // What QEMU complained of.
  std::string log() const;
  // What a machine without an agent has said on its serial line so far.
  std::string console() const;

 private:
  // Prepares the disk and starts the process. Errors: as On.
  Result<void> Start();
  // The disk's path: the image's own, another one, or a copy with other settings.
  Result<std::string> Disk();
  // Plugs in a stick with that disk, a node of QEMU's (blockdev-add). Errors: as PlugStick.
  Result<void> PlugDisk(json::Object file, bool writable);

  QemuOptions options_;
  Waiter& waiter_;
  Setup setup_;
  // Only with Graphics::kVirgl. Ends after the machine that shows there.
  std::optional<XScreen> window_;
  std::optional<Process> process_;
  // Is there while the machine has power.
  std::optional<Qmp> qmp_;
  // Called when a line is first set.
  std::optional<MachineLines> lines_;
  // That were plugged in: each image has a name of its own in QEMU.
  int sticks_ = 0;
  // Those that can be plugged in and unplugged.
  std::vector<VncScreen> screens_;
};

}  // namespace kaori::hil
