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
  // Events that QEMU tells of meanwhile are read and dropped.
  Result<void> Do(const std::string& command, json::Object arguments = {});

  // The path of the first child that is of that type, in QEMU's tree of objects ("/machine/unattached", "pl061"). Errors: as
  // Do; no_such_device, there is none.
  Result<std::string> ChildOfType(const std::string& path, const std::string& type);

 private:
  Qmp(Stream stream, Waiter& waiter) : stream_(std::move(stream)), waiter_(&waiter) {}
  // As Do; gives the whole answer, an object of JSON whose "return" is what was asked for.
  Result<std::string> Ask(const std::string& command, json::Object arguments);

  Stream stream_;
  Waiter* waiter_;
};

}  // namespace kaori::hil
