#include "drivers/camera/planes.h"

#include <turbojpeg.h>

#include <array>
#include <cstdlib>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace kaori::camera {
namespace {

using ports::CameraFormat;
using ports::CameraFrame;

tl::unexpected<Error> Torn(const CameraFrame& frame, std::string_view what) {
  return Fail(std::errc::bad_message, fmt::format("read a {}x{} frame of {} bytes: {}", frame.format.width_px,
                                                  frame.format.height_px, frame.bytes.size(), what));
}

bool is_plausible(const CameraFormat& format) {
  constexpr int kMaxSide_px = 16384;
  return format.width_px > 0 && format.height_px > 0 && format.width_px <= kMaxSide_px &&
         format.height_px <= kMaxSide_px && format.width_px % 2 == 0;
}

// Y0 Cb Y1 Cr: two pixels share their colour.
Result<Planes> ReadYuyv(const CameraFrame& frame) {
  const auto [w, h, pixels] = frame.format;
  const std::uint32_t stride = frame.stride_bytes;
  const std::size_t used_row = 2u * static_cast<std::size_t>(w);
  if (stride < used_row) return Torn(frame, "the stride is shorter than a row");
  if (frame.bytes.size() < std::size_t{stride} * static_cast<std::size_t>(h - 1) + used_row)
    return Torn(frame, "too few bytes");
  return Planes{.y = {frame.bytes, w, h, stride, 2},
                .cb = {frame.bytes.subspan(1), w / 2, h, stride, 4},
                .cr = {frame.bytes.subspan(3), w / 2, h, stride, 4}};
}

// All Y, then rows of Cb Cr for every second row and column.
Result<Planes> ReadNv12(const CameraFrame& frame) {
  const auto [w, h, pixels] = frame.format;
  const std::uint32_t stride = frame.stride_bytes;
  if (h % 2 != 0) return Torn(frame, "the height is odd");
  if (stride < static_cast<std::uint32_t>(w)) return Torn(frame, "the stride is shorter than a row");
  const std::size_t luma = std::size_t{stride} * static_cast<std::size_t>(h);
  const std::size_t colour =
      std::size_t{stride} * static_cast<std::size_t>(h / 2 - 1) + static_cast<std::size_t>(w);
  if (frame.bytes.size() < luma + colour) return Torn(frame, "too few bytes");
  return Planes{.y = {frame.bytes.first(luma), w, h, stride, 1},
                .cb = {frame.bytes.subspan(luma), w / 2, h / 2, stride, 2},
                .cr = {frame.bytes.subspan(luma + 1), w / 2, h / 2, stride, 2}};
}

}  // namespace

struct PlaneReader::Jpeg {
  struct Destroy {
    void operator()(void* handle) const { tjDestroy(handle); }
  };
  std::unique_ptr<void, Destroy> decoder{tjInitDecompress()};
  std::array<std::vector<std::uint8_t>, 3> planes;

  // Webcams pad their pictures: libjpeg warns, and the picture is whole all the same.
  bool is_harmless() const {
    const std::string_view text = tjGetErrorStr2(decoder.get());
    return tjGetErrorCode(decoder.get()) == TJERR_WARNING && text.find("extraneous") != text.npos;
  }
};

PlaneReader::PlaneReader() = default;
PlaneReader::PlaneReader(PlaneReader&&) noexcept = default;
PlaneReader& PlaneReader::operator=(PlaneReader&&) noexcept = default;
PlaneReader::~PlaneReader() = default;

Result<Planes> PlaneReader::Read(const CameraFrame& frame) {
  if (!is_plausible(frame.format)) return Torn(frame, "no size that we read");
  switch (frame.format.pixels) {
    case ports::PixelFormat::kYuyv:
      return ReadYuyv(frame);
    case ports::PixelFormat::kNv12:
      return ReadNv12(frame);
    case ports::PixelFormat::kMjpeg:
      return ReadJpeg(frame);
  }
  return Torn(frame, "a pixel format that is not known");
}

Result<Planes> PlaneReader::ReadJpeg(const CameraFrame& frame) {
  if (!jpeg_) jpeg_ = std::make_unique<Jpeg>();
  tjhandle decoder = jpeg_->decoder.get();
  int w = 0, h = 0, subsampling = 0, colours = 0;
  if (tjDecompressHeader3(decoder, frame.bytes.data(), frame.bytes.size(), &w, &h, &subsampling, &colours) !=
      0)
    return Torn(frame, tjGetErrorStr2(decoder));
  if (w != frame.format.width_px || h != frame.format.height_px)
    return Torn(frame, "the JPEG has another size");
  if (colours != TJCS_YCbCr || subsampling == TJSAMP_GRAY) return Torn(frame, "the JPEG has no Y, Cb and Cr");
  std::array<unsigned char*, 3> into{};
  std::array<Plane, 3> planes;
  for (int n = 0; n < 3; ++n) {
    const auto i = static_cast<std::size_t>(n);
    jpeg_->planes[i].resize(tjPlaneSizeYUV(n, w, 0, h, subsampling));
    into[i] = jpeg_->planes[i].data();
    const int plane_w = tjPlaneWidth(n, w, subsampling);
    planes[i] = {jpeg_->planes[i], plane_w, tjPlaneHeight(n, h, subsampling),
                 static_cast<std::uint32_t>(plane_w)};
  }
  const int flags = TJFLAG_FASTDCT | TJFLAG_LIMITSCANS;
  if (tjDecompressToYUVPlanes(decoder, frame.bytes.data(), frame.bytes.size(), into.data(), 0, nullptr, 0,
                              flags) != 0 &&
      !jpeg_->is_harmless())
    return Torn(frame, tjGetErrorStr2(decoder));
  return Planes{.y = planes[0], .cb = planes[1], .cr = planes[2], .full_range = true};
}

}  // namespace kaori::camera
