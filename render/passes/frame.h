// What all passes of a frame share, in the layout that shaders read (render/shaders/frame.glsl).
//
// For all passes of this folder: they are opened once, on the thread of the context that is current, and
// drawn there; what they borrow outlives them; Open compiles shaders, which blocks for milliseconds each;
// Draw cannot fail, and allocates nothing but where a header says so. Positions are metres in the head's
// frame at rest (face/cast.h); shaders turn the head. Colours are linear RGB.
#pragma once

#include <cstdint>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "render/face/cast.h"
#include "render/gl/canvas.h"
#include "render/gl/program.h"
#include "render/scene/scene.h"

namespace kaori::passes {

// The uniform buffer binding point of FrameBlock, in all programs.
inline constexpr unsigned kFrameBinding = 0;

// std140: matrices by columns, each vector 16 bytes. What each part means stands in frame.glsl.
struct FrameBlock {
  // World to camera, and camera to clip space.
  glm::mat4 view;
  glm::mat4 projection;
  // The head's rotation, a quaternion: x, y, z, w.
  glm::vec4 turn;
  // xyz: the point about which the head turns; w: below this height the neck does not turn.
  glm::vec4 pivot;
  // xyz: how far the head is moved; w: above this height it turns wholly.
  glm::vec4 shift;
  // xyz: unit direction towards the key light, camera's frame; w: exposure.
  glm::vec4 key;
  // xyz: the same of the fill light; w: share of today's soft light.
  glm::vec4 fill;
  // xyz: the world's up in the camera's frame; w: metres that breath lifts the shoulders.
  glm::vec4 up;
  // xy: how far tips of hair swing over the forehead, radians, sideways and forwards; zw: what is drawn on, in pixels.
  glm::vec4 sway;
  // The same of hair on the character's left (xy) and right (zw).
  glm::vec4 sway_sides;
  // Camera to the key lamp's clip space: parallel light, the head and the collar within it.
  glm::mat4 lamp;
  // x: what covers no more than this of a pixel is left out: 0 where a pixel has samples for less than all of it.
  glm::vec4 least;
};

// Where the neck starts and ends to follow the head, from the reference face. Heights along Y: below the
// first it stays, above the second it turns with the head, and between them by part.
struct Neck {
  glm::vec3 pivot{};
  float still_below_m = 0;
  float turns_above_m = 0;
};
// From the lowest vertex of the reference face: still up to 16 mm above it, turned with the head from
// 62 mm on.
Neck NeckOf(const face::Cast& cast);
// The same for a collar whose upper end is at `collar_m`: a neck that stands in a higher collar turns above
// it.
Neck AboveCollar(Neck neck, float collar_m);

// `soft_share` 0..1: how much of the textured styles is today's soft light; the rest is the plain one of
// 1993. `layer_px`: width and height of what is drawn on, neither 0.
FrameBlock MakeFrame(const scene::Scene& scene, const Neck& neck, glm::vec2 layer_px, float soft_share);
// The same for a canvas's layer, with what of its pixels is left out.
FrameBlock MakeFrame(const scene::Scene& scene, const Neck& neck, const gl::Canvas& canvas, float soft_share);

// What a point of the figure follows, as frame.glsl moves it.
enum class Follows : std::uint8_t {
  kHead,  // The head's whole turn and shift.
  kSkin,  // The head's turn; below the head only a part of its shift. The neck lies between this and kBody.
  kBody,  // No turn, and a part of the shift.
};

// 0..1: how much of the head's shift a height of the figure at rest follows, as frame.glsl.
float LeanShare(const FrameBlock& frame, float height_m);

// A point of the figure at rest, where the frame moves it. Breath is left out.
glm::vec3 Placed(const FrameBlock& frame, glm::vec3 point, Follows follows);

// The same in the picture: x, y from -1 to 1, right and up, more outside of it.
glm::vec2 Project(const FrameBlock& frame, glm::vec3 point, Follows follows);
// Its height on what is drawn on, pixels from below.
float HeightOnLayer_px(const FrameBlock& frame, glm::vec3 point, Follows follows);

// Compiles a program of the shader library and binds its Frame block to kFrameBinding. `defines` are lines
// such as "#define TEXTURES 4\n". Errors: as gl::Program::Make.
Result<gl::Program> MakeProgram(std::string_view vertex, std::string_view fragment, std::string defines = {});

}  // namespace kaori::passes
