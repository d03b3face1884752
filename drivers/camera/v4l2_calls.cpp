#include "drivers/camera/v4l2_calls.h"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/mman.h>

#include <cerrno>

namespace kaori::camera {
namespace {

class Kernel final : public V4l2Calls {
 public:
  UniqueFd Open(const std::string& path) override {
    return UniqueFd(::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC));
  }
  int Ioctl(int fd, unsigned long request, void* argument) override {
    int result = 0;
    do result = ::ioctl(fd, request, argument);
    while (result < 0 && errno == EINTR);
    return result;
  }
  std::uint8_t* Map(int fd, std::size_t bytes, std::uint32_t offset) override {
    void* memory = ::mmap(nullptr, bytes, PROT_READ, MAP_SHARED, fd, static_cast<off_t>(offset));
    return memory == MAP_FAILED ? nullptr : static_cast<std::uint8_t*>(memory);
  }
  void Unmap(std::uint8_t* memory, std::size_t bytes) override { ::munmap(memory, bytes); }
};

}  // namespace

V4l2Calls& KernelCalls() {
  static Kernel kernel;
  return kernel;
}

}  // namespace kaori::camera
