#include "tests/appliance/core/large_show.h"

#include <string>

#include "tests/render/synthetic_cast.h"

namespace kaori::tests {
namespace {

constexpr int kTexture_px = 512;

face::Texture Plain(std::uint8_t shade) {
  const auto bytes = std::size_t{4} * kTexture_px * kTexture_px;
  return {kTexture_px, kTexture_px, std::vector<std::uint8_t>(bytes, shade)};
}

}  // namespace

show::Show MakeLargeShow() {
  show::Show show;
  show.name = "large";
  show.cast = MakeSyntheticCast({.columns = 160, .rows = 80, .faces = 16, .expressions = 40});
  for (std::size_t i = 0; i < show.cast.faces.size(); ++i) {
    show.cast.faces[i].name += " " + std::to_string(i);
    show.cast.faces[i].surface.texture = static_cast<int>(i);
    show.cast.textures.push_back(Plain(static_cast<std::uint8_t>(100 + 8 * i)));
  }
  for (std::size_t i = 0; i < show.cast.expressions.size(); ++i)
    show.cast.expressions[i].name += " " + std::to_string(i);
  show.scenes.resize(1);
  show.scenes[0].name = "opening";
  return show;
}

}  // namespace kaori::tests
