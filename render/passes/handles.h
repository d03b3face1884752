// The editor's handles: needles that stick in the face at its control points, as in figure 3 of Arai et al.
// 1994.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "render/face/cast.h"
#include "render/face/composer.h"
#include "render/gl/mesh.h"
#include "render/gl/program.h"
#include "render/gl/texture.h"
#include "render/scene/scene.h"

namespace kaori::passes {

// One instanced draw for all handles; where they stand is read from a texture of floats, written
// once a frame.
class HandlesPass {
 public:
  // Borrows the cast's control net. Errors: invalid_argument (a shader).
  static Result<HandlesPass> Open(const face::Cast& cast);

  // Into the canvas's layer, among what stands there: what that hides of them is hidden, but the chosen one
  // and its partner glimmer through. They grow out of the skin with `shown`. A pull that is no number counts
  // as none. Allocates nothing.
  enum class Among : std::uint8_t { kSkin, kWires };
  void Draw(const scene::Handles& handles, const face::Shape& shape, Among among = Among::kSkin);

  // No handle ends farther from the face than this, metres; 0 while none is shown. For FindFigure.
  static float ReachOf(const scene::Handles& handles);

 private:
  // As handle.vert fetches them.
  struct Texels {
    glm::vec4 root;   // xyz: in the skin, head's frame; w: length, metres.
    glm::vec4 axis;   // xyz: unit, out of the face; w: the head's radius, metres.
    glm::vec4 paint;  // rgb: of the head, as far as w says; the rest is plain.
  };
  // Works out which points lie beside each other on the reference face.
  HandlesPass(gl::Program program, const face::Cast& cast);
  // Sets axes_: unit, out of the face as it is about each point.
  void Straighten(const face::Shape& shape);
  // Where one handle stands, how long it is and how it is painted.
  Texels Place(const scene::Handles& handles, const face::Shape& shape, std::size_t point) const;
  // Draws one handle whatever stands before it; -1 and numbers beyond draw nothing.
  void DrawThrough(int point) const;

  const face::ControlNet* net_;
  // For each point, the points about it and how near they are.
  face::SparseRows beside_;
  // Of the skin at each point,
  std::vector<glm::vec3> normals_;
  std::vector<glm::vec3> axes_;  // and what the points about it make of them.
  gl::Program program_;
  // Where uniforms are.
  int first_, opacity_, plain_;
  // All handles of the frame, in the order of the net's points; written to texture_.
  std::vector<Texels> handles_;
  gl::Texture texture_;
  gl::Buffer corners_;
  gl::Mesh handle_;
};

}  // namespace kaori::passes
