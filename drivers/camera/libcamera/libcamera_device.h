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

// What the camera finds by itself, and what a show holds, over all of its openings. Any thread:
// libcamera calls Note in its own. No call blocks for longer than another one copies some numbers.
class LibcameraHold {
 public:
  // Keeps what the camera has found, from the metadata of a completed request. In the library's thread.
  void Note(const libcamera::ControlList& metadata);
  // Holds what was noted last, or frees the automatics; counts for the
  // requests that are queued afterwards.
  void Set(ports::CameraHold hold);
  bool holds() const;

  // Adds to `list` the controls that are to be set, of those that the camera has.
  void Write(const libcamera::ControlInfoMap& has, libcamera::ControlList& list) const;
  // Calls of Set so far. A device compares it with its own count to see whether
  // controls are to be sent again.
  int changes() const { return changes_; }

 private:
  // Of the controls that can be held; none where the camera has not told one.
  struct Values {
    std::optional<std::int32_t> exposure_us;
    std::optional<float> gain;
    std::optional<std::array<float, 2>> colour_gains;  // Red, blue.
  };
  // Over all that is below it but the count.
  mutable std::mutex mutex_;
  // What the newest request told; controls that it left out keep what an earlier one told.
  Values found_;
  std::optional<Values> held_;  // None: free.
  // Calls of Set so far.
  int changes_ = 0;
};

// How a device is opened; the hold outlives all of its openings.
struct LibcameraPreferences {
  std::size_t rung = 0;  // As in FrameTimeOf.
  LibcameraHold& hold;   // Must outlive the device.
};

// One opened camera of libcamera. The library completes requests in a thread of its own; HandleCompleted
// passes them to the loop's thread by `completions_` and touches nothing else that changes while
// streaming. All other calls come from one thread.
class LibcameraDevice final : public RequestDevice {
 public:
  // Acquires `camera`, configures and starts it. Blocks while the sensor answers: some tenths of a
  // second. No request is queued yet. Errors:
  //   no_such_device           the camera was unplugged, or may not be opened
  //   device_or_resource_busy  another program has acquired it
  //   not_supported            it has no format that we read, or scatters its planes
  //   io_error                 any other failure of the library
  static Result<std::unique_ptr<LibcameraDevice>> Open(std::shared_ptr<libcamera::Camera> camera,
                                                       const LibcameraPreferences& preferences);
  LibcameraDevice(const LibcameraDevice&) = delete;
  LibcameraDevice& operator=(const LibcameraDevice&) = delete;
  // Stops the stream first, so that no completion comes after it, and releases the camera.
  ~LibcameraDevice() override;

  Completions& completions() override { return completions_; }
  std::uint32_t buffers() const override { return static_cast<std::uint32_t>(requests_.size()); }
  // Mapped for reading, and valid as long as the device.
  std::span<const std::uint8_t> memory(std::uint32_t buffer) const override { return memory_[buffer]; }
  // Also sends the controls where they changed since the last request. Errors:
  // those of RequestDevice::Queue.
  Result<void> Queue(std::uint32_t buffer) override;

  // As the camera has set it, which may be another format than was chosen.
  const RequestStream& stream() const { return stream_; }
  // Frames in a second; 0 where the camera keeps a rate of its own.
  double rate_hz() const { return frame_us_ > 0 ? 1e6 / static_cast<double>(frame_us_) : 0; }
  // Both 0 where the camera lets nobody choose its rate.
  const FrameTimes& times() const { return times_; }
  // Names, for people, of what cannot be held.
  std::vector<std::string> lacks() const { return lacks_; }

 private:
  LibcameraDevice(std::shared_ptr<libcamera::Camera> camera, LibcameraHold& hold)
      : camera_(std::move(camera)), hold_(hold) {}
  // The steps of Open, in this order.
  Result<void> Configure();
  Result<void> MapBuffers();
  // Maps the planes of one buffer, which must lie behind one another. Errors: as Open.
  Result<void> MapBuffer(std::uint32_t index, libcamera::FrameBuffer& buffer);
  // Sets rate and controls and starts the stream. Errors: as Open.
  Result<void> Start(std::size_t rung);
  void HandleCompleted(libcamera::Request* request);  // In the library's thread.

  // Shared with the library, as its interface wants it.
  std::shared_ptr<libcamera::Camera> camera_;
  LibcameraHold& hold_;
  int written_ = 0;  // LibcameraHold::changes() when the camera's controls were set last.
  // The destructor gives back what was acquired, and stops what streams.
  bool acquired_ = false;
  bool streams_ = false;
  // Refers to the camera; its first stream is the one that is used.
  std::unique_ptr<libcamera::CameraConfiguration> configuration_;
  // Owns the buffers of the stream.
  std::unique_ptr<libcamera::FrameBufferAllocator> allocator_;
  // One for each buffer, and with its number.
  std::vector<std::unique_ptr<libcamera::Request>> requests_;
  // The mapped bytes of each buffer, with the requests' indices.
  std::vector<std::span<const std::uint8_t>> memory_;
  std::vector<bool> fresh_;  // Requests that were never queued.
  // What is told of every frame.
  RequestStream stream_;
  FrameTimes times_;
  // From frame to frame, as it was set; 0 where the camera keeps a rate of its own.
  std::int64_t frame_us_ = 0;
  Completions completions_;
  // Found at the start of the stream.
  std::vector<std::string> lacks_;
};

}  // namespace kaori::camera
