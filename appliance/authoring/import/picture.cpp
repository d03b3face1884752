#include "appliance/authoring/import/picture.h"

#include <memory>

#include <fmt/format.h>
#include <png.h>
#include <turbojpeg.h>

namespace kaori::import {
namespace {

// The gloss of skin, of 255: what artists paint into alpha is transparency, not gloss.
constexpr std::uint8_t kGloss = 40;

// A texture of this size without content; refused before memory is asked for.
Result<face::Texture> Blank(int width_px, int height_px) {
  if (width_px < 1 || height_px < 1 || width_px > kMostSide_px || height_px > kMostSide_px)
    return FailInput(fmt::format("a picture of {} x {} pixels; {} a side are possible", width_px, height_px,
                                 kMostSide_px));
  return face::Texture{width_px, height_px,
                       std::vector<std::uint8_t>(4 * static_cast<std::size_t>(width_px) *
                                                 static_cast<std::size_t>(height_px))};
}

void SetGloss(face::Texture& texture) {
  for (std::size_t i = 3; i < texture.rgba.size(); i += 4) texture.rgba.own()[i] = kGloss;
}

// libpng's simplified interface converts every kind of PNG to 8 bits a channel.
Result<face::Texture> DecodePng(std::span<const std::uint8_t> bytes) {
  png_image picture{};
  picture.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&picture, bytes.data(), bytes.size()) == 0)
    return FailInput(std::string("not a sound PNG: ") + picture.message);
  // Frees what the first reading has made, however this function is left.
  const std::unique_ptr<png_image, decltype(&png_image_free)> freed(&picture, png_image_free);
  picture.format = PNG_FORMAT_RGBA;
  auto texture = Blank(static_cast<int>(picture.width), static_cast<int>(picture.height));
  if (!texture) return texture;
  if (png_image_finish_read(&picture, nullptr, texture->rgba.own().data(), 0, nullptr) == 0)
    return FailInput(std::string("not a sound PNG: ") + picture.message);
  SetGloss(*texture);
  return texture;
}

// Also for bytes that are neither: turbojpeg refuses them by their header.
Result<face::Texture> DecodeJpeg(std::span<const std::uint8_t> bytes) {
  const std::unique_ptr<void, decltype(&tjDestroy)> reader(tjInitDecompress(), tjDestroy);
  int width_px = 0;
  int height_px = 0;
  int sampling = 0;
  int colours = 0;
  const auto size = static_cast<unsigned long>(bytes.size());
  if (tjDecompressHeader3(reader.get(), bytes.data(), size, &width_px, &height_px, &sampling, &colours) != 0)
    return FailInput("neither a sound PNG nor a sound JPEG");
  auto texture = Blank(width_px, height_px);
  if (!texture) return texture;
  if (tjDecompress2(reader.get(), bytes.data(), size, texture->rgba.own().data(), width_px, 0, height_px,
                    TJPF_RGBA, 0) != 0)
    return FailInput(std::string("not a sound JPEG: ") + tjGetErrorStr2(reader.get()));
  SetGloss(*texture);
  return texture;
}

}  // namespace

Result<face::Texture> DecodePicture(std::span<const std::uint8_t> bytes) {
  // The first of the eight bytes of a PNG's signature; a JPEG begins with 0xFF.
  constexpr std::uint8_t kPngFirst = 0x89;
  if (bytes.empty()) return FailInput("an empty picture");
  return bytes[0] == kPngFirst ? DecodePng(bytes) : DecodeJpeg(bytes);
}

}  // namespace kaori::import
