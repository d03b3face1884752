// One frame, described in plain values: what the face does, how it is drawn, and what stands behind it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/face/weights.h"

namespace kaori::scene {

// The four ways of drawing of 1993 (section 5 of Arai et al. 1994), and today's: wireframe, flat shaded,
// textured without hair, textured with hair, and textured with soft light.
enum class Style : std::uint8_t { kWire, kFlat, kBare, kHair, kSoft };
inline constexpr int kStyleCount = 5;
// In the order of Style: the words of show.toml.
inline constexpr std::array<const char*, kStyleCount> kStyleNames{"wire", "flat", "bare", "hair", "soft"};

// The pose of the head: a turn about the neck (face::Cast::neck_pivot), roll first, then pitch, then yaw;
// then a shift.
struct Head {
  // Positive turns to the character's left.
  float yaw_rad = 0;
  // Positive looks up.
  float pitch_rad = 0;
  // Positive leans to the character's left shoulder.
  float roll_rad = 0;
  // In the cast's frame: +X to the character's left, +Y up, +Z to the audience.
  glm::vec3 shift_m{};
};

// Where one eye looks, relative to the head.
struct Gaze {
  // Positive to the character's left.
  float yaw_rad = 0;
  // Positive looks up.
  float pitch_rad = 0;
};

// The key light is fixed to the camera; a fill light stands on its other side (render/passes/frame.cpp).
struct Light {
  // Direction towards the key light, in the camera's frame (+X right, +Y up, +Z to the viewer); need not be a
  // unit.
  glm::vec3 key{-0.45F, 0.55F, 0.75F};
  // Multiplies all light: 0 is black, 1 as the looks are made.
  float exposure = 1;
};

// Looks at its target from a distance, always upright.
struct Camera {
  // A little below the eyes, where the face's middle is in the picture.
  glm::vec3 target_m{0.0F, -0.004F, 0.0F};
  // From the target; Sane keeps it within 0.3 to 5 m.
  float distance_m = 0.95F;
  // Round the target; positive looks from the character's left.
  float yaw_rad = 0;
  // Above the target's level; positive looks down.
  float height_rad = 0;
  // Vertical.
  float field_of_view_rad = 0.362F;
};

// What stands behind the character, softly, out of focus.
enum class BackdropKind : std::uint8_t {
  kGradient,  // From top to bottom, nothing else.
  kStudio,    // A sweep of paper with a pool of light.
  kCurtain,   // The folds of a theatre's curtain.
  kNight,     // A moon and lights far away.
  kKitchen,   // Tiles and a window's light.
  kPine,      // The painted pine of a Noh stage.
  kLights,    // Many lamps, as in a laboratory.
  kRays,      // A printed poster's rays.
  kNursery,   // Hills, stars and a warm lamp.
  kPicture,   // One of the show's own pictures.
};
inline constexpr int kBackdropKindCount = 10;

// Colours are linear RGB.
struct Backdrop {
  // Of the gradient, and the two main colours of the other kinds.
  glm::vec3 top{0.053F, 0.080F, 0.144F};
  glm::vec3 bottom{0.011F, 0.014F, 0.030F};
  BackdropKind kind = BackdropKind::kGradient;
  // Of lamps, moon and rays; gradients and pictures have none.
  glm::vec3 glow{1.0F, 0.80F, 0.55F};
  // Index into face::Cast::textures, for kPicture; one that does not exist shows the gradient.
  int picture = -1;

  bool operator==(const Backdrop&) const = default;
};

// A backdrop that is on its way out. Without weight it is not drawn.
struct FadingBackdrop {
  Backdrop backdrop;
  // 0..1.
  float weight = 0;
};
// Of more that fade at once, the heaviest are shown.
inline constexpr std::size_t kMostFading = 3;

// The control points as handles of the editor: needles that stick in the face (figure 3 of Arai et al. 1994).
struct Handles {
  // 0 none .. 1; in between they grow out of the skin.
  float shown = 0;
  // The control point whose handle is pulled; -1: none.
  int chosen = -1;
  // The one that moves with it on the other side; -1: none.
  int partner = -1;
  // For each control point how far it is pulled; drawn longer and warmer. Missing ones count as 0.
  std::vector<float> pulls_m;
};

// Lines of text at the left below, for whoever works at the box: never in a show.
struct Caption {
  // 0 none .. 1.
  float shown = 0;
  // UTF-8; the last one lowest.
  std::vector<std::string> lines;
};

// Parts of hair that swing each in its own time: over the forehead, and on the character's left and right.
enum class HairPart : std::uint8_t { kFringe, kLeft, kRight };
inline constexpr std::size_t kHairPartCount = 3;

// All that a painter needs to know besides the cast. Values that are no numbers, or lie far out, are replaced
// before they are drawn (render/passes/sane_scene.h), so a writer of scenes need not check them.
struct Scene {
  // What is composed: faces, expressions, channels and lids.
  face::Weights weights;
  // The character's left, right.
  std::array<Gaze, 2> gaze{};
  Head head;
  // Cross-fade, by Style; sum 1.
  std::array<float, kStyleCount> styles{0, 0, 0, 0, 1};
  Light light;
  Camera camera;
  // Has the weight that is left by those that fade.
  Backdrop backdrop;
  // Weights sum to 1 at most.
  std::array<FadingBackdrop, kMostFading> fading;
  // 0: the character has left the picture, and the backdrop stands alone .. 1: is there whole.
  float present = 1;
  // How far tips of hair swing, sideways and forwards: by HairPart.
  std::array<glm::vec2, kHairPartCount> hair_sway_rad{};
  // -1 out .. 1 in.
  float breath = 0;
  // The size of the pupils, as a factor: 1 is as the looks are made.
  float pupil = 1;
  // Of the expression editor; none in a show.
  Handles handles;
  Caption caption;
};

}  // namespace kaori::scene
