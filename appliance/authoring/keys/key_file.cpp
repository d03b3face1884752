#include "appliance/authoring/keys/key_file.h"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

#include "drivers/web/jpeg.h"
#include "firmware/wire/bytes.h"

namespace kaori::authoring {
namespace {

using Way = decode::DeckShape::Way;

// Of a key's few points each is looked at.
constexpr int kQuality = 92;
// A Windows bitmap: the two headers before its points, of which the second has 40 bytes.
constexpr std::size_t kHeadBytes = 54, kInfoBytes = 40;

// Where the point of the picture goes, in rows from the bottom as pictures have them.
image::Picture Turned(const image::Picture& picture, Way way) {
  if (way == Way::kUpright) return picture;
  const int side = picture.width_px;
  image::Picture turned = image::Picture::Blank(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      // Rows and columns are counted from the upper left when they change places.
      const int from_x = way == Way::kHalfTurn ? side - 1 - x : side - 1 - y;
      const int from_y = way == Way::kHalfTurn ? side - 1 - y : side - 1 - x;
      const std::ptrdiff_t from = std::ptrdiff_t{from_y} * side + from_x, to = std::ptrdiff_t{y} * side + x;
      std::copy_n(picture.rgbx.begin() + from * 4, 4, turned.rgbx.begin() + to * 4);
    }
  return turned;
}

// 24 bits a point, the bottom row first, blue before red; rows are filled to a multiple of four bytes.
std::vector<std::uint8_t> Bitmap(const image::Picture& picture) {
  const auto side = static_cast<std::size_t>(picture.width_px);
  const std::size_t row_bytes = (side * 3 + 3) / 4 * 4;
  std::vector<std::uint8_t> file(kHeadBytes + row_bytes * side);
  file[0] = 'B';
  file[1] = 'M';
  wire::PutU32(file, 2, static_cast<std::uint32_t>(file.size()));
  wire::PutU32(file, 10, kHeadBytes);
  wire::PutU32(file, 14, kInfoBytes);
  wire::PutU32(file, 18, static_cast<std::uint32_t>(side));
  wire::PutU32(file, 22, static_cast<std::uint32_t>(side));
  wire::PutU16(file, 26, 1);   // One plane,
  wire::PutU16(file, 28, 24);  // and bits of a point.
  for (std::size_t y = 0; y < side; ++y)
    for (std::size_t x = 0; x < side; ++x)
      for (std::size_t colour = 0; colour < 3; ++colour)
        file[kHeadBytes + y * row_bytes + x * 3 + colour] = picture.rgbx[(y * side + x) * 4 + 2 - colour];
  return file;
}

}  // namespace

Result<std::vector<std::uint8_t>> KeyFile(const image::Picture& picture, const decode::DeckShape& shape) {
  if (picture.width_px != shape.key_px || picture.height_px != shape.key_px)
    return FailInput(fmt::format("make a key of {} px of a picture of {}x{}", shape.key_px, picture.width_px,
                                 picture.height_px));
  const image::Picture turned = Turned(picture, shape.way);
  if (shape.is_bitmap) return Bitmap(turned);
  const auto jpeg = web::JpegEncoder().Encode(
      {.width_px = shape.key_px, .height_px = shape.key_px, .rgbx = turned.rgbx}, kQuality);
  if (!jpeg) return tl::unexpected(jpeg.error());
  return std::vector<std::uint8_t>(jpeg->begin(), jpeg->end());
}

}  // namespace kaori::authoring
