#include "tests/look/look_pack.h"

#include <cstdlib>

#include "appliance/core/show/pack.h"
#include "drivers/base/log.h"

namespace kaori::tests {

namespace {

template <class Keep>
face::Cast CastWith(const Keep& keeps) {
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
    if (keeps(prop.part)) continue;
    prop.vertices.clear();
    prop.triangles.clear();
  }
  return cast;
}

}  // namespace

face::Cast ClothedCast() {
  return CastWith([](face::Part part) { return part == face::Part::kClothes; });
}

face::Cast HairyCast() {
  return CastWith([](face::Part part) { return part == face::Part::kClothes || part == face::Part::kHair; });
}

}  // namespace kaori::tests
