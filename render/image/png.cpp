#include "render/image/png.h"

#include <png.h>

#include <cstring>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "drivers/base/read_file.h"

namespace kaori::image {
namespace {

// A picture of 4096 by 4096 pixels, and its file where it cannot be packed at all.
constexpr std::size_t kMostPng_px = std::size_t{4096} * 4096;
constexpr std::size_t kMostPng_bytes = 4 * kMostPng_px;

// libpng's simple interface: version set, everything else zero.
png_image Blank() {
  png_image image;
  std::memset(&image, 0, sizeof(image));
  image.version = PNG_IMAGE_VERSION;
  return image;
}

// A picture of its size as libpng's simple interface wants to hear of it: R, G, B, since that writes
// no fourth channel.
png_image Described(const Picture& picture) {
  png_image image = Blank();
  image.width = static_cast<png_uint_32>(picture.width_px);
  image.height = static_cast<png_uint_32>(picture.height_px);
  image.format = PNG_FORMAT_RGB;
  return image;
}

// R, G, B alone: nobody wants a PNG with an alpha that means nothing.
std::vector<std::uint8_t> WithoutX(const Picture& picture) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(picture.rgbx.size() / 4 * 3);
  for (std::size_t i = 0; i + 3 < picture.rgbx.size(); i += 4)
    rgb.insert(rgb.end(), picture.rgbx.begin() + static_cast<std::ptrdiff_t>(i),
               picture.rgbx.begin() + static_cast<std::ptrdiff_t>(i) + 3);
  return rgb;
}

// Bytes from one row to the next; negative: the last row in memory is the top one.
png_int_32 Stride(const Picture& picture) {
  return -picture.width_px * 3;
}

}  // namespace

Result<void> WritePng(const std::filesystem::path& file, const Picture& picture) {
  png_image image = Described(picture);
  const std::vector<std::uint8_t> rgb = WithoutX(picture);
  if (png_image_write_to_file(&image, file.c_str(), 0, rgb.data(), Stride(picture), nullptr) == 0)
    return Fail(std::errc::io_error, "write " + file.string() + " (" + image.message + ")");
  return {};
}

// The buffer has libpng's upper bound for such a picture and is cut afterwards, so that it is encoded once.
Result<std::vector<std::uint8_t>> EncodePng(const Picture& picture) {
  png_image image = Described(picture);
  // Packed faster into a somewhat larger file: contact sheets have many megapixels.
  image.flags = PNG_IMAGE_FLAG_FAST;
  const std::vector<std::uint8_t> rgb = WithoutX(picture);
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::vector<std::uint8_t> bytes(size);
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, rgb.data(), Stride(picture), nullptr) == 0)
    return Fail(std::errc::io_error, std::string("encode a picture (") + image.message + ")");
  bytes.resize(size);
  return bytes;
}

// The file is read by the bounded reader first; libpng then sees memory alone.
Result<Picture> ReadPng(const std::filesystem::path& file) {
  const auto bytes = ReadFile(file, {.most_bytes = kMostPng_bytes});
  if (!bytes) return tl::unexpected(bytes.error());
  png_image image = Blank();
  if (png_image_begin_read_from_memory(&image, bytes->data(), bytes->size()) == 0)
    return FailInput("read " + file.string() + ": " + image.message);
  // Frees what the first reading has made, however this function is left.
  const std::unique_ptr<png_image, decltype(&png_image_free)> freed(&image, png_image_free);
  // A file of some kilobytes can promise a picture that no memory holds.
  if (std::size_t{image.width} * image.height > kMostPng_px)
    return FailInput(fmt::format("read {}: a picture of {} x {} pixels; {} of them are the most",
                                 file.string(), image.width, image.height, kMostPng_px));
  image.format = PNG_FORMAT_RGBA;
  Picture picture = Picture::Blank(static_cast<int>(image.width), static_cast<int>(image.height));
  const bool read =
      // Negative: the top row is read into the last one in memory. X becomes the file's alpha.
      png_image_finish_read(&image, nullptr, picture.rgbx.data(), -picture.width_px * 4, nullptr) != 0;
  if (!read) return FailInput("read " + file.string() + ": " + image.message);
  return picture;
}

// Row by row; nothing is mixed.
void Paste(const Picture& from, Picture& into, int x_px, int y_px) {
  for (int row = 0; row < from.height_px; ++row) {
    const auto source = static_cast<std::size_t>(row * from.width_px) * 4;
    const auto target = static_cast<std::size_t>((y_px + row) * into.width_px + x_px) * 4;
    std::memcpy(into.rgbx.data() + target, from.rgbx.data() + source,
                static_cast<std::size_t>(from.width_px) * 4);
  }
}

}  // namespace kaori::image
