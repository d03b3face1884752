// What happens to fragments on their way into the picture.
#pragma once

#include <cstdint>

namespace kaori::gl {

enum class Cull : std::uint8_t { kNone, kBack };
enum class Depth : std::uint8_t { kOff, kTestAndWrite, kTestOnly };
enum class Blend : std::uint8_t {
  kReplace,
  kOver,       // Colour over what is there, by the fragment's alpha (not premultiplied).
  kBrightest,  // The larger of both, channel by channel.
  kCoverage,   // Alpha chooses how many samples of the pixel are written; needs a canvas with samples.
};

struct DrawState {
  Cull cull = Cull::kBack;
  Depth depth = Depth::kTestAndWrite;
  Blend blend = Blend::kReplace;
  bool push_back = false;  // Lets lines that lie on these triangles win against them.
};

void Apply(const DrawState& state);

}  // namespace kaori::gl
