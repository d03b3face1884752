// A fake V4L2 camera: it answers the system calls, and does what a test tells it to.
#pragma once

#include <linux/videodev2.h>
#include <sys/eventfd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "drivers/camera/v4l2_calls.h"

namespace kaori::tests {

struct OfferedFormat {
  std::uint32_t fourcc = V4L2_PIX_FMT_YUYV;
  std::uint32_t rate_hz = 30;
  std::uint32_t width_px = 640;
  std::uint32_t height_px = 480;
};

class FakeV4l2 final : public camera::V4l2Calls {
 public:
  static constexpr std::uint32_t kBufferBytes = 640 * 480 * 2;

  // The camera's side: what it is.
  std::vector<OfferedFormat> offers = {{V4L2_PIX_FMT_YUYV, 30}};
  std::optional<OfferedFormat> gives;              // Whatever is asked.
  std::map<std::uint32_t, std::int32_t> controls;  // Those that it has.
  std::set<std::uint32_t> stubborn;                // Those that it refuses to set.
  std::uint32_t narrow_above_hz = 0;  // The cable has not room for more frames a second; 0: it has.
  std::string model = "A camera";
  std::uint32_t capabilities = V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING;
  int open_error = 0;
  int failing_error = 0;              // Every call fails with it, when not 0.
  unsigned long failing_request = 0;  // Only this one, when not 0.
  bool source_changed = false;

  // The camera's side: what happens. False when it has no free buffer and drops the frame.
  bool Expose(std::uint8_t grey, Time at, std::uint32_t bytes = kBufferBytes, std::uint32_t flags = 0) {
    const std::vector<std::uint8_t> picture(kBufferBytes, grey);
    return ExposePicture(picture, at, bytes, flags);
  }
  bool ExposePicture(std::span<const std::uint8_t> picture, Time at, std::uint32_t bytes,
                     std::uint32_t flags = 0) {
    ++sequence_;
    if (queued_.empty()) return false;
    v4l2_buffer filled{};
    filled.index = queued_.front();
    queued_.pop_front();
    filled.bytesused = bytes;
    filled.flags = flags | V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC;
    filled.sequence = sequence_ - 1;
    const auto us = std::chrono::duration_cast<std::chrono::microseconds>(at.time_since_epoch()).count();
    filled.timestamp = {us / 1000000, us % 1000000};
    std::ranges::copy(picture.first(std::min(picture.size(), memory_[filled.index].size())),
                      memory_[filled.index].begin());
    filled_.push_back(filled);
    return true;
  }

  // What a test may look at.
  const OfferedFormat& chosen() const { return chosen_; }
  std::uint32_t rate_hz() const { return rate_hz_; }
  std::size_t free_buffers() const { return queued_.size(); }
  std::size_t mapped() const { return mapped_.size(); }
  int opened() const { return opened_; }

  UniqueFd Open(const std::string&) override {
    ++opened_;
    errno = open_error;
    return open_error != 0 ? UniqueFd() : UniqueFd(::eventfd(0, EFD_CLOEXEC));
  }
  std::uint8_t* Map(int, std::size_t, std::uint32_t offset) override {
    memory_[offset].assign(kBufferBytes, 0);
    mapped_.insert(offset);
    return memory_[offset].data();
  }
  void Unmap(std::uint8_t* memory, std::size_t) override {
    for (std::uint32_t n = 0; n < memory_.size(); ++n)
      if (memory_[n].data() == memory) mapped_.erase(n);
  }
  int Ioctl(int, unsigned long request, void* argument) override {
    const bool fails = failing_error != 0 && (failing_request == 0 || failing_request == request);
    return fails ? Refuse(failing_error) : Answer(request, argument);
  }

 private:
  static int Refuse(int error) {
    errno = error;
    return -1;
  }
  int Answer(unsigned long request, void* argument) {
    switch (request) {
      case VIDIOC_QUERYCAP:
        return TellWhatItIs(*static_cast<v4l2_capability*>(argument));
      case VIDIOC_ENUM_FMT:
        return TellFormat(*static_cast<v4l2_fmtdesc*>(argument));
      case VIDIOC_ENUM_FRAMESIZES:
        return TellSize(*static_cast<v4l2_frmsizeenum*>(argument));
      case VIDIOC_ENUM_FRAMEINTERVALS:
        return TellRate(*static_cast<v4l2_frmivalenum*>(argument));
      case VIDIOC_QUERYCTRL:
        return controls.contains(static_cast<v4l2_queryctrl*>(argument)->id) ? 0 : Refuse(EINVAL);
      case VIDIOC_G_CTRL:
        return ReadControl(*static_cast<v4l2_control*>(argument));
      case VIDIOC_S_CTRL:
        return WriteControl(*static_cast<const v4l2_control*>(argument));
      case VIDIOC_S_FMT:
        return SetFormat(static_cast<v4l2_format*>(argument)->fmt.pix);
      case VIDIOC_REQBUFS:
        static_cast<v4l2_requestbuffers*>(argument)->count = 4;
        return 0;
      case VIDIOC_QUERYBUF:
        return Describe(*static_cast<v4l2_buffer*>(argument));
      case VIDIOC_QBUF:
        queued_.push_back(static_cast<v4l2_buffer*>(argument)->index);
        return 0;
      case VIDIOC_DQBUF:
        return Dequeue(*static_cast<v4l2_buffer*>(argument));
      case VIDIOC_DQEVENT:
        return TellEvent(*static_cast<v4l2_event*>(argument));
      case VIDIOC_STREAMOFF:
        queued_.clear();
        filled_.clear();
        return 0;
      case VIDIOC_STREAMON:
        return narrow_above_hz > 0 && rate_hz_ > narrow_above_hz ? Refuse(ENOSPC) : 0;
      case VIDIOC_S_PARM:
        return SetRate(static_cast<v4l2_streamparm*>(argument)->parm.capture.timeperframe);
      case VIDIOC_SUBSCRIBE_EVENT:
        return 0;
      default:
        return Refuse(ENOTTY);
    }
  }
  int TellWhatItIs(v4l2_capability& capability) const {
    capability.capabilities = capabilities;
    std::ranges::copy(model, capability.card);
    return 0;
  }
  // The n-th of the offers that `is_one` picks; each value of `of` once.
  template <class Test, class Of>
  const OfferedFormat* Nth(std::uint32_t n, const Test& is_one, const Of& of) const {
    std::vector<const OfferedFormat*> found;
    for (const OfferedFormat& offer : offers) {
      const bool known = std::ranges::any_of(found, [&](const auto* one) { return of(*one) == of(offer); });
      if (is_one(offer) && !known) found.push_back(&offer);
    }
    return n < found.size() ? found[n] : nullptr;
  }
  int TellFormat(v4l2_fmtdesc& entry) const {
    const auto* offer = Nth(
        entry.index, [](const auto&) { return true; }, [](const auto& o) { return o.fourcc; });
    if (offer == nullptr) return Refuse(EINVAL);
    entry.pixelformat = offer->fourcc;
    return 0;
  }
  int TellSize(v4l2_frmsizeenum& entry) const {
    const auto* offer = Nth(
        entry.index, [&](const auto& o) { return o.fourcc == entry.pixel_format; },
        [](const auto& o) { return std::pair(o.width_px, o.height_px); });
    if (offer == nullptr) return Refuse(EINVAL);
    entry.type = V4L2_FRMSIZE_TYPE_DISCRETE;
    entry.discrete = {offer->width_px, offer->height_px};
    return 0;
  }
  int TellRate(v4l2_frmivalenum& entry) const {
    const auto* offer = Nth(
        entry.index,
        [&](const auto& o) {
          return o.fourcc == entry.pixel_format && o.width_px == entry.width && o.height_px == entry.height;
        },
        [](const auto& o) { return o.rate_hz; });
    if (offer == nullptr) return Refuse(EINVAL);
    entry.type = V4L2_FRMIVAL_TYPE_DISCRETE;
    entry.discrete = {1, offer->rate_hz};
    return 0;
  }
  int SetFormat(v4l2_pix_format& format) {
    chosen_ = gives.value_or(OfferedFormat{format.pixelformat, 0, format.width, format.height});
    format.pixelformat = chosen_.fourcc;
    format.width = chosen_.width_px;
    format.height = chosen_.height_px;
    format.bytesperline = chosen_.fourcc == V4L2_PIX_FMT_YUYV ? format.width * 2 : format.width;
    return 0;
  }
  int SetRate(v4l2_fract& interval) {
    if (gives) interval = {1, gives->rate_hz};
    rate_hz_ = interval.denominator / interval.numerator;
    return 0;
  }
  int ReadControl(v4l2_control& control) const {
    const auto it = controls.find(control.id);
    if (it == controls.end()) return Refuse(EINVAL);
    control.value = it->second;
    return 0;
  }
  // While an automatic is on, its values cannot be set, as in a webcam.
  int WriteControl(const v4l2_control& control) {
    const auto it = controls.find(control.id);
    if (it == controls.end()) return Refuse(EINVAL);
    if (stubborn.contains(control.id)) return Refuse(EIO);
    const bool busy = control.id == V4L2_CID_EXPOSURE_ABSOLUTE && controls.contains(V4L2_CID_EXPOSURE_AUTO) &&
                      controls.at(V4L2_CID_EXPOSURE_AUTO) != V4L2_EXPOSURE_MANUAL;
    if (busy) return Refuse(EACCES);
    it->second = control.value;
    return 0;
  }
  int Describe(v4l2_buffer& buffer) const {
    buffer.length = kBufferBytes;
    buffer.m.offset = buffer.index;
    return 0;
  }
  int Dequeue(v4l2_buffer& buffer) {
    if (filled_.empty()) return Refuse(EAGAIN);
    buffer = filled_.front();
    filled_.pop_front();
    return 0;
  }
  int TellEvent(v4l2_event& event) {
    if (!std::exchange(source_changed, false)) return Refuse(ENOENT);
    event.type = V4L2_EVENT_SOURCE_CHANGE;
    return 0;
  }

  OfferedFormat chosen_{0, 0, 0, 0};
  std::uint32_t rate_hz_ = 0;
  std::uint32_t sequence_ = 0;
  int opened_ = 0;
  std::deque<std::uint32_t> queued_;
  std::deque<v4l2_buffer> filled_;
  std::array<std::vector<std::uint8_t>, 4> memory_;
  std::set<std::uint32_t> mapped_;
};

}  // namespace kaori::tests
