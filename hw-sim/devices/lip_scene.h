// An operator before the lip camera as it goes on a stage: light, paint, clothes, hands, a head that moves,
// and a camera that adds its own. Pictures with known truth, for measuring what measures lips.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "hw-sim/devices/lip_picture.h"

namespace kaori::sim {

// sRGB, 0 .. 1.
struct Rgb {
  float red = 0;
  float green = 0;
  float blue = 0;
};

// Lengths are in widths of the mouth at rest at the head's usual distance; y runs down.
struct HeadPose {
  double x = 0;  // Of the middle of the mouth at rest, from its usual position.
  double y = 0;
  double scale = 1;     // More is nearer.
  double tilt_rad = 0;  // Positive: clockwise in the picture, about the mouth.
};

struct Operator {
  Mouth mouth;
  double smile_left = 0;  // How far the corner at the picture's left, right is raised.
  double smile_right = 0;
  Rgb paint{0.08F, 0.24F, 0.78F};
  HeadPose head;
  bool marker = false;         // A dot of paint on the nose, one width above the mouth.
  std::optional<Rgb> shirt;    // Reaches from below the chin to the picture's edge.
  std::optional<double> hand;  // A hand before the face, its middle so far to the right.
};

struct StageLight {
  double level = 1;
  Rgb colour{1, 1, 1};
  std::optional<double> shadow_from;  // To the right of this line on the face, in widths from its middle,
  double shadow_level = 0.4;          // so much of the light is left.
};

struct LensAndChip {
  double gain = 1;
  Rgb balance{1, 1, 1};        // What the white balance multiplies.
  double noise_steps = 2;      // Standard deviation, of luma and of chroma.
  std::uint32_t sequence = 0;  // Of the noise.
};

struct LipScene {
  Operator person;
  std::optional<HeadPose>
      head_before;  // Where the head was when the shutter opened: it is smeared from there.
  StageLight light;
  LensAndChip camera;
};

// Draws all of it. The same scene gives the same picture.
void PaintScene(const LipScene& scene, const YuyvPicture& into);

}  // namespace kaori::sim
