// The reference for F2b: the least that draws a head of so many triangles. One surface with a texture and a light at
// each vertex, uploaded anew for each frame; one sample a pixel, no backdrop, no hair; read back as ours is.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "render/gl/buffer.h"
#include "render/gl/handle.h"
#include "render/gl/mesh.h"
#include "render/gl/program.h"
#include "render/gl/target.h"
#include "render/gl/texture.h"

namespace kaori::benchmark {

class LitTriangles {
 public:
  // 22 050 triangles, all towards the viewer, over 29 % of a picture of this size. A context is current. Aborts
  // with a line in the log where a shader fails.
  LitTriangles(int width_px, int height_px);

  // One frame; `bytes` holds width * height * 4.
  void Draw(std::span<std::uint8_t> bytes);

 private:
  gl::Program program_;
  gl::Target picture_;
  gl::Handle depth_;
  gl::Texture skin_;
  // As uploaded; normals of a sphere are its positions.
  std::vector<glm::vec3> positions_;
  gl::Buffer position_buffer_;
  gl::Buffer uv_buffer_;
  gl::Mesh mesh_;
  // Where a uniform is.
  int aspect_ = -1;
};

}  // namespace kaori::benchmark
