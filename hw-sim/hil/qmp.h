// QEMU's own line for whoever holds the machine: one command at a time.
#pragma once

#include <string>

#include "drivers/base/json.h"
#include "drivers/base/result.h"
#include "hw-sim/hil/stream.h"

namespace kaori::hil {

// The monitor of one machine (QMP, docs/interop/qmp-spec.rst of QEMU). One thread: that of the waiter.
class Qmp {
 public:
  // Connects, reads the greeting and leaves the negotiation mode. Blocks, two minutes at most, while the
  // waiter plays on. Errors: timed_out, no_such_device.
  static Result<Qmp> Call(const std::string& path, Waiter& waiter);

  // Does one command and waits for its answer, a minute at most. Errors: invalid_argument (QEMU's own
  // message), timed_out, no_such_device.
  // Events that QEMU tells of meanwhile are read and dropped: the bench learns of a reset or a stop by the guest itself.
  Result<void> Do(const std::string& command, json::Object arguments = {});

 private:
  Qmp(Stream stream, Waiter& waiter) : stream_(std::move(stream)), waiter_(&waiter) {}
  // The next line, without its end. Errors: timed_out, no_such_device.
  Result<std::string> NextLine();

  Stream stream_;
  Waiter* waiter_;
};

}  // namespace kaori::hil
