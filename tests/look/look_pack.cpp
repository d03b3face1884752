#include "tests/look/look_pack.h"

#include <cstdlib>

#include "appliance/core/show/pack.h"
#include "drivers/base/log.h"

namespace kaori::tests {

face::Cast ClothedCast() {
  auto show = show::LoadPack(KAORI_PACK);
  if (!show) {
    Log("{}", show.error().message());
    std::abort();
  }
  face::Cast cast = std::move(show->cast);
  for (face::Texture& texture : cast.textures) {
    texture = {.width_px = 1, .height_px = 1, .rgba = {128, 128, 128, 0}};
  }
  for (face::Prop& prop : cast.props) {
    if (prop.part == face::Part::kClothes) continue;
    prop.vertices.clear();
    prop.triangles.clear();
  }
  return cast;
}

}  // namespace kaori::tests
