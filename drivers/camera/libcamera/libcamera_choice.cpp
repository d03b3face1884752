#include "drivers/camera/libcamera/libcamera_choice.h"

#include <array>

#include <fmt/format.h>

namespace kaori::camera {
namespace {

using ports::CameraFormat;
using ports::PixelFormat;

constexpr int kLeastWidth_px = 320;
constexpr int kMostWidth_px = 1280;
// Of a width that is worse for lips than any other: a factor above that of any two costs.
constexpr double kPenalty = 1e6;
// 60, 30 and 24 frames a second.
constexpr std::array<std::int64_t, 3> kSlower_us = {16'667, 33'333, 41'667};

// As V4L2's cost of a format: what comes sooner costs less.
double BytesPerPixel(PixelFormat pixels) {
  switch (pixels) {
    case PixelFormat::kNv12:
      return 1.5;
    case PixelFormat::kYuyv:
      return 2;
    case PixelFormat::kMjpeg:
      return 4;  // It is small, but has to be decoded, and blurs colour.
  }
  return 0;
}

const char* NameOfPixels(PixelFormat pixels) {
  if (pixels == PixelFormat::kMjpeg) return "MJPEG";
  return pixels == PixelFormat::kNv12 ? "NV12" : "YUYV";
}

// The costs of two formats that fit differ by less than the penalty, so that it decides alone. Of formats
// without a fitting width the smallest wins.
double CostOf(const CameraFormat& format) {
  const bool fits = format.width_px >= kLeastWidth_px && format.width_px <= kMostWidth_px;
  return BytesPerPixel(format.pixels) * format.width_px * format.height_px * (fits ? 1 : kPenalty);
}

}  // namespace

std::optional<CameraFormat> ChooseFormat(std::span<const CameraFormat> offered) {
  std::optional<CameraFormat> best;
  for (const CameraFormat& format : offered)
    if (!best || CostOf(format) < CostOf(*best)) best = format;
  return best;
}

std::string NameOf(const CameraFormat& format, double rate_hz) {
  const auto picture =
      fmt::format("{} x {} {}", format.width_px, format.height_px, NameOfPixels(format.pixels));
  return rate_hz > 0 ? fmt::format("{} at {:.4g} frames/s", picture, rate_hz)
                     : picture + " at the camera's own rate";
}

// Rung 0 is the camera's fastest; each further rung is the next of the slower ones that the camera can do.
std::optional<std::int64_t> FrameTimeOf(const FrameTimes& can, std::size_t rung) {
  if (rung == 0) return can.shortest_us;
  for (const std::int64_t slower_us : kSlower_us) {
    // Within 2 % of the fastest a rung would be the same rate again.
    const bool is_slower = slower_us > can.shortest_us + can.shortest_us / 50;
    if (is_slower && slower_us <= can.longest_us && --rung == 0) return slower_us;
  }
  return std::nullopt;
}

}  // namespace kaori::camera
