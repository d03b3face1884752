// One HID device through the kernel's hidraw node.
#pragma once

#include "drivers/base/unique_fd.h"
#include "drivers/ports/hid_channel.h"

namespace kaori::hid {

// As ports::HidChannel. Read never blocks. The kernel sends an output report before its write returns: about
// 1 ms, and up to its own time-out of 5 s when a device does not answer; LibusbChannel does not wait.
class HidrawChannel final : public ports::HidChannel {
 public:
  // `node` is an open, non-blocking hidraw node. Borrows `clock` for its life.
  HidrawChannel(UniqueFd node, ports::HidIdentity identity, const Clock& clock);

  int pollable() const override { return node_.get(); }
  const ports::HidIdentity& identity() const override { return identity_; }
  Result<ports::HidInput> Read(std::span<std::uint8_t> into) override;
  Result<void> Write(std::span<const std::uint8_t> report) override;

 private:
  tl::unexpected<Error> Failed(int error, const char* verb);
  tl::unexpected<Error> Gone() const;

  UniqueFd node_;
  ports::HidIdentity identity_;
  const Clock& clock_;
  bool gone_ = false;
};

// The report descriptor that an open hidraw node gives. Errors: no_such_device, io_error.
Result<std::vector<std::uint8_t>> ReadHidrawDescriptor(int node);

}  // namespace kaori::hid
