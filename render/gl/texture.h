// Pictures that shaders look up; beyond its edges a picture goes on as its edge is. Smoothed between texels,
// but for kFloat4.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "render/gl/handle.h"

namespace kaori::gl {

enum class Texels : std::uint8_t {
  kSrgb8,   // 4 bytes, R G B sRGB-coded and A linear; read as linear light.
  kRgba8,   // 4 bytes, read as they are.
  kRgb10,   // 10 bits each, for what is drawn on and enlarged later.
  kFloat4,  // 4 floats; read by texelFetch alone.
};

struct TextureOptions {
  int width_px = 0;
  int height_px = 0;
  Texels texels = Texels::kRgba8;
  // Smaller pictures for what is seen from afar, each texel the mean of four. Of kRgba8 alone.
  bool mipmaps = false;
};

// On the thread of its context.
class Texture {
 public:
  // No texture yet: id() is 0.
  Texture() = default;
  // `pixels` holds the rows one after another, the one at v = 0 first; empty leaves them unset.
  Texture(const TextureOptions& options, std::span<const std::byte> pixels);

  // Replaces the first `rows` rows of the picture. For textures without mipmaps.
  void Write(int rows, std::span<const std::byte> pixels);

  // Makes samplers that read texture unit `unit` look this up.
  void Bind(unsigned unit) const;
  unsigned id() const { return handle_.id(); }

 private:
  void WriteLevel(int level, int width_px, int rows, std::span<const std::byte> pixels) const;

  Handle handle_;
  TextureOptions options_;
};

}  // namespace kaori::gl
