// The system calls that a V4L2 camera needs: the kernel's, or those of a fake camera in tests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "drivers/base/unique_fd.h"

namespace kaori::camera {

// As the system calls of the same names: on failure they return -1 or null, and set errno. No call blocks.
class V4l2Calls {
 public:
  virtual ~V4l2Calls() = default;
  virtual UniqueFd Open(const std::string& path) = 0;  // Non-blocking; invalid on failure.
  virtual int Ioctl(int fd, unsigned long request, void* argument) = 0;
  virtual std::uint8_t* Map(int fd, std::size_t bytes, std::uint32_t offset) = 0;
  virtual void Unmap(std::uint8_t* memory, std::size_t bytes) = 0;
};

// The kernel's calls; they live as long as the program.
V4l2Calls& KernelCalls();

}  // namespace kaori::camera
