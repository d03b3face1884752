#include "drivers/camera/v4l2_calls.h"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/mman.h>

#include <cerrno>

namespace kaori::camera {
namespace {

// The kernel itself. Holds nothing, so that one object serves all cameras.
class Kernel final : public V4l2Calls {
 public:
  // Non-blocking: VIDIOC_DQBUF then says EAGAIN where no frame is done, instead of waiting for one.
  UniqueFd Open(const std::string& path) override {
    return UniqueFd(::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC));
  }
  // A signal may break an ioctl off before it has done anything: it is asked again.
  int Ioctl(int fd, unsigned long request, void* argument) override {
    int result = 0;
    do result = ::ioctl(fd, request, argument);
    while (result < 0 && errno == EINTR);
    return result;
  }
  // videobuf2 in the kernel accepts shared maps only, and wants a capture queue's to be
  // readable; nothing is ever written into frames.
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
