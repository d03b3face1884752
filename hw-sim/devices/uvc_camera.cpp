#include "hw-sim/devices/uvc_camera.h"

#include <algorithm>
#include <array>

#include "hw-sim/devices/usb_requests.h"
#include "hw-sim/devices/uvc_descriptors.h"

namespace kaori::sim {
namespace {

constexpr std::uint16_t kCameraVendor = 0x1209,
                        kCameraProduct = 0x0005;  // A pid.codes test id: for development only.

// Whom the standard request is for that Linux sends to a bulk endpoint when it ends a stream.
constexpr std::uint8_t kToEndpoint = 0x02;
constexpr std::uint8_t kSetCur = 0x01, kGetLen = 0x85, kGetInfo = 0x86;
// wIndex and the high byte of wValue of the two controls (UVC 1.1, 4.3.1).
constexpr std::uint8_t kStreamingInterface = 1, kProbeControl = 1, kCommitControl = 2;
// GET_INFO's answer: the control can be read and set (UVC 1.1, table 4-3).
constexpr std::uint8_t kCanGetAndSet = 3;

// Payload headers (UVC 1.1, 2.4.3.3): length, then bits for frame id, end of frame and end of header.
// There are no time stamps, so a host stamps frames when they arrive.
constexpr std::size_t kHeaderBytes = 2;
constexpr std::uint8_t kEndOfHeader = 0x80, kEndOfFrame = 0x02;

UvcMode ModeOf(const LipCamera& camera, Duration period) {
  UvcMode mode;
  mode.width_px = static_cast<std::uint16_t>(camera.format().width_px);
  mode.height_px = static_cast<std::uint16_t>(camera.format().height_px);
  mode.period_100ns = static_cast<std::uint32_t>(period.count() / 100);
  mode.payload_bytes = UvcCamera::kPayloadBytes;
  mode.endpoint = UvcCamera::kIn;
  return mode;
}

// Cuts a frame into payloads, each behind its header.
void Cut(std::span<const std::uint8_t> frame, bool parity, UsbBytes& into) {
  into.clear();
  while (!frame.empty()) {
    const auto part = frame.first(std::min(frame.size(), UvcCamera::kPayloadBytes - kHeaderBytes));
    frame = frame.subspan(part.size());
    into.push_back(kHeaderBytes);
    into.push_back(
        static_cast<std::uint8_t>(kEndOfHeader | (parity ? 1 : 0) | (frame.empty() ? kEndOfFrame : 0)));
    into.insert(into.end(), part.begin(), part.end());
  }
}

}  // namespace

UvcCamera::UvcCamera(LipCamera& camera, Duration period) : camera_(camera), period_(period) {
  // Class EF, subclass 2, protocol 1: interfaces that belong together say so by an association (USB
  // ECN on interface association descriptors).
  descriptors_.device_class = 0xEF;
  descriptors_.device_subclass = 0x02;
  descriptors_.device_protocol = 0x01;
  descriptors_.vendor = kCameraVendor;
  descriptors_.product = kCameraProduct;
  descriptors_.maker = "Kaori";
  descriptors_.name = "Simulated lip camera";
  descriptors_.configuration = UvcConfiguration(ModeOf(camera, period));
  picture_.resize(camera.frame_bytes());
}

std::optional<UsbBytes> UvcCamera::Answer(const UsbSetup& setup, std::span<const std::uint8_t>) {
  // The stream ended: the next read begins a new one.
  if (setup.type == kToEndpoint && setup.request == kClearFeature) return EndStream(), UsbBytes{};
  const auto control = static_cast<std::uint8_t>(setup.value >> 8);
  const bool ours =
      (setup.index & 0xFF) == kStreamingInterface && (control == kProbeControl || control == kCommitControl);
  if (!ours) return std::nullopt;
  // Whatever is asked for, the camera has one mode; the host reads it back by GET_CUR and uses it.
  if (setup.type == kClassToInterface && setup.request == kSetCur) return UsbBytes{};
  if (setup.type != kClassFromInterface) return std::nullopt;
  const UsbBytes probe = UvcProbe(ModeOf(camera_, period_));
  if (setup.request == kGetInfo) return UsbBytes{kCanGetAndSet};
  if (setup.request == kGetLen) return UsbBytes{static_cast<std::uint8_t>(probe.size()), 0};
  return probe;
}

std::optional<Time> UvcCamera::next_due(Time now) const {
  if (sent_ < payloads_.size() || ends_full_) return now;
  if (camera_.stalled()) return std::nullopt;
  return began_ ? *began_ + (last_ + 1) * period_ : now;
}

// The newest frame that has been exposed; those that nobody fetched in time were never sent.
bool UvcCamera::BeginFrame(Time now) {
  if (camera_.stalled()) return false;
  if (!began_) began_ = now;
  const std::int64_t number = (now - *began_) / period_;
  if (number <= last_) return false;
  last_ = number;
  const std::size_t bytes = camera_.Shoot(static_cast<std::uint32_t>(number), picture_);
  parity_ = !parity_;
  Cut(std::span(picture_).first(bytes), parity_, payloads_);
  sent_ = 0;
  ++frames_begun_;
  return true;
}

std::optional<UsbBytes> UvcCamera::NextIn(std::uint8_t endpoint, std::size_t room_bytes, Time now) {
  if (endpoint != kIn || room_bytes == 0) return std::nullopt;
  if (std::exchange(ends_full_, false)) return UsbBytes{};
  if (sent_ == payloads_.size() && !BeginFrame(now)) return std::nullopt;
  // A payload ends at each multiple of kPayloadBytes, and at the end of the
  // frame: one transfer carries no two.
  const std::size_t payload_ends = std::min((sent_ / kPayloadBytes + 1) * kPayloadBytes, payloads_.size());
  const std::size_t bytes = std::min(room_bytes, payload_ends - sent_);
  const auto from = payloads_.begin() + static_cast<std::ptrdiff_t>(sent_);
  UsbBytes transfer(from, from + static_cast<std::ptrdiff_t>(bytes));
  sent_ += bytes;
  // A transfer that fills the host's room does not end by being short. At the full length of a
  // payload the host knows the end without.
  ends_full_ = sent_ == payloads_.size() && bytes == room_bytes && sent_ % kPayloadBytes != 0;
  return transfer;
}

void UvcCamera::EndStream() {
  payloads_.clear();
  sent_ = 0;
  ends_full_ = false;
  began_.reset();
  last_ = -1;
}

}  // namespace kaori::sim
