#include "appliance/authoring/sculpt/kettle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "appliance/authoring/sculpt/ear_tube.h"
#include "appliance/authoring/sculpt/pchip.h"
#include "appliance/authoring/sculpt/spout_patch.h"
#include "appliance/authoring/sculpt/warp.h"

namespace kaori::sculpt {
namespace {

constexpr double kKettleOnMiddle_cm = 1e-9;
constexpr double kRadiansPerDegree = std::numbers::pi / 180;

// The part of the grid that carries eyes and mouth: they are bent with it onto the wall.
constexpr Block kFacePart{0, 13, 7, 28};

// Rings are not in it: they are what is bent.
bool IsInFacePart(const Key& key) {
  return key.region == Region::kGrid && key.a <= kFacePart.column1 && key.b >= kFacePart.row0 &&
         key.b <= kFacePart.row1;
}

// A surface of revolution about y: row gives radius and height, column the angle. The crown's row is folded
// into a ridge across the knob, since it lies on x = 0.
void TurnGrid(const HalfTopology& half, const Turned& recipe, HalfShape& shape) {
  const Pchip radius(recipe.profile_rows, recipe.profile_radius);
  const Pchip height(recipe.profile_rows, recipe.profile_y);
  const Pchip angle(recipe.columns, recipe.angles_deg);
  for (Index v = 0; v < half.keys.size(); ++v) {
    const Key& key = half.keys[v];
    if (key.region != Region::kGrid) continue;
    const double a = angle.At(key.a) * kRadiansPerDegree;
    if (key.b == kRows) {
      shape.position[v] = {0, recipe.knob_y - 0.25 * std::cos(a) * std::cos(a),
                           recipe.knob_radius * std::cos(a)};
    } else {
      const double r = radius.At(key.b);
      shape.position[v] = {r * std::sin(a), height.At(key.b), r * std::cos(a)};
    }
  }
}

// All grid vertices about eyes and mouth are landmarks: exact at the blocks' rims, smooth inside. False where
// two of them fall on one point. Some 250 pulls: the largest system that is solved in this folder.
bool BendFaceOntoWall(const HalfTopology& half, const HalfShape& reference, HalfShape& shape) {
  std::vector<Pull> pulls;
  for (Index v = 0; v < half.keys.size(); ++v) {
    if (IsInFacePart(half.keys[v])) pulls.push_back({reference.position[v], shape.position[v]});
  }
  const auto warp = Warp::Through(std::move(pulls));
  if (!warp) return false;
  for (Index v = 0; v < half.keys.size(); ++v) {
    const Region region = half.keys[v].region;
    if (region == Region::kEye || region == Region::kMouth)
      shape.position[v] = (*warp)(reference.position[v]);
  }
  return true;
}

// From corner to corner, as x alone: the ball is seen from the front.
double LidWidth(const HalfTopology& half, const HalfShape& shape) {
  double low = 1e9;
  double high = -1e9;
  for (int j = 0; j < kEyeRim; ++j) {
    const double x = shape.position[half.At(Region::kEye, j, kLidRing)].x;
    low = std::min(low, x);
    high = std::max(high, x);
  }
  return high - low;
}

// The mean of the lids' edge all round: where the middle of the eye's opening lies.
glm::dvec3 LidMiddle(const HalfTopology& half, const HalfShape& shape) {
  glm::dvec3 middle{};
  for (int j = 0; j < kEyeRim; ++j) {
    middle += shape.position[half.At(Region::kEye, j, kLidRing)] / static_cast<double>(kEyeRim);
  }
  return middle;
}

// The ball grows with the lids, and sits so far behind them that their edge can lie on it: h^2 = R^2 - (0.56
// width)^2, half the chord with a margin, along the gaze.
Ball FitBall(const HalfTopology& half, const HalfShape& reference, const EyeRecipe& eye, const Turned& recipe,
             const HalfShape& shape) {
  const double width = LidWidth(half, shape);
  const double radius = eye.radius * width / LidWidth(half, reference) * 1.02;
  const double yaw = recipe.eye_yaw_deg * kRadiansPerDegree;
  const glm::dvec3 gaze = glm::normalize(glm::dvec3(std::sin(yaw), 0.08, std::cos(yaw)));
  const double half_chord = 0.56 * width;
  const double depth = std::sqrt(std::max(0.1, radius * radius - half_chord * half_chord));
  return {LidMiddle(half, shape) - gaze * (1.04 * depth), radius, recipe.lid_thickness};
}

// Lips stand out from the wall, most in the middle; rings 3 to 6 by kShare of `relief`.
void RaiseLips(const HalfTopology& half, double relief, HalfShape& shape) {
  constexpr std::array<double, 4> kShare{0.3, 0.8, 1, 0.3};
  for (int k = kLipBorderRing; k <= kLipContactRing; ++k) {
    for (int j = 0; j < kMouthRim; ++j) {
      const double from_corner = std::abs(j - kMouthCorner) / 8.0;
      shape.position[half.At(Region::kMouth, j, k)].z +=
          relief * kShare[static_cast<std::size_t>(k - kLipBorderRing)] *
          std::sin(std::numbers::pi / 2 * from_corner);
    }
  }
}

// The wall has flattened the corners of the mouth: their rings go inwards again, one behind the other,
// so that an expression cannot push one before the next. Within three rim positions of the corner, least
// at the border.
void TuckCorners(const HalfTopology& half, HalfShape& shape) {
  constexpr std::array<double, 8> kTuck_cm{0, 0.1, 0.2, 0.32, 0.4, 0.4, 0.4, 0.4};  // Rings 3 .. 10.
  constexpr double kReach = 3;                                                      // Columns.
  for (int j = 0; j < kMouthRim; ++j) {
    const double near = std::max(0.0, 1 - std::abs(j - kMouthCorner) / kReach);
    for (int k = kLipBorderRing; k <= kMouthRings; ++k) {
      shape.position[half.At(Region::kMouth, j, k)].z -=
          near * kTuck_cm[static_cast<std::size_t>(k - kLipBorderRing)];
    }
  }
}

// Grows the mouth about its middle and keeps it on the wall, a circle of radius `wall` about the axis; the
// rings around the lips grow less, and the rim not at all.
void EnlargeMouth(const HalfTopology& half, double scale, double wall, HalfShape& shape) {
  constexpr std::array<double, kMouthRings + 1> kShare{0, 0.45, 0.84, 1, 1, 1, 1, 1, 1, 1, 1};
  // z of the wall at x; held above 1 cm beyond its side.
  const auto depth = [wall](double x) { return std::sqrt(std::max(1.0, wall * wall - x * x)); };
  const glm::dvec3 middle = 0.5 * (shape.position[half.At(Region::kMouth, 0, kLipContactRing)] +
                                   shape.position[half.At(Region::kMouth, kMouthRim - 1, kLipContactRing)]);
  for (int k = 1; k <= kMouthRings; ++k) {
    const double grow = 1 + (scale - 1) * kShare[static_cast<std::size_t>(k)];
    for (int j = 0; j < kMouthRim; ++j) {
      glm::dvec3& p = shape.position[half.At(Region::kMouth, j, k)];
      const double old_depth = depth(p.x);
      p.x = middle.x + (p.x - middle.x) * grow;
      p.y = middle.y + (p.y - middle.y) * grow;
      p.z += depth(p.x) - old_depth;
    }
  }
}

// The foot lies between the wall and an ellipse on the axis, the rim is a circle at the tip, the inside a
// smaller one behind it.
glm::dvec3 SpoutPoint(const Spout& spout, const Key& key, glm::dvec3 wall) {
  const glm::dvec3 axis = glm::normalize(spout.tip - spout.foot);
  const glm::dvec3 up = glm::normalize(glm::dvec3(0, 1, 0) - axis * axis.y);
  const glm::dvec2 disc = OnSpoutDisc(key);
  // The middle of the patch has no direction: 1e-9 keeps it in the middle.
  const glm::dvec2 round = disc / (glm::length(disc) + 1e-9);
  const auto across = [&](double x, double y) { return glm::dvec3(x, 0, 0) + up * y; };
  switch (SpoutPartOf(key)) {
    case SpoutPart::kFoot:
      return 0.35 * wall + 0.65 * (spout.foot + axis * spout.foot_out +
                                   across(disc.x * spout.foot_width, disc.y * spout.foot_height));
    case SpoutPart::kRim:
      return spout.tip + across(round.x * spout.rim_radius, round.y * spout.rim_radius);
    case SpoutPart::kInside:
      break;
  }
  return spout.tip - axis * spout.hole_depth +
         across(round.x * spout.hole_radius, round.y * spout.hole_radius);
}

// The wall as it was before is part of where the foot stands, so that each vertex is moved once.
void DrawOutSpout(const HalfTopology& half, const Spout& spout, HalfShape& shape) {
  for (Index v = 0; v < half.keys.size(); ++v) {
    if (IsOnSpoutPatch(half.keys[v])) shape.position[v] = SpoutPoint(spout, half.keys[v], shape.position[v]);
  }
}

}  // namespace

// The order matters: the ball is fitted to lids that were bent, lips are raised before they grow, spout and
// handle start from a finished wall.
Result<Kettle> Turn(const HalfTopology& half, const HalfShape& reference, const EyeRecipe& eye,
                    const Turned& recipe) {
  Kettle kettle{reference, {}};
  HalfShape& shape = kettle.shape;
  TurnGrid(half, recipe, shape);
  if (!BendFaceOntoWall(half, reference, shape)) return FailInput("profile: it folds the face");
  kettle.eye = FitBall(half, reference, eye, recipe, shape);
  FitLids(half, kettle.eye, kettle.eye.lid_thickness + kSkinOverLid_cm, shape);
  RaiseLips(half, recipe.lip_relief, shape);
  TuckCorners(half, shape);
  EnlargeMouth(half, recipe.mouth_scale, recipe.wall_radius, shape);
  DrawOutSpout(half, recipe.spout, shape);
  DrawOutEar(half, recipe.handle, shape);
  for (Index v = 0; v < half.keys.size(); ++v) {
    // What lies in the middle of the reference lies in the middle here, to the last bit.
    if (std::abs(reference.position[v].x) < kKettleOnMiddle_cm) shape.position[v].x = 0;
  }
  return kettle;
}

}  // namespace kaori::sculpt
