// An operator before the lip camera as it goes on a stage: light, paint, clothes, hands, a head that moves,
// and a camera that adds its own. Pictures with known truth, for measuring what measures lips.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "hw-sim/devices/lip_picture.h"

namespace kaori::sim {

// A colour as people give it: sRGB, 0 .. 1, before any light falls on it.
struct Rgb {
  float red = 0;
  float green = 0;
  float blue = 0;
};

// Where the head is, as a rigid flat thing. Lengths are in widths of the mouth at rest at
// the head's usual distance; y runs down.
struct HeadPose {
  double x = 0;  // Of the middle of the mouth at rest, from its usual position.
  double y = 0;
  double scale = 1;     // More is nearer.
  double tilt_rad = 0;  // Positive: clockwise in the picture, about the mouth.
};

// The person before the camera. Everything but `mouth` is what an ideal lip reader would not see.
struct Operator {
  // What a lip reader is to measure.
  Mouth mouth;
  // How far the corner at the picture's left, and right, is raised.
  double smile_left = 0;
  double smile_right = 0;
  // The blue that is painted on lips.
  Rgb paint{0.08F, 0.24F, 0.78F};
  HeadPose head;
  bool marker = false;         // A dot of paint on the nose, one width above the mouth.
  std::optional<Rgb> shirt;    // Reaches from below the chin to the picture's edge.
  std::optional<double> hand;  // A hand before the face, its middle so far to the right.
};

// The light that falls on the whole scene; 1 of white shows colours as they are. More saturates the chip.
struct StageLight {
  // How much light there is; 1 is what the camera was set for.
  double level = 1;
  // Each channel's part of the level; white is 1, 1, 1.
  Rgb colour{1, 1, 1};
  // To the right of this line on the face, in widths from its middle,
  // `shadow_level` of the light is left.
  std::optional<double> shadow_from;
  // Of the light, 0 .. 1.
  double shadow_level = 0.4;
};

// What the camera adds to the picture, in this order: gain and balance on linear
// light, noise on the encoded bytes.
struct LensAndChip {
  // What the chip multiplies all light by.
  double gain = 1;
  Rgb balance{1, 1, 1};        // What the white balance multiplies.
  double noise_steps = 2;      // Standard deviation, of luma and of chroma.
  std::uint32_t sequence = 0;  // Of the noise.
};

// One frame: a moment, or the stretch of time during which the shutter was open.
struct LipScene {
  // Who is before the camera at the end of the exposure.
  Operator person;
  // Where the head was when the shutter opened: the picture is smeared from
  // there to the person's own pose.
  std::optional<HeadPose> head_before;
  StageLight light;
  LensAndChip camera;
};

// Draws all of it, over whatever `into` held; five moments where the head moves. The same scene gives the
// same picture. Pure.
void PaintScene(const LipScene& scene, const YuyvPicture& into);

}  // namespace kaori::sim
