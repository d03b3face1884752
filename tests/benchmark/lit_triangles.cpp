#include "tests/benchmark/lit_triangles.h"

#include <GLES3/gl3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>
#include <utility>

#include <glm/vec2.hpp>

#include "drivers/base/log.h"
#include "render/gl/draw_state.h"

namespace kaori::benchmark {
namespace {

// Quads along each side of the sheet.
constexpr int kSide = 105;
constexpr int kSkin_px = 1024;

// The half sphere is seen as an ellipse of 0.29 of the picture: half of its width times half of its height is 0.29 * 4 / pi.
constexpr gl::ShaderFile kShaders[] = {
    {"lit.vert",
     "layout(location = 0) in vec3 position;\nlayout(location = 1) in vec2 uv;\n"
     "uniform float aspect;\nout vec2 at;\nout vec3 light;\n"
     "void main() {\n"
     "  float lamp = max(dot(position, normalize(vec3(-0.4, 0.5, 0.8))), 0.0);\n"
     "  light = vec3(1.0, 0.95, 0.9) * lamp + vec3(0.12, 0.12, 0.16);\n"
     "  at = uv;\n"
     "  float reach = sqrt(0.369 / aspect);\n"
     "  gl_Position = vec4(position * vec3(reach, reach * aspect, -0.5), 1.0);\n"
     "}\n"},
    {"lit.frag",
     "uniform sampler2D skin;\nin vec2 at;\nin vec3 light;\nlayout(location = 0) out vec4 colour;\n"
     "void main() { colour = vec4(texture(skin, at).rgb * light, 1.0); }\n"}};

template <class T>
T MustHave(Result<T> made) {
  if (made) return std::move(*made);
  Log("{}", made.error().message());
  std::abort();
}

// The sheet drawn over a half of a sphere, all of it towards the viewer; a square goes to a disc as Shirley and
// Chiu's concentric map has it (1997).
std::vector<glm::vec3> Bulge() {
  std::vector<glm::vec3> points;
  for (int row = 0; row <= kSide; ++row) {
    for (int column = 0; column <= kSide; ++column) {
      const float x = 2 * static_cast<float>(column) / kSide - 1;
      const float y = 2 * static_cast<float>(row) / kSide - 1;
      const bool wide = std::abs(x) > std::abs(y);
      const float radius = wide ? x : y;
      const float turn = radius == 0 ? 0.0F : std::numbers::pi_v<float> / 4 * (wide ? y / x : 2 - x / y);
      const glm::vec2 at = radius * glm::vec2(std::cos(turn), std::sin(turn));
      points.emplace_back(at.x, at.y, std::sqrt(std::max(1 - radius * radius, 0.0F)));
    }
  }
  return points;
}

std::vector<glm::vec2> Sheet() {
  std::vector<glm::vec2> uv;
  for (int row = 0; row <= kSide; ++row)
    for (int column = 0; column <= kSide; ++column)
      uv.emplace_back(static_cast<float>(column) / kSide, static_cast<float>(row) / kSide);
  return uv;
}

// Counter-clockwise seen by the viewer.
std::vector<std::uint32_t> Quads() {
  constexpr std::uint32_t kRow = kSide + 1;
  std::vector<std::uint32_t> indices;
  for (std::uint32_t row = 0; row < kSide; ++row) {
    for (std::uint32_t column = 0; column < kSide; ++column) {
      const std::uint32_t a = row * kRow + column;
      indices.insert(indices.end(), {a, a + 1, a + kRow + 1, a, a + kRow + 1, a + kRow});
    }
  }
  return indices;
}

// Fine enough that no two texels are alike.
std::vector<std::byte> Speckled() {
  std::vector<std::byte> texels(std::size_t{kSkin_px} * kSkin_px * 4);
  for (std::size_t i = 0; i < texels.size(); ++i)
    texels[i] = static_cast<std::byte>(128 + i * 2654435761U % 97);
  return texels;
}

void DeleteDepth(unsigned id) {
  glDeleteRenderbuffers(1, &id);
}

// Of the framebuffer that is bound.
gl::Handle AttachDepth(int width_px, int height_px) {
  GLuint id = 0;
  glGenRenderbuffers(1, &id);
  glBindRenderbuffer(GL_RENDERBUFFER, id);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT16, width_px, height_px);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, id);
  return gl::Handle(id, DeleteDepth);
}

}  // namespace

LitTriangles::LitTriangles(int width_px, int height_px)
    : program_(MustHave(gl::Program::Make(
          {.library = kShaders, .vertex = "lit.vert", .fragment = "lit.frag", .defines = {}}))),
      picture_(MustHave(
          gl::Target::Make({.width_px = width_px, .height_px = height_px, .texels = gl::Texels::kSrgb8}))),
      depth_(AttachDepth(width_px, height_px)),
      skin_({.width_px = kSkin_px, .height_px = kSkin_px, .mipmaps = true},
            gl::MipLevelsOf(Speckled(), kSkin_px, kSkin_px)),
      positions_(Bulge()),
      position_buffer_(gl::BufferUse::kEachFrame, positions_.size() * sizeof(glm::vec3)),
      uv_buffer_(gl::Buffer::Of(std::span<const glm::vec2>(Sheet()))),
      mesh_({{position_buffer_, sizeof(glm::vec3), {{0, 3, gl::Scalar::kFloat, 0}}},
             {uv_buffer_, sizeof(glm::vec2), {{1, 2, gl::Scalar::kFloat, 0}}}},
            Quads()) {
  program_.BindSampler("skin", 0);
  aspect_ = program_.Find("aspect");
}

void LitTriangles::Draw(std::span<std::uint8_t> bytes) {
  position_buffer_.Write(std::as_bytes(std::span(positions_)));
  picture_.Begin();
  glDepthMask(GL_TRUE);
  glClearColor(0.02F, 0.02F, 0.04F, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl::Apply({});
  program_.Use();
  gl::Program::Set(aspect_,
                   static_cast<float>(picture_.width_px()) / static_cast<float>(picture_.height_px()));
  skin_.Bind(0);
  mesh_.Draw();
  picture_.ReadPixels(bytes);
}

}  // namespace kaori::benchmark
