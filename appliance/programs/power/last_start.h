// Why the box's last start ended: a clean stop, the watchdog, or the power.
#pragma once

#include <filesystem>
#include <string>

#include "drivers/base/result.h"

namespace kaori::power {

// What stands in the kernel's folders; a test gives its own.
struct MachinePaths {
  // Another text at each start of the kernel.
  std::filesystem::path boot_id = "/proc/sys/kernel/random/boot_id";
  // Each watchdog's folder has a file "bootstatus": the decimal bits of linux/watchdog.h, why the machine was reset.
  std::filesystem::path watchdogs = "/sys/class/watchdog";
};

// A small file on the data partition that says of the newest start whether it was stopped. A start whose file says
// that it runs ended without a word. One thread; its functions block for the disk.
class LastStart {
 public:
  LastStart(std::filesystem::path file, MachinePaths machine)
      : file_(std::move(file)), machine_(std::move(machine)) {}

  // Says how the start before this one ended, in one line, and notes that this one runs. Empty where this start is
  // noted already, because the program was started anew. A file that cannot be read is that of no start.
  // Errors: those of reading the boot id and of writing the file, after which nothing is noted.
  Result<std::string> Begin();

  // Notes that this start is being stopped. Errors: as Begin.
  Result<void> NoteStop();

 private:
  Result<void> Write(const char* state);
  // Whether a watchdog of the machine says that it has reset it.
  bool WasResetByWatchdog() const;

  std::filesystem::path file_;
  MachinePaths machine_;
};

}  // namespace kaori::power
