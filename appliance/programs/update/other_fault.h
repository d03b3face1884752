// Why the disk's other system is to be tried: this one can play no show, never shows a face, or cannot be operated since its disk is
// spoilt.
#pragma once

#include <filesystem>
#include <string>

#include "drivers/base/clock.h"

namespace kaori::update {

// Where it is seen.
struct FaultPlaces {
  // The stage makes it where it can read no show, with the reason, and takes it away when it has read one after all.
  std::filesystem::path no_show;
  // Of the programs; on it stands how many frames were shown since the machine started.
  std::string board;
  // The service manager's own program, which knows how often the stage was started anew.
  std::string systemctl;
  // The journal's, which has the kernel's log.
  std::string journalctl = "/bin/journalctl";
};

// The reason in one line, English; empty: there is none now. A stage that never showed a frame in this start of the machine and
// ended at least twice is one, as where a bit of it is spoilt on the disk; one that waits for a screen does not end. Where it does
// show frames, input or lips that ended at least twice and do not run on at `now` are one too, but only beside a block that failed its
// hash. Blocks for the file system, systemctl, and the journal.
std::string FaultOfSystem(const FaultPlaces& places, Time now);

// Blocks until one has stood for LastingFault::kLasts without a break, and gives it. Whoever starts this bounds its time.
std::string AwaitLastingFault(const FaultPlaces& places);

}  // namespace kaori::update
