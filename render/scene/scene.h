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

// The four ways of drawing of 1993, and today's.
enum class Style : std::uint8_t { kWire, kFlat, kBare, kHair, kSoft };
inline constexpr int kStyleCount = 5;

struct Head {
  float yaw_rad = 0;    // Positive turns to the character's left.
  float pitch_rad = 0;  // Positive looks up.
  float roll_rad = 0;   // Positive leans to the character's left shoulder.
  glm::vec3 shift_m{};
};

struct Gaze {
  float yaw_rad = 0;  // Relative to the head; positive to the character's left.
  float pitch_rad = 0;
};

struct Light {
  glm::vec3 key{-0.45F, 0.55F, 0.75F};  // Direction towards the key light, camera frame; need not be a unit.
  float exposure = 1;                   // 0 is black.
};

struct Camera {
  glm::vec3 target_m{0.0F, -0.004F, 0.0F};
  float distance_m = 0.95F;
  float yaw_rad = 0;  // Round the target; positive looks from the character's left.
  float height_rad = 0;
  float field_of_view_rad = 0.362F;  // Vertical.
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
  glm::vec3 top{0.053F, 0.080F, 0.144F};
  glm::vec3 bottom{0.011F, 0.014F, 0.030F};
  BackdropKind kind = BackdropKind::kGradient;
  glm::vec3 glow{1.0F, 0.80F, 0.55F};  // Of lamps, moon and rays; gradients and pictures have none.
  int picture = -1;                    // kPicture: which one.

  bool operator==(const Backdrop&) const = default;
};

// A backdrop that is on its way out; what has no weight is not there.
struct FadingBackdrop {
  Backdrop backdrop;
  float weight = 0;  // 0..1.
};
inline constexpr std::size_t kMostFading = 3;

// The control points as handles that stick in the face in work (the paper's figure 3).
struct Handles {
  float shown = 0;             // 0 none .. 1.
  int chosen = -1;             // The control point whose handle is pulled; -1: none.
  int partner = -1;            // The one that moves with it on the other side.
  std::vector<float> pulls_m;  // For each control point: how far it is pulled; drawn longer and warmer.
};

// Lines of text at the left below, for whoever works at the box: never in a show.
struct Caption {
  float shown = 0;                 // 0 none .. 1.
  std::vector<std::string> lines;  // UTF-8; the last one lowest.
};

struct Scene {
  face::Weights weights;
  std::array<Gaze, 2> gaze{};  // The character's left, right.
  Head head;
  std::array<float, kStyleCount> styles{0, 0, 0, 0, 1};  // Cross-fade; sum 1.
  Light light;
  Camera camera;
  Backdrop backdrop;                               // Has the weight that is left by those that fade.
  std::array<FadingBackdrop, kMostFading> fading;  // Weights sum to 1 at most.
  glm::vec2 hair_sway_rad{};                       // Tips swing: sideways, forwards.
  float breath = 0;                                // -1 out .. 1 in.
  Handles handles;
  Caption caption;
};

}  // namespace kaori::scene
