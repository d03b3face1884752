#include "drivers/camera/v4l2_camera.h"

#include <linux/videodev2.h>

#include <algorithm>
#include <utility>

#include "drivers/base/open_cause.h"

namespace kaori::camera {
namespace {

using ports::CameraFrame;

// One that the caller reads, one being filled, two for a busy moment.
constexpr std::uint32_t kBuffers = 4;
constexpr std::uint32_t kMostBuffers = 32;  // V4L2's own limit.

// A request about one buffer, as every ioctl on buffers wants it. The type and the memory say which
// queue is meant; the kernel fills in the rest.
v4l2_buffer BufferRequest(std::uint32_t index) {
  v4l2_buffer buffer{};
  buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  buffer.memory = V4L2_MEMORY_MMAP;
  buffer.index = index;
  return buffer;
}

}  // namespace

Result<std::unique_ptr<V4l2Camera>> V4l2Camera::Open(const std::string& path,
                                                     const V4l2Preferences& preferences, const Clock& clock,
                                                     V4l2Calls& calls) {
  std::unique_ptr<V4l2Camera> camera(new V4l2Camera(path, preferences, clock, calls));
  camera->fd_ = calls.Open(path);
  if (!camera->fd_.valid()) return Fail(CauseOfOpen(errno), "open " + path);
  auto format = Negotiate(calls, camera->fd_.get(), preferences);
  if (!format) return FailAs(format.error(), path + ": " + format.error().attempt);
  camera->format_ = *format;
  if (auto ok = camera->Start(); !ok) return tl::unexpected(ok.error());
  return camera;
}

V4l2Camera::V4l2Camera(std::string path, const V4l2Preferences& preferences, const Clock& clock,
                       V4l2Calls& calls)
    : path_(std::move(path)), preferences_(preferences), clock_(clock), calls_(calls) {}

V4l2Camera::~V4l2Camera() {
  int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  // Ends the stream before the memory goes: the hardware writes into it.
  if (!buffers_.empty()) calls_.Ioctl(fd_.get(), VIDIOC_STREAMOFF, &type);
  for (const Buffer& buffer : buffers_) calls_.Unmap(buffer.memory, buffer.bytes);
}

// The time of the start counts as that of a frame, so that a camera which never sends one is found hung as
// well.
Result<void> V4l2Camera::Start() {
  if (auto ok = MapBuffers(); !ok) return ok;
  // All buffers are queued before the stream starts: some drivers refuse STREAMON without any.
  for (std::uint32_t n = 0; n < buffers_.size(); ++n)
    if (auto ok = GiveBack(n); !ok) return ok;
  v4l2_event_subscription source{};
  source.type = V4L2_EVENT_SOURCE_CHANGE;
  // Few cameras have the event; those without refuse the subscription.
  watches_source_ = calls_.Ioctl(fd_.get(), VIDIOC_SUBSCRIBE_EVENT, &source) == 0;
  int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  if (calls_.Ioctl(fd_.get(), VIDIOC_STREAMON, &type) < 0) return Broken(errno, "start the stream of ");
  newest_ = clock_.now();
  return {};
}

Result<void> V4l2Camera::MapBuffers() {
  v4l2_requestbuffers request{};
  request.count = kBuffers;
  request.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  request.memory = V4L2_MEMORY_MMAP;
  if (calls_.Ioctl(fd_.get(), VIDIOC_REQBUFS, &request) < 0)
    return Fail(CauseOfOpen(errno), "request buffers of " + path_);
  // One buffer alone is with the caller or with the kernel: half of the frames would be lost.
  if (request.count < 2) return Fail(std::errc::io_error, "get two buffers of " + path_);
  for (std::uint32_t n = 0; n < std::min(request.count, kMostBuffers); ++n)
    if (auto ok = MapBuffer(n); !ok) return ok;
  return {};
}

Result<void> V4l2Camera::MapBuffer(std::uint32_t index) {
  v4l2_buffer request = BufferRequest(index);
  if (calls_.Ioctl(fd_.get(), VIDIOC_QUERYBUF, &request) < 0) return Broken(errno, "query a buffer of ");
  std::uint8_t* memory = calls_.Map(fd_.get(), request.length, request.m.offset);
  if (memory == nullptr) return Broken(errno, "map a buffer of ");
  buffers_.push_back({memory, request.length});
  return {};
}

Result<CameraFrame> V4l2Camera::Next() {
  if (broken_) return tl::unexpected(*broken_);
  if (auto ok = GiveBackHeld(); !ok) return tl::unexpected(ok.error());
  bool torn = false;
  if (auto ok = DrainAll(torn); !ok) return tl::unexpected(ok.error());
  // Frames after it have another size than was negotiated.
  if (HasSourceChanged()) return Broken(EIO, "keep the format of ");
  // A torn frame shows that the stream is alive.
  if (held_ || torn) newest_ = clock_.now();
  if (!held_ && torn) return Fail(std::errc::bad_message, "read a whole frame of " + path_);
  if (!held_ && clock_.now() - newest_ > preferences_.stall) return Broken(EIO, "wait any longer for ");
  if (!held_) return Fail(std::errc::resource_unavailable_try_again, "read " + path_);
  return CameraFrame{.at = held_->at,
                     .sequence = held_->sequence,
                     .format = format_.format(),
                     .stride_bytes = format_.stride_bytes,
                     .bytes = {buffers_[held_->index].memory, held_->bytes}};
}

// Dequeues all buffers that are filled and keeps the newest whole one; `torn` tells that a
// damaged one was dropped. As many turns as there are buffers: each can be filled once
// more while the others are looked at.
Result<void> V4l2Camera::DrainAll(bool& torn) {
  for (std::size_t n = 0; n <= buffers_.size(); ++n) {
    const auto dequeued = Dequeue();
    if (!dequeued) return tl::unexpected(dequeued.error());
    if (!*dequeued) return {};
    const bool whole = is_whole(**dequeued);
    torn = torn || !whole;
    if (auto ok = whole ? KeepNewest(**dequeued) : GiveBack((*dequeued)->index); !ok) return ok;
  }
  return {};
}

// Nothing: no filled buffer waits. An index that we have not mapped would be read from foreign memory.
Result<std::optional<v4l2_buffer>> V4l2Camera::Dequeue() {
  v4l2_buffer dequeued = BufferRequest(0);
  if (calls_.Ioctl(fd_.get(), VIDIOC_DQBUF, &dequeued) < 0) {
    if (errno == EAGAIN) return std::nullopt;
    // EIO also stands for a corrupted frame in some drivers, but those go on after a new opening as well.
    return Broken(errno, "read ");
  }
  if (dequeued.index >= buffers_.size()) return Broken(EIO, "read a known buffer of ");
  return dequeued;
}

bool V4l2Camera::is_whole(const v4l2_buffer& dequeued) const {
  // bytesused comes from the driver, and is checked against the mapping before anybody reads by it.
  const bool fits = dequeued.bytesused > 0 && dequeued.bytesused <= buffers_[dequeued.index].bytes;
  return fits && (dequeued.flags & V4L2_BUF_FLAG_ERROR) == 0 && dequeued.bytesused >= format_.frame_bytes;
}

Result<void> V4l2Camera::KeepNewest(const v4l2_buffer& dequeued) {
  if (auto ok = GiveBackHeld(); !ok) return ok;
  held_ = Filled{dequeued.index, dequeued.bytesused, dequeued.sequence, StampOf(dequeued)};
  return {};
}

// The stamp is that of the exposure's start or of the frame's end, as the driver has it
// (V4L2_BUF_FLAG_TSTAMP_SRC_MASK); its microseconds become nanoseconds.
Time V4l2Camera::StampOf(const v4l2_buffer& dequeued) const {
  const bool monotonic = (dequeued.flags & V4L2_BUF_FLAG_TIMESTAMP_MASK) == V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC;
  // Some drivers stamp with the time of day, or not at all.
  if (!monotonic) return clock_.now();
  return Time{} + std::chrono::seconds(dequeued.timestamp.tv_sec) +
         std::chrono::microseconds(dequeued.timestamp.tv_usec);
}

Result<void> V4l2Camera::GiveBackHeld() {
  if (!held_) return {};
  return GiveBack(std::exchange(held_, std::nullopt)->index);
}

Result<void> V4l2Camera::GiveBack(std::uint32_t index) {
  v4l2_buffer request = BufferRequest(index);
  if (calls_.Ioctl(fd_.get(), VIDIOC_QBUF, &request) < 0) return Broken(errno, "give a buffer back to ");
  return {};
}

// HDMI grabbers report a new input signal; webcams have no such event.
bool V4l2Camera::HasSourceChanged() {
  v4l2_event event{};
  return watches_source_ && calls_.Ioctl(fd_.get(), VIDIOC_DQEVENT, &event) == 0 &&
         event.type == V4L2_EVENT_SOURCE_CHANGE;
}

// The first failure is kept, and every later call gives it: a stream does not go on after one. `verb` begins
// the sentence that the path ends.
tl::unexpected<Error> V4l2Camera::Broken(int error, const char* verb) {
  const bool gone = error == ENODEV || error == ENXIO;
  // Another program streams already (VIDIOC_REQBUFS, VIDIOC_STREAMON).
  const bool busy = error == EBUSY;
  // The USB bus has not room for so many frames: no alternate setting of the
  // interface fits what is left of it.
  const bool narrow = error == ENOSPC;
  const auto cause = gone     ? std::errc::no_such_device
                     : busy   ? std::errc::device_or_resource_busy
                     : narrow ? std::errc::no_space_on_device
                              : std::errc::io_error;
  held_.reset();
  broken_ = Error{cause, verb + path_};
  return tl::unexpected(*broken_);
}

}  // namespace kaori::camera
