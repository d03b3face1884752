#include "appliance/authoring/sculpt/paint_attributes.h"

#include <algorithm>
#include <cmath>

#include "appliance/authoring/sculpt/spout_patch.h"

namespace kaori::sculpt {
namespace {

// Corners count as above.
// Rings above the eye are positive and those below it negative.
PaintAttributes OfEye(const Key& key) {
  const float sign = key.a <= kEyeRim / 2 ? 1.0F : -1.0F;
  return {.eye_ring = sign * static_cast<float>(key.b)};
}

// The ring number is held at 6 in the bag: where upper and lower half are sewn together it would else run
// through zero, and lips would be painted in the throat.
PaintAttributes OfMouth(const Key& key) {
  const float sign = key.a <= kMouthCorner ? 1.0F : -1.0F;
  return {.mouth_ring = sign * static_cast<float>(std::min(key.b, kLipContactRing)),
          .bag = key.b > kLipContactRing ? 1.0F : 0.0F};
}

// The spout's rim is half of its inside, where the paint changes from one to the other; its foot is the
// body's.
PaintAttributes OfGrid(const Key& key) {
  if (!IsOnSpoutPatch(key)) return {};
  switch (SpoutPartOf(key)) {
    case SpoutPart::kFoot:
      return {};
    case SpoutPart::kRim:
      return {.spout = 0.5F};
    case SpoutPart::kInside:
      break;
  }
  return {.spout = 1};
}

// An ear counts from its rim outwards: 1 at the last ring and all over the cap.
PaintAttributes Of(const Key& key) {
  switch (key.region) {
    case Region::kGrid:
      return OfGrid(key);
    case Region::kEye:
      return OfEye(key);
    case Region::kMouth:
      return OfMouth(key);
    case Region::kEar:
      return {.ear_ring = static_cast<float>(key.b) / static_cast<float>(kEarRings)};
    case Region::kEarCap:
      break;
  }
  return {.ear_ring = 1};
}

}  // namespace

std::vector<PaintAttributes> PaintAttributesOf(const Cage& cage) {
  std::vector<PaintAttributes> attributes;
  attributes.reserve(cage.vertices.size());
  for (Index v = 0; v < cage.vertices.size(); ++v) attributes.push_back(Of(cage.key(v)));
  return attributes;
}

}  // namespace kaori::sculpt
