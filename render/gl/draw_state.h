// What happens to fragments on their way into the picture.
#pragma once

#include <cstdint>

#include "render/gl/box.h"

namespace kaori::gl {

// Triangles that are left out: none, or those that turn their back (clockwise as seen).
enum class Cull : std::uint8_t { kNone, kBack };
// Against the layer's depth; the picture has none.
enum class Depth : std::uint8_t { kOff, kTestAndWrite, kTestOnly };
// How a fragment meets the colour that is there.
enum class Blend : std::uint8_t {
  // The fragment takes the place of what is there.
  kReplace,
  kOver,       // Colour over what is there, by the fragment's alpha (not premultiplied).
  kBrightest,  // The larger of both, channel by channel.
  kCoverage,   // Alpha chooses how many samples of the pixel are written; needs a canvas with samples.
};

// The fixed functions between a fragment shader and the framebuffer. Stencil and colour masks are never used;
// the scissor test is the canvas's.
struct DrawState {
  Cull cull = Cull::kBack;
  Depth depth = Depth::kTestAndWrite;
  Blend blend = Blend::kReplace;
  // Lets lines that lie on these triangles win against them.
  bool push_back = false;
};

// Sets all of it at once for what is drawn next, so that no pass depends on the one before it. On
// the current context.
void Apply(const DrawState& state);

// Limits drawing on the framebuffer that is bound to `box`, by the scissor test, which it turns on.
void CutTo(const Box& box);

}  // namespace kaori::gl
