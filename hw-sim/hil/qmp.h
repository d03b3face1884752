// QEMU's own line for whoever holds the machine: one command at a time.
#pragma once

#include <string>

#include "drivers/base/result.h"
#include "hw-sim/hil/stream.h"

namespace kaori::hil {

class Qmp {
 public:
  // Calls and greets. Errors: timed_out, no_such_device.
  static Result<Qmp> Call(const std::string& path, Waiter& waiter);

  // `arguments` is JSON, an object. Errors: invalid_argument (QEMU's own message), timed_out, no_such_device.
  Result<void> Do(const std::string& command, const std::string& arguments = "{}");

 private:
  Qmp(Stream stream, Waiter& waiter) : stream_(std::move(stream)), waiter_(&waiter) {}
  Result<std::string> NextLine();

  Stream stream_;
  Waiter* waiter_;
};

}  // namespace kaori::hil
