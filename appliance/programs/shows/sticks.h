// The stick that is in, among all that are plugged in.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "appliance/programs/shows/stick_mount.h"
#include "drivers/base/result.h"

namespace kaori::shows {

// Mounts the first that holds shows, keys, backups or settings of all partitions of all sticks, else any that can be mounted:
// computers put a small partition of their own in front of the one that people see. What cannot be mounted is
// tried again when it was out.
class Sticks {
 public:
  explicit Sticks(std::filesystem::path at) : at_(std::move(at)) {}

  // Where the stick is mounted; nothing while none is in. A stick in place of another is nothing for one look, so that the
  // list of the first one is forgotten. Errors: those of StickMount::Make.
  Result<std::optional<std::filesystem::path>> Look();

  // Where nothing is mounted, a folder stands for the stick. Errors: those of StickMount.
  Result<void> SetWritable(bool writable);

 private:
  // Unmounts the one that is in.
  void Leave();
  // Whether something of it can be taken; one that holds nothing may still get a backup or a support file.
  bool HoldsSomething() const;
  // An empty one gives way to the next, and is not tried again either.
  void Try(const std::string& device);

  std::filesystem::path at_;
  // The mounted one, as "sdb1"; empty: none.
  std::string device_;
  bool holds_something_ = false;
  // Devices that are not tried again while they are in, and why the last of them could not be mounted.
  std::vector<std::string> refused_;
  Error fault_{};
  std::optional<StickMount> mount_;
};

}  // namespace kaori::shows
