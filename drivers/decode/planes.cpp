#include "drivers/decode/planes.h"

#include <turbojpeg.h>

#include <array>
#include <cstdlib>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace kaori::decode {
namespace {

using ports::CameraFormat;
using ports::CameraFrame;

// More than any camera for lips; a JPEG of a few bytes may call itself so large that it eats our
// memory. With these bounds a frame costs 48 MiB of planes at most.
constexpr int kMostSide_px = 4096;
constexpr std::size_t kMostJpegBytes = 16u << 20;

// Names the frame's format and length, so that a log line tells what the camera sent.
tl::unexpected<Error> Torn(const CameraFrame& frame, std::string_view what) {
  return Fail(std::errc::bad_message, fmt::format("read a {}x{} frame of {} bytes: {}", frame.format.width_px,
                                                  frame.format.height_px, frame.bytes.size(), what));
}

// Both packed formats share colour between two columns, so the width is even.
bool is_plausible(const CameraFormat& format) {
  return format.width_px > 0 && format.height_px > 0 && format.width_px <= kMostSide_px &&
         format.height_px <= kMostSide_px && format.width_px % 2 == 0;
}

// Y0 Cb Y1 Cr: two pixels share their colour.
Result<Planes> ReadYuyv(const CameraFrame& frame) {
  const auto [w, h, pixels] = frame.format;
  const std::uint32_t stride = frame.stride_bytes;
  const std::size_t used_row = 2u * static_cast<std::size_t>(w);
  if (stride < used_row) return Torn(frame, "the stride is shorter than a row");
  // The last row need not be padded to the stride.
  if (frame.bytes.size() < std::size_t{stride} * static_cast<std::size_t>(h - 1) + used_row)
    return Torn(frame, "too few bytes");
  // Each plane begins at its own first byte; the steps of 2 and 4 bytes skip the others.
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

class PlaneReader::Jpeg {
 public:
  Result<Planes> Decode(const CameraFrame& frame);

 private:
  struct Destroy {
    void operator()(void* handle) const { tjDestroy(handle); }
  };
  // Checks the size and the colours that the JPEG itself claims.
  Result<int> ReadHeader(const CameraFrame& frame) const;
  // Memory for a component, as large as the subsampling needs.
  Plane MakePlane(int component, const CameraFormat& format, int subsampling);
  // Whether the last error was a warning about a whole picture.
  bool is_harmless() const;

  std::unique_ptr<void, Destroy> decoder_{tjInitDecompress()};
  // The copy that is decoded, and the planes that a caller reads; both are kept from frame to frame.
  std::vector<std::uint8_t> jpeg_;
  std::array<std::vector<std::uint8_t>, 3> memory_;
};

// Looks at a copy: the frame's memory may be shared with the camera, and the size that was checked must be
// the size that is decoded.
Result<Planes> PlaneReader::Jpeg::Decode(const CameraFrame& frame) {
  if (frame.bytes.size() > kMostJpegBytes) return Torn(frame, "too many bytes");
  jpeg_.assign(frame.bytes.begin(), frame.bytes.end());
  const auto subsampling = ReadHeader(frame);
  if (!subsampling) return tl::unexpected(subsampling.error());
  const Planes planes{.y = MakePlane(0, frame.format, *subsampling),
                      .cb = MakePlane(1, frame.format, *subsampling),
                      .cr = MakePlane(2, frame.format, *subsampling),
                      .full_range = true};
  std::array<unsigned char*, 3> into = {memory_[0].data(), memory_[1].data(), memory_[2].data()};
  const int result = tjDecompressToYUVPlanes(decoder_.get(), jpeg_.data(), jpeg_.size(), into.data(), 0,
                                             // The fast transform is exact enough for finding lips;
                                             // LIMITSCANS stops progressive pictures of thousands of
                                             // scans, which would decode for minutes.
                                             nullptr, 0, TJFLAG_FASTDCT | TJFLAG_LIMITSCANS);
  if (result != 0 && !is_harmless()) return Torn(frame, tjGetErrorStr2(decoder_.get()));
  return planes;
}

// The way colour is subsampled, where the picture is one that we read.
Result<int> PlaneReader::Jpeg::ReadHeader(const CameraFrame& frame) const {
  int w = 0, h = 0, subsampling = 0, colours = 0;
  if (tjDecompressHeader3(decoder_.get(), jpeg_.data(), jpeg_.size(), &w, &h, &subsampling, &colours) != 0)
    return Torn(frame, tjGetErrorStr2(decoder_.get()));
  if (w != frame.format.width_px || h != frame.format.height_px)
    return Torn(frame, "the JPEG has another size");
  if (colours != TJCS_YCbCr || subsampling == TJSAMP_GRAY) return Torn(frame, "the JPEG has no Y, Cb and Cr");
  return subsampling;
}

// The memory is kept for the next picture: nothing is allocated while size and subsampling stay as they are.
Plane PlaneReader::Jpeg::MakePlane(int component, const CameraFormat& format, int subsampling) {
  auto& memory = memory_[static_cast<std::size_t>(component)];
  memory.resize(tjPlaneSizeYUV(component, format.width_px, 0, format.height_px, subsampling));
  const int width_px = tjPlaneWidth(component, format.width_px, subsampling);
  const int height_px = tjPlaneHeight(component, format.height_px, subsampling);
  return {memory, width_px, height_px, static_cast<std::uint32_t>(width_px)};
}

// Webcams pad their pictures: libjpeg warns, and the picture is whole all the same.
bool PlaneReader::Jpeg::is_harmless() const {
  const std::string_view text = tjGetErrorStr2(decoder_.get());
  return tjGetErrorCode(decoder_.get()) == TJERR_WARNING && text.find("extraneous") != text.npos;
}

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
  auto planes = jpeg_->Decode(frame);
  // libjpeg-turbo 2.1 may stumble over the next picture after a torn header: a new decoder starts clean.
  if (!planes) jpeg_.reset();
  return planes;
}

}  // namespace kaori::decode
