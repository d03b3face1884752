#include "drivers/camera/libcamera/libcamera_device.h"

#include <sys/mman.h>

#include <algorithm>
#include <cerrno>

#include <libcamera/formats.h>

namespace kaori::camera {
namespace {

namespace controls = libcamera::controls;
using ports::CameraFormat;
using ports::PixelFormat;

std::optional<PixelFormat> PixelsOf(const libcamera::PixelFormat& format) {
  if (format == libcamera::formats::YUYV) return PixelFormat::kYuyv;
  if (format == libcamera::formats::NV12) return PixelFormat::kNv12;
  if (format == libcamera::formats::MJPEG) return PixelFormat::kMjpeg;
  return std::nullopt;
}

libcamera::PixelFormat FormatOf(PixelFormat pixels) {
  if (pixels == PixelFormat::kYuyv) return libcamera::formats::YUYV;
  return pixels == PixelFormat::kNv12 ? libcamera::formats::NV12 : libcamera::formats::MJPEG;
}

// A pipeline that scales lists no sizes: the smallest one that is good for lips is requested of it.
std::vector<CameraFormat> FormatsOf(const libcamera::StreamFormats& formats) {
  std::vector<CameraFormat> found;
  for (const auto& format : formats.pixelformats()) {
    const auto pixels = PixelsOf(format);
    if (!pixels) continue;
    auto sizes = formats.sizes(format);
    const auto range = formats.range(format);
    if (range.hStep != 0)
      sizes.push_back(libcamera::Size(320, 240).expandedTo(range.min).boundedTo(range.max));
    for (const auto& size : sizes)
      found.push_back({static_cast<int>(size.width), static_cast<int>(size.height), *pixels});
  }
  return found;
}

// libcamera's calls give negated errno values: EBUSY of a camera that another program has acquired, ENODEV of
// one that was unplugged, EACCES of one that is not in a state for the call.
std::errc CauseOf(int result) {
  if (result == -EBUSY) return std::errc::device_or_resource_busy;
  return result == -ENODEV || result == -EACCES ? std::errc::no_such_device : std::errc::io_error;
}

bool Has(const libcamera::ControlInfoMap& map, const libcamera::ControlId& control) {
  return map.find(control.id()) != map.end();
}

// libcamera 0.0.3 leaves the focus alone.
std::vector<std::string> LacksOf(const libcamera::ControlInfoMap& has) {
  std::vector<std::string> lacks;
  if (!Has(has, controls::AeEnable)) lacks.emplace_back("exposure");
  if (!Has(has, controls::AwbEnable)) lacks.emplace_back("white balance");
  lacks.emplace_back("focus");
  return lacks;
}

}  // namespace

// On libcamera's thread, with each completed request. A value that the metadata lack keeps what was found
// before.
void LibcameraHold::Note(const libcamera::ControlList& metadata) {
  const std::lock_guard lock(mutex_);
  if (const auto exposure = metadata.get(controls::ExposureTime)) found_.exposure_us = *exposure;
  if (const auto gain = metadata.get(controls::AnalogueGain)) found_.gain = *gain;
  if (const auto gains = metadata.get(controls::ColourGains))
    found_.colour_gains = {{(*gains)[0], (*gains)[1]}};
}

// Holds what the frames so far told: a camera that has delivered none yet keeps its own start values. The
// count makes the next request carry the controls.
void LibcameraHold::Set(ports::CameraHold hold) {
  const std::lock_guard lock(mutex_);
  held_.reset();
  if (hold == ports::CameraHold::kHeld) held_ = found_;
  ++changes_;
}

bool LibcameraHold::holds() const {
  const std::lock_guard lock(mutex_);
  return held_.has_value();
}

// Controls that the camera has not are left out. While nothing is held it chooses by itself.
void LibcameraHold::Write(const libcamera::ControlInfoMap& has, libcamera::ControlList& list) const {
  const std::lock_guard lock(mutex_);
  if (Has(has, controls::AeEnable)) list.set(controls::AeEnable, !held_);
  if (Has(has, controls::AwbEnable)) list.set(controls::AwbEnable, !held_);
  if (!held_) return;
  if (held_->exposure_us && Has(has, controls::ExposureTime))
    list.set(controls::ExposureTime, *held_->exposure_us);
  if (held_->gain && Has(has, controls::AnalogueGain)) list.set(controls::AnalogueGain, *held_->gain);
  if (held_->colour_gains && Has(has, controls::ColourGains))
    list.set(controls::ColourGains, {(*held_->colour_gains)[0], (*held_->colour_gains)[1]});
}

// The steps follow libcamera's states of a camera: available, acquired, configured, running. What a failed
// step leaves behind the destructor gives back.
Result<std::unique_ptr<LibcameraDevice>> LibcameraDevice::Open(std::shared_ptr<libcamera::Camera> camera,
                                                               const LibcameraPreferences& preferences) {
  std::unique_ptr<LibcameraDevice> device(new LibcameraDevice(std::move(camera), preferences.hold));
  device->stream_.name = device->camera_->id();
  if (const int result = device->camera_->acquire(); result < 0)
    return Fail(CauseOf(result), "acquire " + device->stream_.name);
  device->acquired_ = true;
  if (auto ok = device->Configure(); !ok) return tl::unexpected(ok.error());
  if (auto ok = device->MapBuffers(); !ok) return tl::unexpected(ok.error());
  if (auto ok = device->Start(preferences.rung); !ok) return tl::unexpected(ok.error());
  return device;
}

LibcameraDevice::~LibcameraDevice() {
  // Returns once the library's thread has completed or cancelled every
  // request: nothing calls us after it.
  if (streams_) camera_->stop();
  camera_->requestCompleted.disconnect();
  camera_->disconnected.disconnect();
  // Requests refer to the buffers, and these to the allocator: the order of the following lines.
  requests_.clear();
  for (const auto& memory : memory_)
    if (!memory.empty()) ::munmap(const_cast<std::uint8_t*>(memory.data()), memory.size());
  allocator_.reset();
  configuration_.reset();
  if (acquired_) camera_->release();
}

// Of libcamera's roles Viewfinder is that of live pictures: a moderate size at the full rate.
Result<void> LibcameraDevice::Configure() {
  configuration_ = camera_->generateConfiguration({libcamera::StreamRole::Viewfinder});
  if (!configuration_ || configuration_->empty())
    return Fail(std::errc::not_supported, "find a stream of " + stream_.name);
  libcamera::StreamConfiguration& stream = configuration_->at(0);
  const auto chosen = ChooseFormat(FormatsOf(stream.formats()));
  if (!chosen) return Fail(std::errc::not_supported, "find YUYV, NV12 or MJPEG in " + stream_.name);
  stream.pixelFormat = FormatOf(chosen->pixels);
  stream.size = {static_cast<unsigned>(chosen->width_px), static_cast<unsigned>(chosen->height_px)};
  // validate() may change the stream to what the pipeline can do; `Adjusted` is as good as `Valid`.
  const bool invalid = configuration_->validate() == libcamera::CameraConfiguration::Invalid;
  const auto pixels = PixelsOf(stream.pixelFormat);
  if (invalid || !pixels)
    return Fail(std::errc::not_supported, "have a format that we read from " + stream_.name);
  if (const int result = camera_->configure(configuration_.get()); result < 0)
    return Fail(CauseOf(result), "configure " + stream_.name);
  stream_.format = {static_cast<int>(stream.size.width), static_cast<int>(stream.size.height), *pixels};
  if (*pixels == PixelFormat::kMjpeg) return {};
  stream_.stride_bytes = stream.stride;
  // NV12 has 12 bits for each pixel and YUYV 16; the stride of YUYV counts its 2 bytes already.
  stream_.frame_bytes = stream.stride * stream.size.height * (*pixels == PixelFormat::kNv12 ? 3 : 2) / 2;
  return {};
}

// A request is made for each buffer, for good; its cookie is the number of the buffer.
Result<void> LibcameraDevice::MapBuffers() {
  libcamera::Stream* stream = configuration_->at(0).stream();
  allocator_ = std::make_unique<libcamera::FrameBufferAllocator>(camera_);
  if (const int result = allocator_->allocate(stream); result < 0)
    return Fail(CauseOf(result), "get buffers of " + stream_.name);
  for (const auto& buffer : allocator_->buffers(stream)) {
    auto request = camera_->createRequest(requests_.size());
    if (!request || request->addBuffer(stream, buffer.get()) < 0)
      return Fail(std::errc::io_error, "make a request to " + stream_.name);
    if (auto ok = MapBuffer(static_cast<std::uint32_t>(requests_.size()), *buffer); !ok) return ok;
    requests_.push_back(std::move(request));
    fresh_.push_back(true);
  }
  return {};
}

// Planes lie behind one another in one piece of memory from offset 0, as the frame's
// reader wants them and mmap needs it.
Result<void> LibcameraDevice::MapBuffer(std::uint32_t index, libcamera::FrameBuffer& buffer) {
  std::size_t end = 0;
  for (const auto& plane : buffer.planes()) {
    const bool follows = plane.fd == buffer.planes()[0].fd && plane.offset == end;
    if (!follows) return Fail(std::errc::not_supported, "use the scattered planes of " + stream_.name);
    end = plane.offset + plane.length;
  }
  void* memory = ::mmap(nullptr, end, PROT_READ, MAP_SHARED, buffer.planes()[0].fd.get(), 0);
  if (memory == MAP_FAILED) return Fail(std::errc::io_error, "map a buffer of " + stream_.name);
  memory_.resize(index + 1);
  memory_[index] = {static_cast<const std::uint8_t*>(memory), end};
  return {};
}

// A rung beyond those that the sensor has means its fastest rate.
Result<void> LibcameraDevice::Start(std::size_t rung) {
  const libcamera::ControlInfoMap& has = camera_->controls();
  libcamera::ControlList list(has);
  if (const auto times = has.find(controls::FrameDurationLimits.id()); times != has.end()) {
    times_ = {times->second.min().get<std::int64_t>(), times->second.max().get<std::int64_t>()};
    frame_us_ = FrameTimeOf(times_, rung).value_or(times_.shortest_us);
    // Equal limits fix the rate: between two limits the exposure would choose.
    list.set(controls::FrameDurationLimits, {frame_us_, frame_us_});
  }
  lacks_ = LacksOf(has);
  written_ = hold_.changes();
  hold_.Write(has, list);
  camera_->requestCompleted.connect(this, [this](libcamera::Request* request) { HandleCompleted(request); });
  camera_->disconnected.connect(this, [this] { completions_.Disconnect(); });
  if (const int result = camera_->start(&list); result < 0)
    return Fail(CauseOf(result), "start " + stream_.name);
  streams_ = true;
  return {};
}

// Held values go with the first request after they changed, and stay in the camera from then on.
Result<void> LibcameraDevice::Queue(std::uint32_t buffer) {
  libcamera::Request& request = *requests_[buffer];
  // A request that was completed must be reset before it is queued again; a new one must not.
  if (!fresh_[buffer]) request.reuse(libcamera::Request::ReuseBuffers);
  fresh_[buffer] = false;
  if (written_ != hold_.changes()) hold_.Write(camera_->controls(), request.controls());
  written_ = hold_.changes();
  const int result = camera_->queueRequest(&request);
  if (result < 0) return Fail(CauseOf(result), "queue a request to " + stream_.name);
  return {};
}

// In the library's thread. Drivers stamp frames by the monotonic clock, as V4L2 does: it is that of Time.
void LibcameraDevice::HandleCompleted(libcamera::Request* request) {
  if (request->status() == libcamera::Request::RequestCancelled) return;  // The stream ends.
  hold_.Note(request->metadata());
  const libcamera::FrameMetadata& frame = request->buffers().begin()->second->metadata();
  std::uint32_t bytes = 0;
  for (const auto& plane : frame.planes()) bytes += plane.bytesused;
  completions_.Add({.buffer = static_cast<std::uint32_t>(request->cookie()),
                    .whole = frame.status == libcamera::FrameMetadata::FrameSuccess,
                    .bytes = bytes,
                    .sequence = frame.sequence,
                    .at = Time{} + std::chrono::nanoseconds(frame.timestamp)});
}

}  // namespace kaori::camera
