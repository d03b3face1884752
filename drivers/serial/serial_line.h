// Opens a serial line of the kernel.
#pragma once

#include <string>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::serial {

// Opens `path` raw at 9600 8N1, for this program alone, without waiting for a carrier; reads and writes do
// not block. What waited in the line is dropped. An adapter that gathers bytes is asked not to: FTDI's holds
// them back for 16 ms, which is longer than a message may take. Errors:
//   no_such_file_or_directory, no_such_device   there is no such line, or its adapter was pulled
//   permission_denied                           it may not be opened
//   device_or_resource_busy                     another program has it for itself
//   inappropriate_io_control_operation          it is no serial line
Result<UniqueFd> OpenSerialLine(const std::string& path);

}  // namespace kaori::serial
