// Calls into drivers that may block for seconds: the watchdog is told of each, and none is repeated at once.
#pragma once

#include <algorithm>

#include "drivers/base/clock.h"

namespace kaori {

// To be called before a device is opened, reset or closed: a program that waits for the kernel then must not look
// like one that hangs. USB gives an answer 5 s of time, also one that another call waits for on the same device,
// and raw MIDI gives what is still to be sent 10 s. Also before a file is written that has to be safe on the disk. Does
// nothing where no manager watches; a failure is one line in the log. Any thread.
void ExpectLongCall();

// To be called before a piece is read from a stick or a disk, or written to one and waited for until it is safe there: the
// kernel tries a block that it cannot read for minutes, and a slow stick takes as long for what is still in memory. Threads
// and failures as above.
void ExpectSlowDisk();

// To be called before something that the caller knows to take no longer than `longest`. Threads and failures as above.
void ExpectLongCall(Duration longest);

// The pause before a call that failed and took so long is made again: `least`, or what leaves twenty parts of the
// time to everything else. It counts from the end of the call. Pure.
inline Duration PauseAfter(Duration took, Duration least) {
  constexpr int kOthersShare = 20;
  return std::max(least, kOthersShare * took);
}

}  // namespace kaori
