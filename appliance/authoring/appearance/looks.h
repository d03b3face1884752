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
#include "render/face/cast.h"

namespace kaori::appearance {

// A table, read by Table(): x rises.
using Knots = std::vector<glm::vec2>;

// What the face is covered with: paint is flat and clean, as on a mask or in print; a shell is enamelled
// plates.
enum class Hide { kSkin, kCoat, kMetal, kPaint, kShell };

// A round spot on each cheek, or a pair of nostrils: its middle on the character's left, and how far it
// reaches (to 1/e, where it fades as a bell).
struct Spot {
  // On the unrolled surface, as all places of a look.
  glm::vec2 at_cm{};
  glm::vec2 radii_cm{1, 1};
};

// A soft crease of age: a broad stroke of little strength through three points, on both sides of the face.
struct Crease {
  // Start, control point and end of a bent stroke.
  std::array<glm::vec2, 3> path_cm{};
  float half_width_cm = 0;
  float strength = 0;  // 0 .. 1, times the amount of its kind.
};
// One kind of creases, and how much of it.
struct Creases {
  float amount = 0;  // 0: none.
  std::vector<Crease> creases;
};

// A dog's coat: where its parts lie. Edges that fade have two numbers, from where to where.
struct CoatLook {
  Spot nose, nostrils;
  // The slit between nose and mouth: where it fades in and out, by height.
  glm::vec2 slit_top_cm{}, slit_bottom_cm{};
  glm::vec2 muzzle_y_cm{}, muzzle_x_cm{};  // Cream from the first to the second; outwards it ends at x.
  glm::vec2 blaze_x_cm{}, blaze_bottom_cm{}, blaze_top_cm{};
  glm::vec2 crown_y_cm{}, back_x_cm{};                // Darker fur.
  glm::vec2 neck_y_cm{}, cheek_x_cm{}, cheek_y_cm{};  // Where fur hangs to the side.
  std::vector<glm::vec2> whiskers_cm;
};

// A kettle of metal: heights of its parts on the unrolled surface.
struct MetalLook {
  float lid_groove_cm = 0;
  float knob_cm = 0;   // The knob's foot.
  float belly_cm = 0;  // Where soot begins.
};

// A shell of plates: its seams, as lines of the parameter space on the left half.
struct ShellLook {
  // A level seam at v, between two u.
  struct Level {
    float v_cm, from_cm, to_cm;
  };
  // u of the upright seams; the other half has their mirror images.
  std::vector<float> upright_cm;
  std::vector<Level> level;
  float rivets_cm = 1.5F;  // From rivet to rivet.
  // Slits in place of a nose: v of each and half its width.
  std::vector<glm::vec2> vents_cm;
  // From bar to bar of a grille in place of lips; 0: lips.
  float grille_cm = 0;
};

// [skin]: the hide and what is painted on it everywhere.
struct SkinLook {
  // The hide decides which of `coat`, `metal` and `shell` counts.
  Hide hide = Hide::kSkin;
  glm::vec3 base{};
  // The colour of blood under the skin: cheeks by `blush_amount`, nose, chin and ears by a fixed part.
  glm::vec3 blush{};
  float blush_amount = 0;
  // Of a shell: a disc, whose edge fades from the first to the second radius.
  Spot blush_spot;
  float freckles = 0;  // 0 none .. 1 many.
  Spot freckles_spot;
  // A shaved beard's shade, 0..1.
  float stubble = 0;
  // Of age: beside the nose, on the forehead, under the eyes.
  Creases lines;
  // Of great age: many more of them.
  Creases wrinkles;
  float gloss = 0.1F;  // 0 matt .. 1 wet.
  // How dark nostrils and the creases beside them are, 0..1.
  float nostrils = 1;
  Spot nostrils_spot;
  // Of the hide that is one; so are `metal` and `shell`.
  CoatLook coat;
  MetalLook metal;
  ShellLook shell;
};

// [brows]. Brows are painted first as a soft band, and hairs are drawn over it one by one.
struct BrowLook {
  glm::vec3 colour{};
  float amount = 0;  // 0: no brows.
  // From the nose outwards; u > 0.
  Knots path_cm;
  // Over 0..1 along the path.
  Knots half_width_cm;
  // Fine strokes a side; 0 paints a solid brow.
  int hairs = 0;
  // Of a solid brow's edge: 0 sharp .. 1 all fading.
  float smudge = 0;
};

// [lids]. Paint of the lids: shadow up to the fold, and a line along the lashes.
struct LidLook {
  // Amounts are 0..1 in all of these.
  glm::vec3 shadow{};
  float shadow_amount = 0;
  glm::vec3 liner{};
  float liner_amount = 0.95F;
  // The pink of the inner corner and of the rims; 0 on what is no flesh.
  float flesh = 1;
};

// [lips]. Paint of the lips, and of the mouth behind them.
struct LipLook {
  glm::vec3 colour{};
  float amount = 0;
  float gloss = 0.5F;
  glm::vec3 inside{};  // Of the mouth.
};

// [moustache]. Hairs fall from a line under the nose to both sides.
struct MoustacheLook {
  float amount = 0;  // 0: none.
  glm::vec3 colour{};
  // The line begins `from_cm` from the middle and reaches `reach_cm` outwards.
  float from_cm = 0;
  float reach_cm = 0;
  // Its height in the middle is `y_cm`; it falls by `fall_per_cm` times the square of the distance.
  float y_cm = 0;
  float fall_per_cm = 0;
  // In the middle; 70 % less at thins_over_cm.
  float thickness_cm = 0;
  float thins_over_cm = 1;
  // Hairs hang in the middle and lie along the line from here on.
  float turns_over_cm = 1;
  int hairs = 0;  // A side.
};

// [scalp]. Painted skin under the hair, above a line: height over distance from the middle.
struct ScalpLook {
  glm::vec3 colour{};
  Knots above_cm;  // Empty: none.
  // Of its edge: 0 is painted with a brush, 1 grows.
  float ragged = 1;
  // Strokes of a brush a side, from a parting in the middle to the sides, lighter than the ground; a few lie below its edge.
  int strands = 0;
};

// [eyes]. The iris and its lashes. `lash_wing_cm` is how far the outermost lash sticks out beyond the corner.
struct EyePaint {
  // As face::EyeLook, in centimetres.
  glm::vec3 iris{};
  float iris_radius_cm = 1;
  float lash_length_cm = 0;
  float lash_wing_cm = 0;
  // Of the ball.
  face::EyeSurface surface;
};

// [[hair.bundle]]. Hair that is gathered: a bun, a tail, a plait.
struct Bundle {
  // From the root to the tip, through all points smoothly; 2 to 32.
  std::vector<glm::vec3> path_cm;
  // Over 0..1 along the path.
  Knots radius_cm;
  // 2 to 24, side by side round it, wound by `twist_turns` from root to tip.
  int locks = 6;
  float twist_turns = 0.5F;
  bool mirrored = false;  // One on each side.
};

// [hair]. A cut, and the skull that it grows on. Angles go round the head in degrees: 0 in front, 180 behind,
// the same on both sides.
struct HairLook {
  std::string cut = "none";  // "none", "bob" or "swept".
  glm::vec3 colour{};
  // Hair lies on it, not on the sculpted face: it should be the face's own first body.
  Skull skull;
  // Of all that varies from lock to lock.
  std::uint32_t seed = 1;
  // Above the skull.
  float volume_cm = 0.45F;
  // As in Fall.
  float flare = 0.035F;
  float curl = 0.2F;
  // The bob's curtain starts this far round from the front; between 10 and 170.
  float opens_at_deg = 54;
  // Degrees round -> height of the ends.
  Knots ends_cm;
  // Degrees round -> height of the fringe; empty: no fringe.
  Knots fringe_cm;
  // The fringe's ends lie this much further round.
  float fringe_sweep_deg = 0;
  // Elevation of its front end, seen from straight ahead; 0: no parting.
  float parting_deg = 0;
  bool framing = false;  // Locks that frame the cheeks.
  // Degrees round -> elevation where combed hair starts. Of "swept" alone.
  Knots hairline_deg;
  std::vector<Bundle> bundles;
};

// [[gear]]. A hard thing worn on the head: one of a pair of glasses, of an antenna, of a hairpin.
struct GearLook {
  enum class Shape { kRod, kRing, kBall, kDisc };
  Shape shape = Shape::kRod;
  glm::vec3 colour{};
  // Of a rod.
  std::vector<glm::vec3> path_cm;
  // Of the others.
  glm::vec3 centre_cm{};
  // Of ring and disc; not along y.
  glm::vec3 facing{0, 0, 1};
  // Of a ball all three; of a ring sideways and up; of disc and rod the first.
  glm::vec3 radii_cm{1};
  // Of a ring's tube; of a disc.
  float thickness_cm = 0.15F;
  bool mirrored = false;  // One on each side.
};

// [clothes]. Each cut knows what main, collar and accent are on it (clothes.h).
struct ClothesLook {
  std::string cut = "none";  // "none", "blouse", "knit", "jacket", "fur", "kimono" or "hull".
  glm::vec3 main{};
  glm::vec3 collar{};
  glm::vec3 accent{};  // Ribbon, tie, tag.
  // Half the width over the shoulders' joints; between 5 and 25.
  float shoulders_cm = 15;
  // All sits so much higher: for a short neck.
  float rise_cm = 0;
};

// [surface]. How the renderer lights the face: `softness` 0 .. 1 lets light wrap round it, `metal` 0 .. 1
// mirrors the surroundings, `flat` is its one colour in the flat style, `folds` 0 .. 1 is how deep its wrinkles are where
// a graphics card draws them, `flush` 0 .. 1 how much it reddens with expressions that do. As face::SurfaceLook.
struct SurfacePaint {
  float softness = 1;
  float metal = 0;
  glm::vec3 flat{};
  float print = 0;  // 1: drawn as a poster print.
  float folds = 1;
  float flush = 0;
};

// Everything that looks/NAME.toml says.
struct FaceLook {
  // Parts whose table is left out have the values of their type: no brows, no scalp, no hair, no
  // gear, no clothes.
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

// Reads looks/<face>.toml. Errors: as ReadToml's; else invalid_argument with every fault, one a line, each
// with file, item and reason: "kaori.toml: lips.amount: ...".
Result<FaceLook> ReadLook(const std::filesystem::path& file);

}  // namespace kaori::appearance
