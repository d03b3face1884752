// One HID device through the kernel's hidraw node.
#pragma once

#include <deque>
#include <span>
#include <vector>

#include "drivers/base/unique_fd.h"
#include "drivers/decode/standing_reports.h"
#include "drivers/ports/hid_channel.h"

namespace kaori::hid {

// As ports::HidChannel. Read never blocks. The kernel sends an output report before its write returns: about
// 1 ms, and up to its own time-out of 5 s when a device does not answer; LibusbChannel does not wait.
class HidrawChannel final : public ports::HidChannel {
 public:
  // `node` is an open, non-blocking hidraw node. Borrows `clock` for its life.
  HidrawChannel(UniqueFd node, ports::HidIdentity identity, const Clock& clock);

  // Asks the device for these reports; what it says is read first, before what it sends by itself. Linux
  // throws away what a device sends in the first 50 ms after it was opened, and one that is held still says
  // no more. A device that stalls or answers rubbish has said nothing. Waits for the device: about 1 ms, and
  // 5 s for one that does not answer at all. Errors: timed_out (that one).
  Result<void> AskHowItStands(std::span<const decode::StandingReport> reports);

  int pollable() const override { return node_.get(); }
  const ports::HidIdentity& identity() const override { return identity_; }
  Result<ports::HidInput> Read(std::span<std::uint8_t> into) override;
  Result<void> Write(std::span<const std::uint8_t> report) override;

 private:
  tl::unexpected<Error> Failed(int error, const char* verb);
  tl::unexpected<Error> Gone() const;

  Result<void> Ask(const decode::StandingReport& report);

  UniqueFd node_;
  ports::HidIdentity identity_;
  const Clock& clock_;
  std::deque<std::vector<std::uint8_t>> standing_;  // As they would be read.
  bool gone_ = false;
};

// The report descriptor that an open hidraw node gives. Errors: no_such_device, io_error.
Result<std::vector<std::uint8_t>> ReadHidrawDescriptor(int node);

}  // namespace kaori::hid
