// Unix sockets that carry a stream of bytes, as QEMU's monitors and serial lines do.
#pragma once

#include <string>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori {

// Connects to a listening socket; the result is close-on-exec and non-blocking. Errors: filename_too_long (sun_path
// holds 107 bytes), those of connect(2).
Result<UniqueFd> ConnectToStream(const std::string& path);

}  // namespace kaori
