// A camera through the kernel's V4L2: memory-mapped, never waiting, the newest frame only.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/unique_fd.h"
#include "drivers/camera/v4l2_calls.h"
#include "drivers/camera/v4l2_format.h"
#include "drivers/ports/camera.h"

struct v4l2_buffer;

namespace kaori::camera {

// As ports::Camera. A frame keeps its buffer until the next Next; every other buffer is with the kernel.
// After no_such_device or io_error every later call says the same: destroy it and open anew.
class V4l2Camera final : public ports::Camera {
 public:
  // Opens, sets the format, maps the buffers and starts the stream. Borrows `clock` and `calls` for its life.
  // Errors: no_such_device, permission_denied, device_or_resource_busy, not_supported, io_error,
  // no_space_on_device (the USB bus has not room for so many frames).
  static Result<std::unique_ptr<V4l2Camera>> Open(const std::string& path, const V4l2Wish& wish,
                                                  const Clock& clock, V4l2Calls& calls = KernelCalls());
  V4l2Camera(const V4l2Camera&) = delete;
  V4l2Camera& operator=(const V4l2Camera&) = delete;
  ~V4l2Camera() override;

  int pollable() const override { return fd_.get(); }
  // Beside the port's: a stream without a frame for V4l2Wish::stall is an io_error; ask now and then, since a
  // stalled camera does not become readable.
  Result<ports::CameraFrame> Next() override;

  const V4l2Format& format() const { return format_; }

 private:
  struct Buffer {
    std::uint8_t* memory = nullptr;
    std::size_t bytes = 0;
  };
  struct Filled {
    std::uint32_t index = 0;
    std::uint32_t bytes = 0;
    std::uint32_t sequence = 0;
    Time at{};
  };
  V4l2Camera(std::string path, const V4l2Wish& wish, const Clock& clock, V4l2Calls& calls);
  Result<void> Start();
  Result<void> MapBuffers();
  Result<void> MapBuffer(std::uint32_t index);
  Result<void> GiveBack(std::uint32_t index);
  Result<void> GiveBackHeld();
  Result<std::optional<v4l2_buffer>> Dequeue();
  Result<void> KeepNewest(const v4l2_buffer& taken);
  Result<void> DrainAll(bool& torn);
  bool is_whole(const v4l2_buffer& taken) const;
  bool HasSourceChanged();
  Time StampOf(const v4l2_buffer& taken) const;
  tl::unexpected<Error> Broken(int error, const char* verb);

  std::string path_;
  V4l2Wish wish_;
  const Clock& clock_;
  V4l2Calls& calls_;
  UniqueFd fd_;
  V4l2Format format_;
  std::vector<Buffer> buffers_;
  std::optional<Filled> held_;  // The frame that the caller looks at.
  std::optional<Error> broken_;
  Time newest_{};  // When the last frame came, or the stream started.
  bool watches_source_ = false;
};

}  // namespace kaori::camera
