// A camera by requests, as libcamera has them: buffers are queued, and are completed in another thread.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/unique_fd.h"
#include "drivers/ports/camera.h"

namespace kaori::camera {

// A request that the library has completed.
struct CompletedRequest {
  // The number of its buffer on the device.
  std::uint32_t buffer = 0;
  bool whole = false;  // Filled without a fault.
  // How many bytes of the buffer were filled.
  std::uint32_t bytes = 0;
  // Of the frame, as the camera counts: gaps are frames that were lost before us.
  std::uint32_t sequence = 0;
  // The library's stamp, on CLOCK_MONOTONIC.
  Time at{};
};

// Where requests pass from the library's thread to ours; nothing else is shared. Stamps and indices
// are copied, pixels stay in their buffers.
class Completions {
 public:
  Completions();

  // The library's side; any thread. Disconnect: the camera was unplugged.
  // Neither waits for the other side; each makes the descriptor readable.
  void Add(const CompletedRequest& request);
  void Disconnect();

  // Our side; one thread. pollable() is readable when a request
  // was completed, and for ever once the camera is gone.
  int pollable() const { return wake_.get(); }
  // All requests that were completed since the last call, the oldest first.
  std::vector<CompletedRequest> DrainAll();
  // Whether the camera was unplugged; it stays so.
  bool disconnected() const;

 private:
  // Makes the descriptor readable. With the mutex held.
  void Wake() const;

  // Over the two below it.
  mutable std::mutex mutex_;
  std::vector<CompletedRequest> waiting_;
  // For good.
  bool disconnected_ = false;
  // An eventfd; its count says nothing, only that there is something.
  UniqueFd wake_;
};

// One streaming camera of a library. Its destructor ends the stream; nothing is
// completed after it. One thread, but for its completions. Buffers are numbered from 0
// and mapped for as long as the device lives.
class RequestDevice {
 public:
  // Ends the stream: no buffer is touched by the hardware afterwards.
  virtual ~RequestDevice() = default;
  // Lives as long as the device.
  virtual Completions& completions() = 0;
  // How many there are; does not change.
  virtual std::uint32_t buffers() const = 0;
  // The mapped bytes of a buffer. They belong to the library while it is queued.
  virtual std::span<const std::uint8_t> memory(std::uint32_t buffer) const = 0;
  // Queues the buffer for the next frame. Errors: no_such_device, io_error.
  virtual Result<void> Queue(std::uint32_t buffer) = 0;
};

// What the frames of a device look like, and when it counts as broken.
struct RequestStream {
  std::string name;  // For errors.
  ports::CameraFormat format;
  std::uint32_t stride_bytes = 0;                    // 0 for MJPEG.
  std::uint32_t frame_bytes = 0;                     // A whole uncompressed frame; 0 for MJPEG.
  Duration stall = std::chrono::milliseconds(1000);  // A stream without a frame for so long is broken.
};

// As ports::Camera, for libraries in which requests carry the buffers. A frame keeps its buffer until
// the next call of Next; every other buffer is with the library. One thread.
class RequestCamera final : public ports::Camera {
 public:
  // Queues every buffer. `clock` must outlive the camera. Errors: those of RequestDevice::Queue.
  static Result<std::unique_ptr<RequestCamera>> Start(std::unique_ptr<RequestDevice> device,
                                                      const RequestStream& stream, const Clock& clock);

  int pollable() const override { return device_->completions().pollable(); }
  Result<ports::CameraFrame> Next() override;

 private:
  RequestCamera(std::unique_ptr<RequestDevice> device, const RequestStream& stream, const Clock& clock);
  // Queues a buffer with the library; its failure ends the stream.
  Result<void> Queue(std::uint32_t buffer);
  // Queues the held frame's buffer again, if there is one. Errors: as Queue.
  Result<void> GiveBackHeld();
  // Whether the request has a frame of the stream's length, within its buffer.
  bool is_whole(const CompletedRequest& request) const;
  // Keeps the error for all later calls, and returns it.
  tl::unexpected<Error> Broken(std::errc cause, const char* verb);

  // Ends after everything that borrows its memory.
  std::unique_ptr<RequestDevice> device_;
  RequestStream stream_;
  // Of the stall alone; frames have the library's stamps.
  const Clock& clock_;
  // The frame that the caller reads.
  std::optional<CompletedRequest> held_;
  // What every call says once the stream has ended.
  std::optional<Error> broken_;
  // When the last frame came, or the stream started.
  Time newest_;
};

}  // namespace kaori::camera
