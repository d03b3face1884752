// The system calls by which a V4L2 camera is used: the kernel's, or a test's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "drivers/base/unique_fd.h"

namespace kaori::camera {

// As the system calls of the same names: failures are -1 or null, with errno set. No call blocks.
class V4l2Calls {
 public:
  virtual ~V4l2Calls() = default;
  virtual UniqueFd Open(const std::string& path) = 0;  // Non-blocking; invalid on failure.
  virtual int Ioctl(int fd, unsigned long request, void* argument) = 0;
  virtual std::uint8_t* Map(int fd, std::size_t bytes, std::uint32_t offset) = 0;
  virtual void Unmap(std::uint8_t* memory, std::size_t bytes) = 0;
};

// The kernel's; lives as long as the program.
V4l2Calls& KernelCalls();

}  // namespace kaori::camera
