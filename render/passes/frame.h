// What all passes of a frame share, in the layout that shaders read (render/shaders/frame.glsl).
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "render/face/cast.h"
#include "render/gl/program.h"
#include "render/scene/scene.h"

namespace kaori::passes {

inline constexpr unsigned kFrameBinding = 0;

// std140. The comments stand in frame.glsl.
struct FrameBlock {
  glm::mat4 view;
  glm::mat4 projection;
  glm::vec4 turn;
  glm::vec4 pivot;
  glm::vec4 shift;
  glm::vec4 key;
  glm::vec4 fill;
  glm::vec4 up;
  glm::vec4 sway;
};

// Where the neck starts and ends to follow the head, from the reference face. Heights in metres.
struct Neck {
  glm::vec3 pivot{};
  float still_below_m = 0;
  float turns_above_m = 0;
};
Neck NeckOf(const face::Cast& cast);

// `soft_share` as FrameBlock::fill.w.
FrameBlock MakeFrame(const scene::Scene& scene, const Neck& neck, glm::vec2 canvas_px, float soft_share);

// A point of the head in the picture: x, y from -1 to 1. Follows the whole turn.
glm::vec2 Project(const FrameBlock& frame, glm::vec3 point, bool turns);

// Compiles a program of the shader library and binds its Frame block.
Result<gl::Program> MakeProgram(std::string_view vertex, std::string_view fragment, std::string defines = {});

}  // namespace kaori::passes
