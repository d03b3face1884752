#include "render/gl/texture.h"

#include <GLES3/gl3.h>

#include <algorithm>
#include <bit>

namespace kaori::gl {
namespace {

struct Format {
  GLenum internal, format, type;
};

Format FormatOf(Texels texels) {
  switch (texels) {
    case Texels::kSrgb8:
      return {GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE};
    case Texels::kRgba8:
      return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
    case Texels::kRgb10:
      return {GL_RGB10_A2, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV};
    case Texels::kGrey8:
      return {GL_R8, GL_RED, GL_UNSIGNED_BYTE};
    case Texels::kFloat4:
      return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
  }
  return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
}

void Delete(unsigned id) {
  glDeleteTextures(1, &id);
}

int LevelsOf(const TextureOptions& o) {
  if (!o.mipmaps) return 1;
  return std::bit_width(static_cast<unsigned>(std::max(o.width_px, o.height_px)));
}

// The nearest level, smoothly: the step between levels does not show on skin, and it halves the look-ups.
void SetSampling(const TextureOptions& o) {
  const GLint wrap = o.repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
  const bool smooth = o.texels != Texels::kFloat4;
  const GLint shrink = o.mipmaps ? GL_LINEAR_MIPMAP_NEAREST : (smooth ? GL_LINEAR : GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, shrink);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, smooth ? GL_LINEAR : GL_NEAREST);
}

}  // namespace

Texture::Texture(const TextureOptions& options, std::span<const std::byte> pixels) : options_(options) {
  GLuint id = 0;
  glGenTextures(1, &id);
  handle_ = Handle(id, Delete);
  glBindTexture(GL_TEXTURE_2D, id);
  glTexStorage2D(GL_TEXTURE_2D, LevelsOf(options), FormatOf(options.texels).internal, options.width_px,
                 options.height_px);
  SetSampling(options);
  if (pixels.empty()) return;
  Write(options.height_px, pixels);
  if (options.mipmaps) glGenerateMipmap(GL_TEXTURE_2D);
}

void Texture::Write(int rows, std::span<const std::byte> pixels) {
  const Format f = FormatOf(options_.texels);
  glBindTexture(GL_TEXTURE_2D, handle_.id());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, options_.width_px, rows, f.format, f.type, pixels.data());
}

void Texture::Bind(unsigned unit) const {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, handle_.id());
}

}  // namespace kaori::gl
