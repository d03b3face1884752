// How one face looks: everything about it that a person may want to change without a compiler.
// Colours are linear; lengths are centimetres of the reference face.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "appliance/authoring/appearance/skull.h"
#include "drivers/base/result.h"

namespace kaori::appearance {

using Knots = std::vector<glm::vec2>;  // A table: x ascending.

// What the face is covered with: paint is flat and clean, as on a mask or in print; a shell is enamelled
// plates.
enum class Hide { kSkin, kCoat, kMetal, kPaint, kShell };

struct SkinLook {
  Hide hide = Hide::kSkin;
  glm::vec3 base{};
  glm::vec3 blush{};
  float blush_amount = 0;
  float freckles = 0;  // 0 none .. 1 many.
  float stubble = 0;   // A shaved beard's shade.
  float lines = 0;     // Of age: beside the nose, on the forehead, under the eyes.
  float wrinkles = 0;  // Of great age: many more of them.
  float gloss = 0.1F;  // 0 matt .. 1 wet.
  float nostrils = 1;
};

struct BrowLook {
  glm::vec3 colour{};
  float amount = 0;     // 0: no brows.
  Knots path_cm;        // From the nose outwards; u > 0.
  Knots half_width_cm;  // Over 0..1 along the path.
  int hairs = 0;        // Fine strokes a side; 0 paints a solid brow.
  float smudge = 0;     // Of a solid brow's edge: 0 sharp .. 1 all fading.
};

struct LidLook {
  glm::vec3 shadow{};
  float shadow_amount = 0;
  glm::vec3 liner{};
  float liner_amount = 0.95F;
  float flesh = 1;  // The pink of the inner corner and of the rims; 0 on what is no flesh.
};

struct LipLook {
  glm::vec3 colour{};
  float amount = 0;
  float gloss = 0.5F;
  glm::vec3 inside{};  // Of the mouth.
};

struct MoustacheLook {
  float amount = 0;  // 0: none.
  glm::vec3 colour{};
};

// Painted skin under the hair, above a line: height over distance from the middle.
struct ScalpLook {
  glm::vec3 colour{};
  Knots above_cm;    // Empty: none.
  float ragged = 1;  // Of its edge: 0 is painted with a brush, 1 grows.
};

struct EyePaint {
  glm::vec3 iris{};
  float iris_radius_cm = 1;
  float lash_length_cm = 0;
  float lash_wing_cm = 0;
};

// Hair that is gathered: a bun, a tail, a plait.
struct Bundle {
  std::vector<glm::vec3> path_cm;  // From the root to the tip.
  Knots radius_cm;                 // Over 0..1 along the path.
  int locks = 6;                   // Side by side round it,
  float twist_turns = 0.5F;        // wound so far from root to tip.
  bool mirrored = false;           // One on each side.
};

struct HairLook {
  std::string cut = "none";  // "none", "bob" or "swept".
  glm::vec3 colour{};
  Skull skull;
  std::uint32_t seed = 1;
  float volume_cm = 0.45F;  // Above the skull.
  float flare = 0.035F;
  float curl = 0.2F;
  float opens_at_deg = 54;  // The bob's curtain starts this far round from the front.
  Knots ends_cm;            // Degrees round -> height of the ends.
  Knots fringe_cm;          // Degrees round -> height of the fringe; empty: no fringe.
  float fringe_sweep_deg = 0;
  float parting_deg = 0;  // Elevation of its front end, seen from straight ahead; 0: no parting.
  bool framing = false;   // Locks that frame the cheeks.
  Knots hairline_deg;     // Degrees round -> elevation where combed hair starts.
  std::vector<Bundle> bundles;
};

// A hard thing worn on the head: one of a pair of glasses, of an antenna, of a hairpin.
struct GearLook {
  enum class Shape { kRod, kRing, kBall, kDisc };
  Shape shape = Shape::kRod;
  glm::vec3 colour{};
  std::vector<glm::vec3> path_cm;  // Rod.
  glm::vec3 centre_cm{};           // The others.
  glm::vec3 facing{0, 0, 1};       // Ring, disc: not along y.
  glm::vec3 radii_cm{1};           // Ball; ring: sideways and up. Disc, rod: the first.
  float thickness_cm = 0.15F;      // Ring.
  bool mirrored = false;           // One on each side.
};

struct ClothesLook {
  std::string cut = "none";  // "none", "blouse", "knit", "jacket", "fur", "kimono" or "hull".
  glm::vec3 main{};
  glm::vec3 collar{};
  glm::vec3 accent{};       // Ribbon, tie, tag.
  float shoulders_cm = 15;  // Half the width over the shoulders' joints.
  float rise_cm = 0;        // All sits so much higher: for a short neck.
};

struct SurfacePaint {
  float softness = 1;
  float metal = 0;
  glm::vec3 flat{};
  float print = 0;  // 1: drawn as a poster print.
};

struct FaceLook {
  SkinLook skin;
  BrowLook brows;
  LidLook lids;
  LipLook lips;
  MoustacheLook moustache;
  ScalpLook scalp;
  EyePaint eyes;
  HairLook hair;
  std::vector<GearLook> gear;
  ClothesLook clothes;
  SurfacePaint surface;
};

// Reads looks/<face>.toml. A fault names the file, the item and the reason: "kaori.toml: lips.amount: ...".
Result<FaceLook> ReadLook(const std::filesystem::path& file);

}  // namespace kaori::appearance
