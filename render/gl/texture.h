// Pictures that shaders look up; beyond its edges a picture goes on as its edge is. Smoothed between texels,
// but for kFloat4.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "render/gl/handle.h"

namespace kaori::gl {

enum class Texels : std::uint8_t {
  // 4 bytes, R G B sRGB-coded and A linear; read as linear light.
  kSrgb8,
  // 4 bytes, read as they are, 0..1.
  kRgba8,
  // 10 bits each, for what is drawn on and enlarged later: 8 would show steps in dark gradients.
  kRgb10,
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
};

// On the thread of its context. Storage is immutable: another size is another texture. Edges clamp.
class Texture {
 public:
  // No texture yet: id() is 0.
  Texture() = default;
  // `pixels` holds the rows one after another, without padding, the one at v = 0 first; empty leaves them
  // unset. Mipmaps are made of them here, on the processor.
  Texture(const TextureOptions& options, std::span<const std::byte> pixels);

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
