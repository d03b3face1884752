// Finds a stick among the machine's block devices and mounts it, so that its files can be read and nothing
// else.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "drivers/base/result.h"

namespace kaori::shows {

// The names, as in "sdb1", of what a USB stick offers to be mounted: its partitions, or the whole of one
// without any. `blocks` is the kernel's list of block devices, /sys/class/block. Disks that are not on USB
// are never among them, nor is the one from which the box started.
std::vector<std::string> FindSticks(const std::filesystem::path& blocks);

// Mounts on construction and unmounts when it goes; with the process its mount goes in any case, since the
// unit has a mount namespace of its own.
class StickMount {
 public:
  // Read-only, nothing on it can be run, has rights or is a device. `device` is a block device with FAT or
  // exFAT. Errors: invalid_argument (no such file system), no_such_device, operation_not_permitted.
  static Result<StickMount> Make(const std::string& device, const std::filesystem::path& at);
  // Lets files be written, or not any more, in the same place. What was written is on the stick when it
  // returns. Errors: those of mount(2): permission_denied (the stick's own switch), device_or_resource_busy,
  // no_such_device.
  Result<void> SetWritable(bool writable);
  StickMount(StickMount&& other) noexcept;
  StickMount& operator=(StickMount&&) = delete;
  ~StickMount();

 private:
  explicit StickMount(std::filesystem::path at) : at_(std::move(at)) {}
  // Where the stick is mounted. One that was pulled stays mounted until this goes, and every read of it
  // fails.
  // Empty: moved away.
  std::filesystem::path at_;
};

}  // namespace kaori::shows
