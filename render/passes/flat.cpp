#include "render/passes/flat.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "render/gl/draw_state.h"
#include "render/passes/frame.h"

namespace kaori::passes {

FlatPass::FlatPass(gl::Program program, const face::Cast& cast)
    : cast_(&cast),
      program_(std::move(program)),
      paint_(program_.Find("paint")),
      corners_(cast.topology.triangles.size() * 3),
      buffer_(gl::BufferUse::kEachFrame, corners_.size() * sizeof(Corner)),
      mesh_({{buffer_, sizeof(Corner), {{0, 3, gl::Scalar::kFloat, 0}, {1, 3, gl::Scalar::kFloat, 12}}}},
            static_cast<int>(corners_.size())) {}

Result<FlatPass> FlatPass::Open(const face::Cast& cast) {
  auto program = MakeProgram("flat.vert", "flat.frag");
  if (!program) return tl::unexpected(program.error());
  return FlatPass(std::move(*program), cast);
}

// Each triangle has corners of its own, for its normal is its own.
void FlatPass::WriteFacets(const face::Shape& shape) {
  Corner* corner = corners_.data();
  for (const face::Triangle& t : cast_->topology.triangles) {
    const glm::vec3 a = shape.cage[t[0]];
    const glm::vec3 b = shape.cage[t[1]];
    const glm::vec3 c = shape.cage[t[2]];
    const glm::vec3 across = glm::cross(b - a, c - a);
    const glm::vec3 normal = across / std::max(glm::length(across), 1e-12F);
    *corner++ = {a, normal};
    *corner++ = {b, normal};
    *corner++ = {c, normal};
  }
}

// The corners are written whole; a cage has some 5000 triangles.
void FlatPass::Draw(const face::Shape& shape) {
  WriteFacets(shape);
  buffer_.Write(std::as_bytes(std::span(corners_)));
  glm::vec3 paint{};
  for (const face::Term& term : shape.faces) paint += term.weight * cast_->faces[term.index].surface.flat;
  gl::Apply({});
  program_.Use();
  gl::Program::Set(paint_, paint);
  mesh_.Draw();
}

}  // namespace kaori::passes
