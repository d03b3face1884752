#include "drivers/camera/libcamera/request_camera.h"

#include <sys/eventfd.h>

#include <utility>

namespace kaori::camera {

using ports::CameraFrame;

Completions::Completions() : wake_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {}

void Completions::Add(const CompletedRequest& request) {
  const std::lock_guard lock(mutex_);
  waiting_.push_back(request);
  Wake();
}

void Completions::Disconnect() {
  const std::lock_guard lock(mutex_);
  disconnected_ = true;
  Wake();
}

// Called by the reader's thread; Add and Disconnect come from the library's.
std::vector<CompletedRequest> Completions::DrainAll() {
  const std::lock_guard lock(mutex_);
  // Under the lock: a completion between the two would wake nobody.
  eventfd_t told = 0;
  ::eventfd_read(wake_.get(), &told);
  if (disconnected_) Wake();  // Stays readable: it is gone.
  return std::exchange(waiting_, {});
}

bool Completions::disconnected() const {
  const std::lock_guard lock(mutex_);
  return disconnected_;
}

void Completions::Wake() const {
  ::eventfd_write(wake_.get(), 1);
}

// All buffers go to the device at once, which fills them in turn.
Result<std::unique_ptr<RequestCamera>> RequestCamera::Start(std::unique_ptr<RequestDevice> device,
                                                            const RequestStream& stream, const Clock& clock) {
  std::unique_ptr<RequestCamera> camera(new RequestCamera(std::move(device), stream, clock));
  for (std::uint32_t n = 0; n < camera->device_->buffers(); ++n)
    if (auto ok = camera->Queue(n); !ok) return tl::unexpected(ok.error());
  return camera;
}

RequestCamera::RequestCamera(std::unique_ptr<RequestDevice> device, const RequestStream& stream,
                             const Clock& clock)
    : device_(std::move(device)), stream_(stream), clock_(clock), newest_(clock.now()) {}

// The frame that was given last goes back first: its memory is the device's again from here on. Of several
// that wait the newest whole one is given; those before it were never looked at.
Result<CameraFrame> RequestCamera::Next() {
  if (broken_) return tl::unexpected(*broken_);
  if (auto ok = GiveBackHeld(); !ok) return tl::unexpected(ok.error());
  bool torn = false;
  for (const CompletedRequest& request : device_->completions().DrainAll()) {
    const bool whole = is_whole(request);
    torn = torn || !whole;
    if (auto ok = whole ? GiveBackHeld() : Queue(request.buffer); !ok) return tl::unexpected(ok.error());
    if (whole) held_ = request;
  }
  if (device_->completions().disconnected()) return Broken(std::errc::no_such_device, "read ");
  // A torn frame shows that the stream is alive.
  if (held_ || torn) newest_ = clock_.now();
  if (!held_ && torn) return Fail(std::errc::bad_message, "read a whole frame of " + stream_.name);
  if (!held_ && clock_.now() - newest_ > stream_.stall)
    return Broken(std::errc::io_error, "wait any longer for ");
  if (!held_) return Fail(std::errc::resource_unavailable_try_again, "read " + stream_.name);
  return CameraFrame{.at = held_->at,
                     .sequence = held_->sequence,
                     .format = stream_.format,
                     .stride_bytes = stream_.stride_bytes,
                     .bytes = device_->memory(held_->buffer).first(held_->bytes)};
}

bool RequestCamera::is_whole(const CompletedRequest& request) const {
  return request.whole && request.bytes > 0 && request.bytes >= stream_.frame_bytes &&
         request.bytes <= device_->memory(request.buffer).size();
}

Result<void> RequestCamera::GiveBackHeld() {
  if (!held_) return {};
  return Queue(std::exchange(held_, std::nullopt)->buffer);
}

Result<void> RequestCamera::Queue(std::uint32_t buffer) {
  if (auto ok = device_->Queue(buffer); !ok) return Broken(ok.error().cause, "give a buffer back to ");
  return {};
}

// What is broken stays so: whoever wants the camera opens it anew.
tl::unexpected<Error> RequestCamera::Broken(std::errc cause, const char* verb) {
  held_.reset();
  broken_ = Error{cause, verb + stream_.name};
  return tl::unexpected(*broken_);
}

}  // namespace kaori::camera
