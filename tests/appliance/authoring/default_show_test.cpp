// The show that every box brings along: how much there is of it, and that operators reach all of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>
#include <string>

#include "appliance/authoring/script/show_file.h"
#include "appliance/authoring/sculpt/sculpt.h"
#include "appliance/core/performance/aim.h"
#include "appliance/core/performance/animate.h"
#include "appliance/core/performance/calls.h"
#include "appliance/core/roles/roles_file.h"
#include "render/face/mix.h"
#include "render/scene/view.h"

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

// What buttons of a kind call, on both sheets.
std::set<int> OnButtons(show::CallKind kind) {
  std::set<int> called;
  for (const auto* sheet : {&DefaultShow().buttons, &DefaultShow().second_buttons})
    for (const show::Call& call : *sheet)
      if (call.kind == kind) called.insert(call.index);
  return called;
}

TEST(DefaultShow, HasTenFacesTwentyFourExpressionsTenMouthShapesAndAFineSkin) {
  EXPECT_GE(DefaultShow().cast.faces.size(), 10U);
  EXPECT_GE(Kinds(face::ExpressionKind::kExpression), 24);
  EXPECT_GE(Kinds(face::ExpressionKind::kMouth), 10);
  EXPECT_GE(DefaultShow().cast.topology.triangles.size(), 4500U) << "of the cage, before it is made finer";
}

TEST(DefaultShow, HasAButtonForEachFaceAndForEachExpression) {
  EXPECT_EQ(OnButtons(show::CallKind::kFace).size(), DefaultShow().cast.faces.size());
  EXPECT_EQ(static_cast<std::ptrdiff_t>(OnButtons(show::CallKind::kExpression).size()),
            Kinds(face::ExpressionKind::kExpression));
}

TEST(DefaultShow, HasEveryStyleAndSceneOnItsSecondSheetAndAWayBack) {
  std::set<int> styles, scenes;
  bool back = false;
  for (const show::Call& call : DefaultShow().second_buttons) {
    if (call.kind == show::CallKind::kStyle) styles.insert(call.index);
    if (call.kind == show::CallKind::kScene) scenes.insert(call.index);
    back = back || (call.kind == show::CallKind::kSheet && call.index == 0);
  }
  EXPECT_EQ(styles.size(), static_cast<std::size_t>(scene::kStyleCount));
  EXPECT_EQ(scenes.size(), DefaultShow().scenes.size());
  EXPECT_TRUE(back);
}

TEST(DefaultShow, SaysInItsRolesWhatAShowWithoutAFileOfThemHas) {
  const roles::Items items = roles::ItemsOf(DefaultShow().cast);
  EXPECT_EQ(roles::TextOf(DefaultShow().roles, items), roles::TextOf(show::UsualRoles(), items));
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
  for (const auto* takes : {&DefaultShow().lobby->greetings, &DefaultShow().lobby->goodbyes})
    for (const show::LobbyTake& take : *takes) in_cues.insert(take.motion);
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

TEST(DefaultShow, GreetsInItsLobbyInTwoLanguagesWithSoundAndHasAWordForThoseWhoGo) {
  ASSERT_TRUE(DefaultShow().lobby);
  const show::Lobby& lobby = *DefaultShow().lobby;
  EXPECT_EQ(DefaultShow().cue_list.cues[lobby.cue].number, "40");
  EXPECT_FALSE(lobby.by_itself) << "it begins after the play";
  for (const auto* takes : {&lobby.greetings, &lobby.goodbyes}) {
    std::set<std::string> languages;
    for (const show::LobbyTake& take : *takes) {
      languages.insert(take.language);
      const show::Motion& said = DefaultShow().motions[static_cast<std::size_t>(take.motion)];
      EXPECT_FALSE(said.sound.samples.empty()) << said.name;
      EXPECT_FALSE(said.curves.empty()) << said.name << ": her mouth moves with it";
    }
    EXPECT_EQ(languages, (std::set<std::string>{"en", "ja"}));
  }
  EXPECT_FALSE(lobby.stays.empty());
}

// Her own life in the default show, with nobody at the controls.
class DefaultShowAlone : public ::testing::Test {
 protected:
  DefaultShowAlone() : show_(DefaultShow()), state_(performance::Opening(show_, board_, now_)) {}

  const scene::Scene& Frame() {
    now_ += std::chrono::microseconds(16'667);
    const performance::InputEvents events = performance::ReadEvents(state_.seen, board_);
    performed_ = performance::Animate(state_, board_, events, show_, now_);
    state_ = performed_.state;
    return performed_.scene;
  }
  face::EyeBall Ball(std::size_t eye) const {
    face::Weights weights;
    weights.faces = performed_.scene.weights.faces;
    return face::MixEyes(show_.cast.faces, weights)[eye];
  }
  glm::vec3 Looks(std::size_t eye) const {
    const scene::Gaze& gaze = performed_.scene.gaze[eye];
    return performance::DirectionOf({gaze.yaw_rad, gaze.pitch_rad});
  }
  // The middle of the iris in a picture of 640 by 360.
  glm::vec2 Iris_px(std::size_t eye) const {
    const scene::View view(performed_.scene, show_.cast.neck_pivot, 16.0F / 9);
    return view.InPicture(Ball(eye).centre + Ball(eye).radius_m * Looks(eye)) * glm::vec2(320, 180);
  }

  const show::Show& show_;
  board::Snapshot board_;
  Time now_ = Time{} + std::chrono::seconds(100);
  performance::State state_;
  performance::Performed performed_;
};

TEST_F(DefaultShowAlone, MovesHerIrisSoFarThatAnAudienceSeesIt) {
  for (int seconds = 0; seconds < 100; seconds += 20) {
    glm::vec2 low(1e3F), high(-1e3F);
    for (int frame = 0; frame < 1200; ++frame) {
      Frame();
      low = glm::min(low, Iris_px(0));
      high = glm::max(high, Iris_px(0));
    }
    EXPECT_GE(high.x - low.x, 7) << "of 640, within 20 seconds; it was 3.3 when glances could not be seen";
  }
}

TEST_F(DefaultShowAlone, LooksAtSomebodyWithBothEyesOfEachFace) {
  const auto guest = std::ranges::find(show_.gaze_targets, "seat 12", &show::GazeTarget::name);
  ASSERT_NE(guest, show_.gaze_targets.end());
  for (std::uint16_t face = 0; face < show_.cast.faces.size(); ++face) {
    performance::CallFace(state_, face, 0);
    state_.life.target = static_cast<std::int32_t>(guest - show_.gaze_targets.begin());
    state_.life.called = {1, 0, 1, 1, 1};
    for (int frame = 0; frame < 240; ++frame) Frame();
    for (const std::size_t eye : {0U, 1U}) {
      const auto turn = scene::TurnOf(performed_.scene.head);
      const glm::vec3 pivot = show_.cast.neck_pivot;
      const glm::vec3 at = turn * (Ball(eye).centre - pivot) + pivot + performed_.scene.head.shift_m;
      const float cosine = glm::dot(turn * Looks(eye), glm::normalize(guest->at_m - at));
      EXPECT_GT(cosine, std::cos(0.5F * 0.01745F)) << show_.cast.faces[face].name << ", eye " << eye;
    }
  }
}

}  // namespace
}  // namespace kaori::authoring
