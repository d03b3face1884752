// Unix sockets that carry a stream of bytes, as QEMU's monitors and serial lines do.
#pragma once

#include <string>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori {

// Connects to a listening socket; does not wait. The result is close-on-exec and non-blocking, so that
// its reader waits in the loop or with poll(2). Errors: filename_too_long (sun_path holds 107 bytes),
// those of connect(2): no_such_file_or_directory, connection_refused (its owner died).
Result<UniqueFd> ConnectToStream(const std::string& path);

}  // namespace kaori
