#include "appliance/authoring/sculpt/spout_patch.h"

#include <algorithm>
#include <cmath>

#include "appliance/authoring/sculpt/disc.h"

namespace kaori::sculpt {
namespace {

// The patch by grid lines: x 0 .. 1, y -1 .. 1.
glm::dvec2 OnSquare(const Key& key) {
  const double half_height = 0.5 * (kSpoutPatch.row1 - kSpoutPatch.row0);
  const double middle = 0.5 * (kSpoutPatch.row1 + kSpoutPatch.row0);
  return {static_cast<double>(key.a) / kSpoutPatch.column1, (key.b - middle) / half_height};
}

}  // namespace

bool IsOnSpoutPatch(const Key& key) {
  return key.region == Region::kGrid && key.a <= kSpoutPatch.column1 && key.b >= kSpoutPatch.row0 &&
         key.b <= kSpoutPatch.row1;
}

glm::dvec2 OnSpoutDisc(const Key& key) {
  return DiscFromSquare(OnSquare(key));
}

SpoutPart SpoutPartOf(const Key& key) {
  const glm::dvec2 square = OnSquare(key);
  // Square rings about the patch's middle, counted by index: its outermost lines are the foot, the
  // next the rim.
  const double outwards = std::max(square.x, std::abs(square.y));
  if (outwards > 0.9) return SpoutPart::kFoot;
  return outwards > 0.5 ? SpoutPart::kRim : SpoutPart::kInside;
}

}  // namespace kaori::sculpt
