// Heads that stand wrongly in their file are refused, and what an audience would see is said.
#include <gmock/gmock.h>

#include <algorithm>
#include <string>
#include <vector>

#include "appliance/authoring/import/doubts.h"
#include "appliance/authoring/import/heads.h"
#include "appliance/authoring/import/kept_script.h"
#include "appliance/authoring/import/mouth_uvs.h"
#include "appliance/authoring/sculpt/cage.h"
#include "tests/appliance/authoring/import_head.h"

namespace kaori::import {
namespace {

using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// The head, each of its points led through `turn`.
std::vector<std::string> FaultsOf(glm::vec3 (*turn)(const glm::vec3&)) {
  Model model = ExportedHead();
  for (glm::vec3& p : model.positions) p = turn(p);
  Findings findings;
  SplitHeads({model}, 0.05F, findings);
  return findings.lines();
}

TEST(Pose, OfAHeadThatLooksIntoTheHouseIsNoFault) {
  EXPECT_THAT(FaultsOf([](const glm::vec3& p) { return p; }), IsEmpty());
}

TEST(Pose, OfAHeadThatLooksBackwardsIsNamed) {
  EXPECT_THAT(FaultsOf([](const glm::vec3& p) { return glm::vec3(-p.x, p.y, -p.z); }),
              ElementsAre(HasSubstr("looks along -Z, and must look along +Z")));
}

TEST(Pose, OfAHeadWhoseFileHasZUpIsNamed) {
  EXPECT_THAT(FaultsOf([](const glm::vec3& p) { return glm::vec3(p.x, -p.z, p.y); }),
              ElementsAre(HasSubstr("looks along -Y")));
}

TEST(Pose, OfAHeadThatLooksAsideIsNamed) {
  EXPECT_THAT(FaultsOf([](const glm::vec3& p) { return glm::vec3(p.z, p.y, -p.x); }),
              Contains(AnyOf(HasSubstr("more than one ball"), HasSubstr("looks along"))));
}

TEST(Pose, OfTwoHeadsInOneFileIsNamed) {
  Model model = ExportedHead();
  const std::size_t vertices = model.positions.size();
  const std::size_t triangles = model.triangles.size();
  for (std::size_t v = 0; v < vertices; ++v) {
    model.positions.push_back(model.positions[v] + glm::vec3(0.4F, 0, 0));
    model.uv.push_back(model.uv[v]);
  }
  for (std::size_t t = 0; t < triangles; ++t) {
    face::Triangle copy = model.triangles[t];
    for (face::Index& corner : copy) corner += static_cast<face::Index>(vertices);
    model.triangles.push_back(copy);
  }
  model.targets.clear();
  Findings findings;
  SplitHeads({model}, 0.05F, findings);
  EXPECT_THAT(findings.lines(), Contains(HasSubstr("more than one ball of an eye's size")));
}

std::vector<std::string> DoubtsOf(const Model& model) {
  Findings findings;
  const Heads heads = SplitHeads({model}, 0.05F, findings);
  const HeadShape shape = ShapeOfHeads(heads);
  return DoubtsAbout(heads, shape, FindLandmarks(shape), 100);
}

TEST(Doubts, AreNoneOfAWholeHead) {
  EXPECT_THAT(DoubtsOf(ExportedHead()), IsEmpty());
}

TEST(Doubts, NameAHoleForAnEye) {
  Model blind = ExportedHead();
  const std::size_t skin = DefaultShow().cast.topology.vertex_count;
  std::erase_if(blind.triangles, [&](const face::Triangle& t) { return t[0] >= skin; });
  EXPECT_THAT(DoubtsOf(blind), Contains(HasSubstr("the left eye is a hole")));
}

// Without all that lies behind the place where the lips meet.
TEST(Doubts, NameAMouthWithoutAnInside) {
  const sculpt::Cage cage = sculpt::BuildCage();
  const auto is_inside = [&](face::Index v) {
    return v < cage.vertices.size() && cage.key(v).region == sculpt::Region::kMouth &&
           cage.key(v).b > sculpt::kLipContactRing;
  };
  Model hollow = ExportedHead();
  std::erase_if(hollow.triangles, [&](const face::Triangle& t) { return std::ranges::any_of(t, is_inside); });
  EXPECT_THAT(DoubtsOf(hollow), Contains(HasSubstr("what is behind the head")));
}

TEST(KeptScript, CarriesThePicturesOfItsScenes) {
  show::Show from;
  from.cast.textures.resize(3);
  from.cast.textures[2].width_px = 77;
  from.scenes.resize(2);
  for (show::StageScene& scene : from.scenes) {
    scene.backdrop.kind = scene::BackdropKind::kPicture;
    scene.backdrop.picture = 2;
  }
  show::Show to;
  to.scenes = from.scenes;
  to.cast.textures.resize(1);
  CarryPictures(from, to);
  ASSERT_EQ(to.cast.textures.size(), 2U);
  EXPECT_EQ(to.scenes[0].backdrop.picture, 1);
  EXPECT_EQ(to.scenes[1].backdrop.picture, 1);
  EXPECT_EQ(to.cast.textures[1].width_px, 77);
}

TEST(KeptScript, SaysWhatItHasLost) {
  show::Show show;
  show.cast.faces.resize(1);
  show.cast.faces[0].name = "ivan";
  show.scenes.resize(4);
  show.scenes[3].face = 7;
  show.buttons[0] = {show::CallKind::kFace, 3};
  EXPECT_EQ(DropLostFaces(show), 1);
  EXPECT_EQ(show.scenes[3].face, 0);
  EXPECT_THAT(WhatBecameOf(show, 1),
              ElementsAre(HasSubstr("each of the 4 plays a face of this import (ivan)"),
                          HasSubstr("buttons and keys: 1 called other faces")));
}

// A square of skin, and a tooth that lies upon it in the texture.
Heads WithATooth(const glm::vec2& at) {
  Heads heads;
  heads.uv = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, at, at + glm::vec2(0.2F, 0), at + glm::vec2(0, 0.2F)};
  heads.part.assign(4, PartOf::kSkin);
  heads.part.resize(7, PartOf::kUpperTeeth);
  heads.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}};
  return heads;
}

TEST(MouthUvs, IsMovedBesideTheSkin) {
  Heads heads = WithATooth({0.4F, 0.4F});
  EXPECT_NEAR(MouthOverSkin(heads), 1, 1e-6);
  PutMouthBesideSkin(heads);
  EXPECT_EQ(MouthOverSkin(heads), 0);
  EXPECT_LT(heads.uv[2].y, 1);
  EXPECT_GT(heads.uv[4].y, heads.uv[2].y);
}

TEST(MouthUvs, BesideTheSkinIsLeftAlone) {
  EXPECT_EQ(MouthOverSkin(WithATooth({1.2F, 0.4F})), 0);
}

}  // namespace
}  // namespace kaori::import
