// Unix sockets that carry a stream of bytes, as a virtual machine speaks them.
#pragma once

#include <string>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori {

// Close-on-exec, and never blocks. Errors: filename_too_long (sun_path holds 107 bytes), those of connect.
Result<UniqueFd> ConnectToStream(const std::string& path);

}  // namespace kaori
