// How the two processes of kaori-boot tell each other how far they have come.
#pragma once

#include <optional>

#include "drivers/base/unique_fd.h"

namespace kaori::boot {

// Two ends by which one process tells another that it has come so far: it closes `write_end`. A process that
// dies closes its ends too, so that nobody waits for it. After a fork each side closes the end that is not its own.
struct Pipe {
  UniqueFd read_end, write_end;
};

// Closed on exec, so that systemd inherits neither end. Nothing where the kernel has no pipe left.
std::optional<Pipe> MakePipe();

// Returns when every copy of the other end is closed, or after `longest_ms`: the start of the box waits for
// nothing without a limit.
void AwaitClose(const UniqueFd& read_end, int longest_ms);

}  // namespace kaori::boot
