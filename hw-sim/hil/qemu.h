// A box in QEMU, without acceleration: the image as it ships; with the in-guest agent the bench's disk is beside it.
#pragma once

#include <optional>
#include <string>

#include "hw-sim/hil/process.h"
#include "hw-sim/hil/protocols.h"
#include "hw-sim/hil/qemu_command.h"
#include "hw-sim/hil/qmp.h"
#include "hw-sim/hil/setup.h"
#include "hw-sim/hil/waiter.h"
#include "hw-sim/hil/x_screen.h"

namespace kaori::hil {

class QemuDriver final : public PowerProtocol, public VideoProtocol, public UnauthorisedDeviceProtocol {
 public:
  // The waiter outlives the driver.
  QemuDriver(QemuOptions options, Waiter& waiter) : options_(std::move(options)), waiter_(waiter) {}

  // Of the next time that power comes.
  void SetUp(const Setup& setup) { setup_ = setup; }
  const Setup& setup() const { return setup_; }

  // Errors: those of the image's files and of starting the program; timed_out; not_supported (the bench lacks
  // what the setup wants).
  Result<void> On() override;
  void Off() override;
  Result<void> Shoot(int head, const std::string& file) override;
  Result<void> PlugUnauthorised(UnauthorisedDevice device) override;
  Result<void> PullUnauthorised() override;

  Duration worked() const { return process_ ? process_->worked() : Duration{}; }
  bool runs() const { return process_ && process_->runs(); }
  const QemuOptions& options() const { return options_; }
  std::string log() const;      // What QEMU complained of.
  std::string console() const;  // What a machine without an agent has said on its serial line so far.

 private:
  Result<void> Start();
  Result<std::string> Disk();

  QemuOptions options_;
  Waiter& waiter_;
  Setup setup_;
  std::optional<XScreen> window_;
  std::optional<Process> process_;
  std::optional<Qmp> qmp_;
};

}  // namespace kaori::hil
