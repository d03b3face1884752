// Pictures that shaders look up; beyond its edges a picture goes on as its edge is, unless it repeats. Smoothed
// between texels, but for kFloat4.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/gl/handle.h"

namespace kaori::gl {

enum class Texels : std::uint8_t {
  // 4 bytes, R G B sRGB-coded and A linear; read as linear light.
  kSrgb8,
  // 4 bytes, read as they are, 0..1.
  kRgba8,
  // 10 bits each, for what is drawn on and enlarged later: 8 would show steps in dark gradients.
  kRgb10,
  // 4 halves of floats: light beyond 1, drawn on and blurred. Not every driver draws on them.
  kHalf4,
  // 4 floats; read by texelFetch alone, since GLES 3.0 need not smooth floats.
  kFloat4,
};

// Sizes are 1 up to the driver's limit (GL_MAX_TEXTURE_SIZE).
struct TextureOptions {
  int width_px = 0;
  int height_px = 0;
  Texels texels = Texels::kRgba8;
  // Smaller pictures for what is seen from afar, each texel the mean of four. Of kRgba8 alone.
  bool mipmaps = false;
  // Beyond its edges the picture begins again.
  bool repeats = false;
};

// A picture of kRgba8 and its smaller ones, each half as wide and half as high as the one before, down to one texel.
// Rows as Texture has them.
struct MipLevel {
  std::vector<std::byte> bytes;
  int width_px = 0;
  int height_px = 0;
};
// Of `pixels`, which are the first level. Pure; on any thread: for a large picture it takes some 10 ms.
std::vector<MipLevel> MipLevelsOf(std::vector<std::byte> pixels, int width_px, int height_px);

// On the thread of its context. Storage is immutable: another size is another texture.
class Texture {
 public:
  // No texture yet: id() is 0.
  Texture() = default;
  // Its pixels are unset.
  explicit Texture(const TextureOptions& options);
  // `pixels` holds the rows one after another, without padding, the one at v = 0 first. Without mipmaps.
  Texture(const TextureOptions& options, std::span<const std::byte> pixels);
  // The same with mipmaps that were made before; `levels` as MipLevelsOf gives them, of the options' size.
  Texture(const TextureOptions& options, std::span<const MipLevel> levels);

  // Replaces the first `rows` rows of the picture. For textures without mipmaps. May wait for draws that
  // still read them.
  void Write(int rows, std::span<const std::byte> pixels);

  // Makes samplers that read texture unit `unit` look this up. Leaves that unit active.
  void Bind(unsigned unit) const;
  unsigned id() const { return handle_.id(); }

 private:
  // One level of the mipmaps, 0 the whole picture.
  void WriteLevel(int level, int width_px, int rows, std::span<const std::byte> pixels) const;

  Handle handle_;
  TextureOptions options_;
};

}  // namespace kaori::gl
