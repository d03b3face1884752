#include "render/gl/texture.h"

#include <GLES3/gl3.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <utility>
#include <vector>

namespace kaori::gl {
namespace {

// What glTexStorage2D and glTexSubImage2D are told of a kind of texel (GLES 3.0, table 3.2).
struct Format {
  GLenum internal, format, type;
};

// Internal format, format and type as GLES 3.0 pairs them (table 3.2).
Format FormatOf(Texels texels) {
  switch (texels) {
    case Texels::kSrgb8:
      return {GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE};
    case Texels::kRgba8:
      return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
    case Texels::kRgb10:
      return {GL_RGB10_A2, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV};
    case Texels::kHalf4:
      return {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT};
    case Texels::kFloat4:
      return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
  }
  return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
}

void DeleteTexture(unsigned id) {
  glDeleteTextures(1, &id);
}

// The whole picture and, with mipmaps, each half of the one before it down to a single texel.
int LevelsOf(const TextureOptions& o) {
  if (!o.mipmaps) return 1;
  return std::bit_width(static_cast<unsigned>(std::max(o.width_px, o.height_px)));
}

// The nearest level, smoothly: the step between levels does not show on skin, and it halves the look-ups.
void SetSampling(const TextureOptions& o) {
  const bool smooth = o.texels != Texels::kFloat4;
  const GLint shrink = o.mipmaps ? GL_LINEAR_MIPMAP_NEAREST : (smooth ? GL_LINEAR : GL_NEAREST);
  const GLint beyond = o.repeats ? GL_REPEAT : GL_CLAMP_TO_EDGE;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, beyond);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, beyond);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, shrink);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, smooth ? GL_LINEAR : GL_NEAREST);
}

// Half as wide and half as high, each texel the mean of the four that it replaces; an odd column or row at
// the end goes. `from` is larger than one texel.
MipLevel Halve(std::span<const std::byte> from, int width_px, int height_px) {
  const auto wide = static_cast<std::size_t>(width_px);
  MipLevel half{{}, std::max(width_px / 2, 1), std::max(height_px / 2, 1)};
  const auto columns = static_cast<std::size_t>(half.width_px);
  half.bytes.resize(columns * static_cast<std::size_t>(half.height_px) * 4);
  const std::size_t right = width_px > 1 ? 4 : 0;
  const std::size_t below = height_px > 1 ? wide * 4 : 0;
  const auto code = [](std::byte channel) { return std::to_integer<unsigned>(channel); };
  for (std::size_t y = 0; y < static_cast<std::size_t>(half.height_px); ++y) {
    const std::byte* row = from.data() + y * 2 * wide * 4;
    std::byte* to = half.bytes.data() + y * columns * 4;
    for (std::size_t x = 0; x < columns; ++x, row += 2 * right, to += 4) {
      for (std::size_t c = 0; c < 4; ++c) {
        const unsigned sum =
            code(row[c]) + code(row[right + c]) + code(row[below + c]) + code(row[right + below + c]);
        to[c] = static_cast<std::byte>((sum + 2) / 4);
      }
    }
  }
  return half;
}

}  // namespace

// A loop of our own: a software renderer compiles shaders for mipmaps anew at each start, and that takes longer.
std::vector<MipLevel> MipLevelsOf(std::vector<std::byte> pixels, int width_px, int height_px) {
  std::vector<MipLevel> levels;
  levels.push_back({std::move(pixels), width_px, height_px});
  while (levels.back().width_px > 1 || levels.back().height_px > 1) {
    const MipLevel& last = levels.back();
    levels.push_back(Halve(last.bytes, last.width_px, last.height_px));
  }
  return levels;
}

// Immutable: size and levels are fixed, which drivers like.
Texture::Texture(const TextureOptions& options) : options_(options) {
  GLuint id = 0;
  glGenTextures(1, &id);
  handle_ = Handle(id, DeleteTexture);
  glBindTexture(GL_TEXTURE_2D, id);
  glTexStorage2D(GL_TEXTURE_2D, LevelsOf(options), FormatOf(options.texels).internal, options.width_px,
                 options.height_px);
  SetSampling(options);
}

Texture::Texture(const TextureOptions& options, std::span<const std::byte> pixels) : Texture(options) {
  assert(!options.mipmaps);
  Write(options.height_px, pixels);
}

Texture::Texture(const TextureOptions& options, std::span<const MipLevel> levels) : Texture(options) {
  assert(options.mipmaps && options.texels == Texels::kRgba8);
  for (std::size_t number = 0; number < levels.size(); ++number)
    WriteLevel(static_cast<int>(number), levels[number].width_px, levels[number].height_px,
               levels[number].bytes);
}

void Texture::Write(int rows, std::span<const std::byte> pixels) {
  WriteLevel(0, options_.width_px, rows, pixels);
}

// From the first row on; the texture stays bound to the active unit.
void Texture::WriteLevel(int level, int width_px, int rows, std::span<const std::byte> pixels) const {
  const Format f = FormatOf(options_.texels);
  glBindTexture(GL_TEXTURE_2D, handle_.id());
  // Rows stand directly behind each other.
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage2D(GL_TEXTURE_2D, level, 0, 0, width_px, rows, f.format, f.type, pixels.data());
}

void Texture::Bind(unsigned unit) const {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, handle_.id());
}

}  // namespace kaori::gl
