#include "hw-sim/hil/held_picture.h"

#include <algorithm>

#include "hw-sim/hil/picture.h"

namespace kaori::hil {

// One file for all looks: the report shows the first picture and what was counted.
Result<void> HeldPicture::Look(Scene& scene) {
  const std::string file = scene.folder + "/held-now.png";
  if (auto ok = scene.target.machine().Shoot(0, file); !ok) return ok;
  const auto apart = MeanDifference(face, file);
  if (!apart) return tl::unexpected(apart.error());
  ++pictures;
  wrong += *apart > kMovedByItself ? 1 : 0;
  largest = std::max(largest, *apart);
  return {};
}

Result<HeldPicture> HoldFace(Scene& scene, const std::string& name, const std::string& caption) {
  if (auto ok = scene.ShootFace(name, caption); !ok) return tl::unexpected(ok.error());
  return HeldPicture{.face = scene.folder + "/" + scene.finding.pictures.back().file};
}

}  // namespace kaori::hil
