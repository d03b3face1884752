// What is sent in reply, as libmicrohttpd holds it: a text, or a file.
#pragma once

#include <string>
#include <string_view>

#include "drivers/base/unique_fd.h"

struct MHD_Response;

namespace kaori::web {

// Both are the caller's, to be queued and destroyed; null when memory is short. One thread.

// The text is copied.
MHD_Response* TextResponse(std::string_view text);

// All of a regular file, read while it is sent, which a browser saves under this name: it has neither quotes nor line ends. Null too
// where the file cannot be looked at. Sending blocks for the disk.
MHD_Response* FileResponse(UniqueFd file, const std::string& name);

}  // namespace kaori::web
