// A camera through the kernel's V4L2, with memory-mapped buffers.
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

// As ports::Camera. A frame keeps its buffer until the next call of Next; every other buffer is with the
// kernel, queued to be filled. The stream is V4L2's memory-mapped kind (linux/Documentation:
// media/v4l/mmap.html): nothing is copied. Format and rate do not change while it is open. One thread.
class V4l2Camera final : public ports::Camera {
 public:
  // Opens the device node, sets the format, maps the buffers and starts the stream. Blocks while the
  // camera answers: some tenths of a second. `clock` and `calls` must outlive the camera. Errors:
  //   no_such_device           there is no such node, or the camera was unplugged
  //   permission_denied        the node may not be opened
  //   device_or_resource_busy  another program streams from the camera
  //   not_supported            no video capture with streaming, or no format that we read
  //   no_space_on_device       the USB bus has not room for so many frames
  //   io_error                 any other failure of the kernel's
  static Result<std::unique_ptr<V4l2Camera>> Open(const std::string& path, const V4l2Preferences& preferences,
                                                  const Clock& clock, V4l2Calls& calls = KernelCalls());
  V4l2Camera(const V4l2Camera&) = delete;
  V4l2Camera& operator=(const V4l2Camera&) = delete;
  // Stops the stream and unmaps the buffers: frames that were given are gone.
  ~V4l2Camera() override;

  int pollable() const override { return fd_.get(); }
  // Gives the newest whole frame, as the port says. A stream without a frame for V4l2Preferences::stall
  // counts as broken (io_error). Such a camera does not become readable: Next must be called now and then
  // too. Also io_error: the camera reports another input signal, whose size is not the negotiated one.
  Result<ports::CameraFrame> Next() override;

  // The mode that the camera accepted, and its layout.
  const V4l2Format& format() const { return format_; }

 private:
  // A mapped buffer.
  struct Buffer {
    std::uint8_t* memory = nullptr;
    // Of the mapping; a frame may be shorter.
    std::size_t bytes = 0;
  };
  // A buffer with a whole frame.
  struct Filled {
    std::uint32_t index = 0;
    std::uint32_t bytes = 0;
    std::uint32_t sequence = 0;
    // When it was exposed, as StampOf reads it.
    Time at{};
  };
  V4l2Camera(std::string path, const V4l2Preferences& preferences, const Clock& clock, V4l2Calls& calls);
  // Maps and queues the buffers, and starts the stream. Errors: those of Open.
  Result<void> Start();
  // Requests the buffers; the kernel may give more or fewer than were asked for.
  Result<void> MapBuffers();
  // Maps one buffer of the kernel for reading, until the camera ends. Errors: as Open.
  Result<void> MapBuffer(std::uint32_t index);
  // Queues a buffer for the kernel to fill. Errors: as Next.
  Result<void> GiveBack(std::uint32_t index);
  // Queues the frame that the caller has read, if any.
  Result<void> GiveBackHeld();
  // The oldest buffer that is filled; none waits. Errors: as Next.
  Result<std::optional<v4l2_buffer>> Dequeue();
  // Makes the buffer the one that Next will give, and queues the one before it.
  Result<void> KeepNewest(const v4l2_buffer& dequeued);
  // Keeps the newest whole frame of those that wait. At most as many as there are buffers.
  Result<void> DrainAll(bool& torn);
  // Long enough, within its buffer, and without the driver's error flag.
  bool is_whole(const v4l2_buffer& dequeued) const;
  // Whether the kernel reported another input signal.
  bool HasSourceChanged();
  // The kernel's stamp where it is monotonic, else now.
  Time StampOf(const v4l2_buffer& dequeued) const;
  // Ends the stream: every later call says the same.
  tl::unexpected<Error> Broken(int error, const char* verb);

  std::string path_;
  V4l2Preferences preferences_;
  const Clock& clock_;
  V4l2Calls& calls_;
  UniqueFd fd_;
  V4l2Format format_;
  std::vector<Buffer> buffers_;
  std::optional<Filled> held_;  // The frame that the caller reads.
  std::optional<Error> broken_;
  Time newest_{};  // When the last frame came, or the stream started.
  // The driver reports another input signal by an event.
  bool watches_source_ = false;
};

}  // namespace kaori::camera
