#include "tests/appliance/authoring/appearance_fixture.h"

#include <gtest/gtest.h>

#include "appliance/authoring/appearance/dress.h"
#include "appliance/authoring/sculpt/sculpt.h"

namespace kaori::appearance {

std::filesystem::path ShowFolder() {
  return KAORI_DEFAULT_SHOW;
}

const face::Cast& SculptedCast() {
  static const face::Cast kCast = [] {
    face::Cast cast;
    const Result<void> sculpted = sculpt::Sculpt(ShowFolder(), cast);
    if (!sculpted) ADD_FAILURE() << sculpted.error().message();
    return cast;
  }();
  return kCast;
}

const face::Cast& DressedCast() {
  static const face::Cast kCast = [] {
    face::Cast cast = SculptedCast();
    const Result<void> dressed = Dress(ShowFolder(), cast, {.texture_px = 256, .shade_directions = 24});
    if (!dressed) ADD_FAILURE() << dressed.error().message();
    return cast;
  }();
  return kCast;
}

}  // namespace kaori::appearance
