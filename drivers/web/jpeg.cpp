#include "drivers/web/jpeg.h"

#include <turbojpeg.h>

#include <fmt/format.h>

namespace kaori::web {
namespace {

// Larger pictures are no previews.
constexpr int kMostSide_px = 8192;

// Whether the picture has the bytes that its size needs.
bool Agrees(const Picture& picture) {
  const auto fits = [](int side_px) { return side_px > 0 && side_px <= kMostSide_px; };
  return fits(picture.width_px) && fits(picture.height_px) &&
         picture.rgbx.size() ==
             static_cast<std::size_t>(picture.width_px) * static_cast<std::size_t>(picture.height_px) * 4;
}

}  // namespace

JpegEncoder::JpegEncoder() : handle_(tjInitCompress()) {}

JpegEncoder::~JpegEncoder() {
  tjFree(buffer_);
}

void JpegEncoder::Close::operator()(void* handle) const {
  tjDestroy(handle);
}

// The buffer is kept for the next picture. Chroma is halved both ways (4:2:0), which is enough for a page.
Result<std::string> JpegEncoder::Encode(const Picture& picture, int quality) {
  const auto attempt = fmt::format("encode a picture of {}x{}", picture.width_px, picture.height_px);
  if (!Agrees(picture)) return FailInput(attempt);
  // TurboJPEG reads the size of the buffer that it is given, and grows it where the picture does not fit.
  unsigned long bytes = buffer_bytes_;
  if (handle_ == nullptr || tjCompress2(handle_.get(), picture.rgbx.data(), picture.width_px, 0,
                                        picture.height_px, TJPF_RGBX, &buffer_, &bytes, TJSAMP_420, quality,
                                        (picture.bottom_up ? TJFLAG_BOTTOMUP : 0) | TJFLAG_FASTDCT) != 0)
    return Fail(std::errc::not_enough_memory, attempt);
  buffer_bytes_ = std::max(buffer_bytes_, bytes);
  return std::string(reinterpret_cast<const char*>(buffer_), bytes);
}

}  // namespace kaori::web
