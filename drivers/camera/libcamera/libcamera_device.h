// One camera of libcamera that streams: its buffers, mapped, and its requests.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include <libcamera/libcamera.h>

#include "drivers/camera/libcamera/libcamera_choice.h"
#include "drivers/camera/libcamera/request_camera.h"
#include "drivers/ports/camera_tuning.h"

namespace kaori::camera {

// What the camera finds by itself, and what a show holds, over all
// of its openings. Any thread: libcamera calls Note in its own.
class LibcameraHold {
 public:
  void Note(const libcamera::ControlList& metadata);
  void Set(ports::CameraHold hold);

  // Adds to `list` the controls that are to be set, of those that the camera has.
  void Write(const libcamera::ControlInfoMap& has, libcamera::ControlList& list) const;
  int changes() const { return changes_; }  // Calls of Set.

 private:
  struct Values {
    std::optional<std::int32_t> exposure_us;
    std::optional<float> gain;
    std::optional<std::array<float, 2>> colour_gains;  // Red, blue.
  };
  mutable std::mutex mutex_;
  Values found_;
  std::optional<Values> held_;  // None: free.
  int changes_ = 0;
};

struct LibcameraPreferences {
  std::size_t rung = 0;  // As in FrameTimeOf.
  LibcameraHold& hold;   // Must outlive the device.
};

class LibcameraDevice final : public RequestDevice {
 public:
  // Acquires `camera`, configures and starts it. Errors: no_such_device, device_or_resource_busy,
  // not_supported, io_error.
  static Result<std::unique_ptr<LibcameraDevice>> Open(std::shared_ptr<libcamera::Camera> camera,
                                                       const LibcameraPreferences& preferences);
  LibcameraDevice(const LibcameraDevice&) = delete;
  LibcameraDevice& operator=(const LibcameraDevice&) = delete;
  ~LibcameraDevice() override;

  Completions& completions() override { return completions_; }
  std::uint32_t buffers() const override { return static_cast<std::uint32_t>(requests_.size()); }
  std::span<const std::uint8_t> memory(std::uint32_t buffer) const override { return memory_[buffer]; }
  Result<void> Queue(std::uint32_t buffer) override;

  const RequestStream& stream() const { return stream_; }
  double rate_hz() const { return frame_us_ > 0 ? 1e6 / static_cast<double>(frame_us_) : 0; }
  const FrameTimes& times() const { return times_; }
  std::vector<std::string> lacks() const { return lacks_; }  // Names, for people, of what cannot be held.

 private:
  LibcameraDevice(std::shared_ptr<libcamera::Camera> camera, LibcameraHold& hold)
      : camera_(std::move(camera)), hold_(hold) {}
  // The steps of Open, in this order.
  Result<void> Configure();
  Result<void> MapBuffers();
  Result<void> MapBuffer(std::uint32_t index, libcamera::FrameBuffer& buffer);
  Result<void> Start(std::size_t rung);
  void HandleCompleted(libcamera::Request* request);  // In the library's thread.

  std::shared_ptr<libcamera::Camera> camera_;
  LibcameraHold& hold_;
  int written_ = 0;  // LibcameraHold::changes() when the camera's controls were set last.
  bool acquired_ = false;
  bool streams_ = false;
  std::unique_ptr<libcamera::CameraConfiguration> configuration_;
  std::unique_ptr<libcamera::FrameBufferAllocator> allocator_;
  std::vector<std::unique_ptr<libcamera::Request>> requests_;
  // The mapped bytes of each buffer, with the requests' indices.
  std::vector<std::span<const std::uint8_t>> memory_;
  std::vector<bool> fresh_;  // Requests that were never queued.
  RequestStream stream_;
  FrameTimes times_;
  std::int64_t frame_us_ = 0;
  Completions completions_;
  std::vector<std::string> lacks_;
};

}  // namespace kaori::camera
