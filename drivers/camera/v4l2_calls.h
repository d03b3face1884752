// The system calls that a V4L2 camera needs: the kernel's, or those of a fake camera in tests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "drivers/base/unique_fd.h"

namespace kaori::camera {

// As the system calls of the same names: on failure they return -1 or null, and set errno. No call
// blocks, but for STREAMON and S_FMT of slow webcams: tenths of a second. One thread.
class V4l2Calls {
 public:
  // The kernel's calls have no state; a test's camera has.
  virtual ~V4l2Calls() = default;
  // Non-blocking; invalid on failure.
  virtual UniqueFd Open(const std::string& path) = 0;
  // Repeats a call that a signal interrupted. `argument` is the struct that
  // the request names (videodev2.h).
  virtual int Ioctl(int fd, unsigned long request, void* argument) = 0;
  // Maps a buffer for reading, at the offset that QUERYBUF gave.
  virtual std::uint8_t* Map(int fd, std::size_t bytes, std::uint32_t offset) = 0;
  virtual void Unmap(std::uint8_t* memory, std::size_t bytes) = 0;
};

// The kernel's calls; they live as long as the program, and have no state.
V4l2Calls& KernelCalls();

}  // namespace kaori::camera
