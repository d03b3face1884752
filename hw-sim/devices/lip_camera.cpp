#include "hw-sim/devices/lip_camera.h"

#include <algorithm>
#include <cmath>

#include "hw-sim/devices/lip_picture.h"
#include "hw-sim/devices/picture_formats.h"

namespace kaori::sim {
namespace {

// Larger frames would only cost time: lips are measured at 320 to 1280 pixels.
constexpr int kMostWidth = 1920;
constexpr int kMostHeight = 1080;
constexpr std::uint8_t kDarkLuma = 19;  // Less 3 of noise is black.
// Cb and Cr without colour.
constexpr std::uint8_t kGrey = 128;

// Two columns share their colour in YUYV, and two rows as well in NV12.
bool CanShoot(const ports::CameraFormat& format) {
  return format.width_px >= 2 && format.width_px <= kMostWidth && format.width_px % 2 == 0 &&
         format.height_px >= 2 && format.height_px <= kMostHeight && format.height_px % 2 == 0;
}

std::size_t YuyvBytes(const ports::CameraFormat& format) {
  return static_cast<std::size_t>(format.width_px) * static_cast<std::size_t>(format.height_px) * 2;
}

// A number that is none leaves things as they are.
double Held(double value, double low, double high, double otherwise) {
  return std::isnan(value) ? otherwise : std::clamp(value, low, high);
}

}  // namespace

LipCamera::LipCamera(ports::CameraFormat format, const DeviceContext& context) : context_(context) {
  if (!CanShoot(format)) format = {640, 480, ports::PixelFormat::kYuyv};
  SetFormat(format);
}

void LipCamera::SetMouth(double height, double width) {
  const Mouth mouth{Held(height, 0.02, 2, mouth_.height), Held(width, 0.1, 2, mouth_.width)};
  if (mouth == mouth_) return;
  mouth_ = mouth;
  context_.Notify({DevicePort::kCamera, Verb::kLips, 0, mouth.height, mouth.width});
}

void LipCamera::CoverLens(bool covered) {
  if (std::exchange(covered_, covered) != covered)
    context_.Notify({DevicePort::kCamera, Verb::kCoverLens, covered ? 1 : 0, 0, 0});
}

void LipCamera::Stall(bool stalled) {
  if (std::exchange(stalled_, stalled) != stalled)
    context_.Notify({DevicePort::kCamera, Verb::kStall, stalled ? 1 : 0, 0, 0});
}

void LipCamera::SetFormat(ports::CameraFormat format) {
  if (!CanShoot(format)) return;
  const bool same_size = format.width_px == format_.width_px && format.height_px == format_.height_px;
  format_ = format;
  if (same_size) return;
  // The face is painted once for each size: it costs more than the mouth and the noise together.
  backdrop_.clear();
  picture_.resize(YuyvBytes(format_));
}

std::size_t LipCamera::frame_bytes() const {
  return YuyvBytes(format_);
}

std::uint32_t LipCamera::stride_bytes() const {
  const auto width = static_cast<std::uint32_t>(format_.width_px);
  if (format_.pixels == ports::PixelFormat::kMjpeg) return 0;
  return format_.pixels == ports::PixelFormat::kYuyv ? width * 2 : width;
}

// Returns the bytes of the picture, 0 where `into` is too small. Whatever the format, it is drawn as YUYV and
// turned into the other afterwards.
std::size_t LipCamera::Shoot(std::uint32_t sequence, std::span<std::uint8_t> into) {
  if (into.size() < frame_bytes()) return 0;
  const bool direct = format_.pixels == ports::PixelFormat::kYuyv;
  const auto picture = direct ? into.first(frame_bytes()) : std::span(picture_);
  Draw(sequence, picture);
  if (direct) return frame_bytes();
  if (format_.pixels == ports::PixelFormat::kNv12)
    return YuyvToNv12(picture, format_.width_px, format_.height_px, into);
  return YuyvToJpeg(picture, format_.width_px, format_.height_px, into);
}

void LipCamera::Draw(std::uint32_t sequence, std::span<std::uint8_t> yuyv) {
  if (backdrop_.empty()) {
    backdrop_.resize(YuyvBytes(format_));
    PaintFace({format_.width_px, format_.height_px, backdrop_});
  }
  if (covered_) {
    // Even bytes are Y, odd ones Cb and Cr.
    for (std::size_t n = 0; n < yuyv.size(); ++n) yuyv[n] = n % 2 == 0 ? kDarkLuma : kGrey;
    return AddNoise(yuyv, sequence, yuyv);
  }
  std::ranges::copy(backdrop_, yuyv.begin());
  PaintMouth(mouth_, {format_.width_px, format_.height_px, yuyv});
  AddNoise(yuyv, sequence, yuyv);
}

}  // namespace kaori::sim
