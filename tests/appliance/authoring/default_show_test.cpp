// The show that every box brings along: how much there is of it, and that hands reach all of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "appliance/authoring/script/show_file.h"
#include "appliance/authoring/sculpt/sculpt.h"
#include "appliance/core/roles/roles_file.h"

namespace kaori::authoring {
namespace {

using ::testing::IsEmpty;

const show::Show& DefaultShow() {
  static const show::Show kShow = [] {
    show::Show show;
    const Result<void> sculpted = sculpt::Sculpt(KAORI_DEFAULT_SHOW, show.cast);
    EXPECT_TRUE(sculpted) << sculpted.error().message();
    EXPECT_THAT(ReadShowFile(std::string(KAORI_DEFAULT_SHOW) + "/show.toml", show), IsEmpty());
    return show;
  }();
  return kShow;
}

std::ptrdiff_t Kinds(face::ExpressionKind kind) {
  return std::ranges::count(DefaultShow().cast.expressions, kind, &face::Expression::kind);
}

// What buttons of a kind call.
std::set<int> OnButtons(show::CallKind kind) {
  std::set<int> called;
  for (const show::Call& call : DefaultShow().buttons)
    if (call.kind == kind) called.insert(call.index);
  return called;
}

TEST(DefaultShow, HasTenFacesTwentyExpressionsTenMouthShapesAndAFineSkin) {
  EXPECT_GE(DefaultShow().cast.faces.size(), 10U);
  EXPECT_GE(Kinds(face::ExpressionKind::kExpression), 20);
  EXPECT_GE(Kinds(face::ExpressionKind::kMouth), 10);
  EXPECT_GE(DefaultShow().cast.topology.triangles.size(), 4500U) << "of the cage, before it is made finer";
}

TEST(DefaultShow, HasAButtonForEachFaceAndForEachExpression) {
  EXPECT_EQ(OnButtons(show::CallKind::kFace).size(), DefaultShow().cast.faces.size());
  EXPECT_EQ(static_cast<std::ptrdiff_t>(OnButtons(show::CallKind::kExpression).size()),
            Kinds(face::ExpressionKind::kExpression));
}

TEST(DefaultShow, SaysInItsRolesWhatAShowWithoutAFileOfThemHas) {
  EXPECT_EQ(roles::TextOf(DefaultShow().roles), roles::TextOf(show::UsualRoles()));
}

TEST(DefaultShow, HasAHomeForEachFace) {
  std::set<int> at_home;
  for (const show::StageScene& scene : DefaultShow().scenes) at_home.insert(scene.face);
  EXPECT_EQ(at_home.size(), DefaultShow().cast.faces.size());
}

TEST(DefaultShow, HasAKeyForEachStyleAndSceneAndNoKeyForTwo) {
  std::multiset<int> keys{0x2C, 0x1B, 0x1D};  // Space, X and Z blink.
  std::set<int> styles;
  for (const show::KeyCall& key : DefaultShow().keys) {
    keys.insert(key.key_usage);
    if (key.call.kind == show::CallKind::kStyle) styles.insert(key.call.index);
  }
  for (const show::StageScene& scene : DefaultShow().scenes) keys.insert(scene.key_usage);
  std::set<int> in_cues;
  for (const show::Cue& cue : DefaultShow().cue_list.cues) in_cues.insert(cue.motion);
  for (std::size_t i = 0; i < DefaultShow().motions.size(); ++i) {
    const show::Motion& motion = DefaultShow().motions[i];
    if (motion.key_usage != 0) keys.insert(motion.key_usage);
    EXPECT_TRUE(motion.key_usage != 0 || in_cues.contains(static_cast<int>(i)))
        << motion.name << " is never called";
  }
  EXPECT_EQ(styles.size(), static_cast<std::size_t>(scene::kStyleCount));
  EXPECT_EQ(keys.count(0), 0U) << "of a scene that no key calls";
  for (const int key : keys) EXPECT_EQ(keys.count(key), 1U) << key;
}

TEST(DefaultShow, HasACueForEachBeatOfThePlayAndAKeyForEachCallOfTheList) {
  const show::CueList& list = DefaultShow().cue_list;
  EXPECT_GE(list.cues.size(), 40U);
  for (const char* beat :
       {"1", "2", "3", "4", "10", "13", "20", "22", "24", "26", "28", "30", "32", "33", "34", "40"})
    EXPECT_EQ(std::ranges::count(list.cues, beat, &show::Cue::number), 1) << beat;
  std::set<int> verbs;
  for (const show::KeyCall& key : DefaultShow().keys)
    if (key.call.kind == show::CallKind::kCue) verbs.insert(key.call.index);
  EXPECT_EQ(verbs.size(), static_cast<std::size_t>(show::kCueVerbCount));
}

}  // namespace
}  // namespace kaori::authoring
