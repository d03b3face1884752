// Why a device's node could not be opened.
#pragma once

#include <cerrno>
#include <system_error>

namespace kaori {

// Of open(2)'s errno. A node that vanished between its listing and its opening is no fault, but a device that
// was pulled: no_such_device. EPERM is said as permission_denied.
inline std::errc CauseOfOpen(int error) {
  const bool pulled = error == ENOENT || error == ENXIO || error == ENODEV || error == EIO;
  return pulled ? std::errc::no_such_device : static_cast<std::errc>(error == EPERM ? EACCES : error);
}

}  // namespace kaori
