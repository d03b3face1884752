// A head that came without motions: its features are found by its form.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>

#include <glm/geometric.hpp>

#include "appliance/authoring/import/heads.h"
#include "appliance/authoring/model/read_model.h"
#include "tests/appliance/authoring/import_head.h"

namespace kaori::import {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

Heads HeadsOf(const Model& model) {
  Findings findings;
  return SplitHeads({model}, 0.05F, findings);
}

Model WithoutShapes(Model model) {
  model.targets.clear();
  model.presets.clear();
  return model;
}

// Landmarks of one head, found by its motions and by its form: how far apart; -1: by form not at all.
std::vector<std::pair<std::string, float>> Apart_mm(const Model& model) {
  const auto by_motion = FindLandmarks(ShapeOfHeads(HeadsOf(model)));
  const auto by_form = FindLandmarks(ShapeOfHeads(HeadsOf(WithoutShapes(model))));
  std::vector<std::pair<std::string, float>> apart;
  for (const Landmark& mark : by_motion) {
    const auto same = LandmarkAt(by_form, mark.name);
    apart.emplace_back(mark.name, same ? 1000 * glm::distance(mark.at, *same) : -1);
  }
  return apart;
}

// How far a motion moves at most.
float Most_m(const Offsets& offsets) {
  float most_m = 0;
  for (const glm::vec3& offset : offsets) most_m = std::max(most_m, glm::length(offset));
  return most_m;
}

TEST(HeadWithoutMotions, HasItsLandmarksWhereMotionsWouldSay) {
  for (const auto& [name, apart_mm] : Apart_mm(ExportedHead())) {
    EXPECT_GE(apart_mm, 0) << name << " was not found by form";
    EXPECT_LT(apart_mm, 16) << name;
  }
}

TEST(HeadWithoutMotions, ShutsItsLidsOverTheBall) {
  const Heads heads = HeadsOf(WithoutShapes(ExportedHead()));
  for (std::size_t side = 0; side < 2; ++side) {
    const face::EyeBall& eye = heads.heads[0].eyes[side];
    const Offsets& blink = heads.by_form.blink[side];
    ASSERT_FALSE(blink.empty());
    EXPECT_GT(Most_m(blink), 0.005F);
    for (std::size_t v = 0; v < blink.size(); ++v) {
      const glm::vec3& at = heads.heads[0].positions[v];
      if (blink[v] == glm::vec3(0)) continue;
      EXPECT_NEAR(glm::distance(at + blink[v], eye.centre), glm::distance(at, eye.centre), 1e-4);
    }
  }
}

TEST(HeadWithoutMotions, OpensItsMouthByTheLowerLipAlone) {
  const HeadShape head = ShapeOfHeads(HeadsOf(WithoutShapes(ExportedHead())));
  ASSERT_FALSE(head.jaw.empty());
  const auto marks = FindLandmarks(head);
  const auto moved = [&](std::string_view name) {
    const auto at = std::ranges::find(head.positions, LandmarkAt(marks, name).value());
    return head.jaw[static_cast<std::size_t>(at - head.positions.begin())].y;
  };
  EXPECT_LT(moved("lower lip"), -0.012F);
  EXPECT_GT(moved("upper lip"), -0.002F);
  EXPECT_NEAR(moved("nose tip"), 0, 2e-3);
}

TEST(HeadWithoutMotions, SaysThatItHasNoEyes) {
  Model blind = WithoutShapes(ExportedHead());
  const Heads whole = HeadsOf(blind);
  const auto is_eye = [&](const Triangle& t) {
    return whole.parts[t[0]] == PartOf::kLeftEye || whole.parts[t[0]] == PartOf::kRightEye;
  };
  std::erase_if(blind.triangles, is_eye);
  const auto first_eye = std::ranges::find(whole.parts, PartOf::kLeftEye) - whole.parts.begin();
  blind.positions.resize(static_cast<std::size_t>(first_eye));
  blind.uv.resize(static_cast<std::size_t>(first_eye));
  const Heads heads = HeadsOf(blind);
  EXPECT_THAT(heads.found_by_form, Contains(HasSubstr("left eye: no ball was found")));
  EXPECT_THAT(heads.found_by_form, Contains(HasSubstr("mouth: not found")));
  EXPECT_TRUE(heads.by_form.jaw.empty());
}

TEST(HeadWithMotions, KeepsThem) {
  const Heads heads = HeadsOf(ExportedHead());
  EXPECT_TRUE(heads.found_by_form.empty());
  EXPECT_TRUE(heads.by_form.jaw.empty());
  EXPECT_FALSE(heads.by_form.lids[0]);
}

// A head that the project does not hold: a folder that the environment names.
TEST(RealHeads, HaveTheSameLandmarksByFormAsByMotion) {
  const char* folder = std::getenv("KAORI_FACES");
  if (folder == nullptr) GTEST_SKIP() << "KAORI_FACES names no folder with woman.glb";
  Findings findings;
  const auto model = model::ReadModel(std::filesystem::path(folder) / "woman.glb", findings);
  ASSERT_TRUE(model);
  for (const auto& [name, apart_mm] : Apart_mm(*model)) {
    RecordProperty(name, std::to_string(apart_mm));
    EXPECT_GE(apart_mm, 0) << name << " was not found by form";
    EXPECT_LT(apart_mm, 18) << name;  // Brows: this motion lifts their outer ends most.
  }
}

}  // namespace
}  // namespace kaori::import
