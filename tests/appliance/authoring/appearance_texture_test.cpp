// Textures: nothing unpainted, nothing foreign at an edge, and what is painted lies where it belongs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "appliance/authoring/appearance/atlas.h"
#include "appliance/authoring/appearance/canvas.h"
#include "appliance/authoring/appearance/colour.h"
#include "appliance/authoring/appearance/painter.h"
#include "appliance/authoring/sculpt/cage.h"
#include "tests/appliance/authoring/appearance_fixture.h"

namespace kaori::appearance {
namespace {

constexpr int kSize_px = 256;

const Atlas& SmallAtlas() {
  static const Atlas kAtlas =
      UnrollSurface(SculptedCast().topology, sculpt::PaintAttributesOf(sculpt::BuildCage()), kSize_px);
  return kAtlas;
}

// Covered on both sides within a texel or two, but not itself.
bool IsPinhole(const Atlas& atlas, int x, int y) {
  const auto covered = [&](int dx, int dy) { return atlas.at(x + dx, y + dy).covered; };
  return !atlas.at(x, y).covered && ((covered(-1, 0) && covered(1, 0)) || (covered(0, -1) && covered(0, 1)));
}

glm::vec3 SrgbAt(const face::Texture& t, glm::vec2 uv_cm) {
  const glm::vec2 at = TexelFromUv(uv_cm, t.width_px);
  const auto i = 4 * (static_cast<std::size_t>(std::lround(at.y)) * static_cast<std::size_t>(t.width_px) +
                      static_cast<std::size_t>(std::lround(at.x)));
  return {t.rgba[i], t.rgba[i + 1], t.rgba[i + 2]};
}

const face::Face& FaceNamed(const std::string& name) {
  const auto& faces = DressedCast().faces;
  return *std::find_if(faces.begin(), faces.end(), [&](const face::Face& f) { return f.name == name; });
}

const face::Texture& TextureOf(const std::string& name) {
  return DressedCast().textures[static_cast<std::size_t>(FaceNamed(name).surface.texture)];
}

TEST(AppearanceAtlas, HasNoHoleInsideTheSurface) {
  const Atlas& atlas = SmallAtlas();
  int pinholes = 0;
  for (int y = 1; y + 1 < kSize_px; ++y) {
    for (int x = 1; x + 1 < kSize_px; ++x) pinholes += IsPinhole(atlas, x, y) ? 1 : 0;
  }
  EXPECT_EQ(pinholes, 0);
}

TEST(AppearanceAtlas, LeavesOnlyTheEyesAndTheCrownOpen) {
  const Atlas& atlas = SmallAtlas();
  const auto covered =
      std::count_if(atlas.texels.begin(), atlas.texels.end(), [](const Texel& t) { return t.covered; });
  EXPECT_GT(static_cast<double>(covered) / (kSize_px * kSize_px), 0.93);
  const glm::vec2 eye = TexelFromUv({3.3F, 0.2F}, kSize_px);
  EXPECT_FALSE(atlas.at(static_cast<int>(eye.x), static_cast<int>(eye.y)).covered);
}

TEST(AppearanceAtlas, KnowsTheLipsFromTheSkin) {
  const Atlas& atlas = SmallAtlas();
  const auto ring = [&](glm::vec2 uv_cm) {
    const glm::vec2 at = TexelFromUv(uv_cm, kSize_px);
    return atlas.at(static_cast<int>(std::lround(at.x)), static_cast<int>(std::lround(at.y))).mouth_ring;
  };
  EXPECT_GT(ring({0, -6.4F}), 3);
  EXPECT_EQ(ring({0, 3}), 0);
}

TEST(AppearanceCanvas, FillsEveryTexelOutsideWithColoursFromTheEdge) {
  Canvas canvas(SmallAtlas());
  for (std::size_t i = 0; i < SmallAtlas().texels.size(); ++i) {
    canvas.at(i) = SmallAtlas().texels[i].covered ? Paint{{0.5F, 0.25F, 0.1F}, 0.4F} : Paint{{0, 1, 0}, 1};
  }
  const face::Texture texture = std::move(canvas).Finish();
  for (std::size_t i = 0; i < texture.rgba.size(); i += 4) {
    ASSERT_NEAR(texture.rgba[i], ToSrgbByte(0.5F), 1) << "texel " << i / 4;
    ASSERT_NEAR(texture.rgba[i + 1], ToSrgbByte(0.25F), 1);
    ASSERT_NEAR(texture.rgba[i + 3], 102, 1);
  }
}

TEST(AppearanceCanvas, DrawsAStrokeWhereItLiesAndNowhereElse) {
  Canvas canvas(SmallAtlas());
  canvas.Draw({{0, 2}, {0.5F, 2}, {1, 2}, 0.12F, 1, {1, 1, 1}});
  EXPECT_GT(canvas.Sample({0.2F, 2}).r, 0.5F);
  EXPECT_EQ(canvas.Sample({0.2F, 3}).r, 0);
  EXPECT_EQ(canvas.Sample({-0.8F, 2}).r, 0);
}

// How light even skin of 1 is at a place after one crease across the middle of the face.
float LightUnderCrease(glm::vec2 uv_cm, float half_width_cm) {
  SkinLook look;
  look.lines = {
      1, {{.path_cm = {glm::vec2(0, 4), {2, 4}, {4, 4}}, .half_width_cm = half_width_cm, .strength = 0.5F}}};
  Texel texel;
  texel.uv_cm = uv_cm;
  Paint paint{{1, 1, 1}, 0};
  PaintLines(texel, look, paint);
  return paint.colour.g;
}

TEST(AppearanceCrease, GoesOverTheMiddleOfTheFaceAsOneLine) {
  EXPECT_LT(LightUnderCrease({0, 4}, 0.1F), 0.8F);
  EXPECT_NEAR(LightUnderCrease({0, 4}, 0.1F), LightUnderCrease({0.5F, 4}, 0.1F), 0.01F);
  EXPECT_EQ(LightUnderCrease({-0.5F, 4}, 0.1F), LightUnderCrease({0.5F, 4}, 0.1F));
}

TEST(AppearanceCrease, DiesAwayAtItsEnd) {
  EXPECT_GT(LightUnderCrease({3.95F, 4}, 0.1F), 0.9F);
}

TEST(AppearanceCrease, HasALineInItsFoldAndLightBelowWhereItIsNarrowAlone) {
  EXPECT_LT(LightUnderCrease({1, 4}, 0.1F), LightUnderCrease({1, 4}, 0.5F) - 0.05F);
  EXPECT_GT(LightUnderCrease({1, 3.7F}, 0.1F), LightUnderCrease({1, 4.3F}, 0.1F));
  EXPECT_EQ(LightUnderCrease({1, 2.9F}, 0.5F), LightUnderCrease({1, 5.1F}, 0.5F));
}

// The mean place of what a moustache of this recipe covers, on the side of positive x.
glm::vec2 MiddleOfMoustache(const MoustacheLook& look) {
  Canvas canvas(SmallAtlas());
  DrawMoustache(canvas, look);
  glm::vec2 sum{};
  float weight = 0;
  for (std::size_t i = 0; i < SmallAtlas().texels.size(); ++i) {
    const glm::vec2 uv_cm = SmallAtlas().texels[i].uv_cm;
    if (uv_cm.x <= 0) continue;
    sum += canvas.at(i).colour.r * uv_cm;
    weight += canvas.at(i).colour.r;
  }
  return sum / weight;
}

TEST(AppearanceMoustache, LiesWhereItsRecipePutsIt) {
  const MoustacheLook look{.amount = 1,
                           .colour = {1, 1, 1},
                           .from_cm = 0.03F,
                           .reach_cm = 2,
                           .y_cm = -4.9F,
                           .thickness_cm = 0.24F,
                           .thins_over_cm = 2.3F,
                           .turns_over_cm = 1.4F,
                           .hairs = 330};
  const glm::vec2 middle_cm = MiddleOfMoustache(look);
  MoustacheLook other = look;
  other.y_cm += 1;
  EXPECT_NEAR(MiddleOfMoustache(other).y, middle_cm.y + 1, 0.05F);
  other = look;
  other.from_cm += 0.5F;
  EXPECT_NEAR(MiddleOfMoustache(other).x, middle_cm.x + 0.5F, 0.1F);
  other = look;
  other.reach_cm = 1;
  EXPECT_NEAR(MiddleOfMoustache(other).x, middle_cm.x - 0.5F, 0.15F);
}

TEST(AppearanceTextures, AreOneForEachFaceAndComplete) {
  const face::Cast& cast = DressedCast();
  ASSERT_EQ(cast.textures.size(), cast.faces.size());
  for (const face::Texture& t : cast.textures) {
    EXPECT_EQ(t.width_px, 256);
    EXPECT_EQ(t.rgba.size(), 256U * 256U * 4U);
  }
}

TEST(AppearanceTextures, MeetAtTheSeamBehindTheHead) {
  for (const face::Face& f : DressedCast().faces) {
    const face::Texture& t = DressedCast().textures[static_cast<std::size_t>(f.surface.texture)];
    for (const float v : {-10.0F, -4.0F, 2.0F}) {
      const glm::vec3 gap = SrgbAt(t, {-20.8F, v}) - SrgbAt(t, {20.8F, v});
      EXPECT_LT(std::max({std::abs(gap.r), std::abs(gap.g), std::abs(gap.b)}), 60) << f.name << " at " << v;
    }
  }
}

TEST(AppearanceTextures, GiveKaoriRedderLipsThanSkin) {
  const glm::vec3 lip = SrgbAt(TextureOf("kaori"), {0.6F, -6.4F});
  const glm::vec3 skin = SrgbAt(TextureOf("kaori"), {0.6F, 3.6F});
  EXPECT_GT(lip.r - lip.g, skin.r - skin.g + 30);
}

TEST(AppearanceTextures, GiveTheDogADarkWetNose) {
  const face::Texture& dog = TextureOf("dog");
  const glm::vec2 at = TexelFromUv({0, -3.2F}, dog.width_px);
  const auto i = 4 * static_cast<std::size_t>(std::lround(at.y) * dog.width_px + std::lround(at.x));
  EXPECT_LT(dog.rgba[i], 90);
  EXPECT_GT(dog.rgba[i + 3], 90);
}

// Fur that is drawn over the line of the mouth looks like stitches.
TEST(AppearanceTextures, KeepFurOffTheDogsLips) {
  const face::Texture& dog = TextureOf("dog");
  for (std::size_t i = 0; i < SmallAtlas().texels.size(); ++i) {
    const Texel& texel = SmallAtlas().texels[i];
    if (!texel.covered || texel.bag > 0 || texel.mouth_ring < 5) continue;
    EXPECT_LT(dog.rgba[4 * i], 90) << texel.uv_cm.x << " " << texel.uv_cm.y;
  }
}

TEST(AppearanceTextures, ShadeTheBowlOfAnEarAndLeaveItsLobeLight) {
  const glm::vec3 bowl = SrgbAt(TextureOf("kaori"), {10.95F, -2.95F});
  const glm::vec3 lobe = SrgbAt(TextureOf("kaori"), {11.0F, -4.7F});
  EXPECT_LT(bowl.g, lobe.g - 25);
}

TEST(AppearanceScalp, HasStrandsAboveItsEdgeAndAFewOnTheSkinBelow) {
  const ScalpLook look{
      .colour = {0.2F, 0.2F, 0.2F}, .above_cm = {{0, 8}, {12, 8}}, .ragged = 0, .strands = 400};
  Canvas canvas(SmallAtlas());
  DrawHairline(canvas, look);
  int above = 0, below = 0;
  for (std::size_t i = 0; i < SmallAtlas().texels.size(); ++i) {
    if (canvas.at(i).colour.g <= 0) continue;
    const float v_cm = SmallAtlas().texels[i].uv_cm.y;
    EXPECT_GT(v_cm, 7.4F);
    (v_cm > 8.1F ? above : below) += 1;
  }
  EXPECT_GT(below, 0);
  EXPECT_GT(above, 5 * below);
}

}  // namespace
}  // namespace kaori::appearance
