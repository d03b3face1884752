// What changed between two shows: each item that differs is named, with how much; nothing else is.
#include <gmock/gmock.h>

#include "appliance/authoring/pack/difference.h"
#include "tests/appliance/core/pack_fixture.h"

namespace kaori::tests {
namespace {

using authoring::Differences;
using show::Show;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(PackDiff, OfAShowWithItselfIsNothing) {
  EXPECT_THAT(Differences(SmallShow(), SmallShow()), IsEmpty());
}

TEST(PackDiff, SaysHowFarAFaceMovedInMillimetres) {
  Show after = SmallShow();
  after.cast.faces[1].positions[0].x += 0.002F;
  const auto lines = Differences(SmallShow(), after);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_THAT(lines[0], ::testing::HasSubstr("face \"round\": moved by up to 2.00 mm"));
}

TEST(PackDiff, SaysWhichPointOfAnExpressionChangedMost) {
  Show after = SmallShow();
  const auto corner = PointNamed(after.cast, "MC.l");
  after.cast.expressions[1].displacement[corner].y += 0.0015F;
  after.cast.expressions[1].lids = {0.25F, 0.5F};
  after.cast.expressions[1].pupil = 1.1F;
  after.cast.expressions[1].flush = 0.5F;
  EXPECT_THAT(Differences(SmallShow(), after),
              ElementsAre("expression \"smile\": moves by up to 1.50 mm otherwise (point MC.l)",
                          "expression \"smile\": lids shut 0.50 and 0.50 are now 0.25 and 0.50",
                          "expression \"smile\": pupils 1.00 as large are now 1.10",
                          "expression \"smile\": a flush of 0.00 is now 0.50"));
}

TEST(PackDiff, SaysWhatIsNewAndWhatIsGone) {
  Show before = SmallShow(), after = SmallShow();
  before.lobby.reset();
  after.lobby.reset();
  after.cast.faces[3].name = "other";
  after.motions.clear();
  EXPECT_THAT(Differences(before, after),
              ElementsAre("face \"long\": is gone", "face \"other\": is new", "motion \"nod\": is gone",
                          "cue 1.5: motion nod is now nothing"));
}

TEST(PackDiff, SaysHowMuchOfATextureChanged) {
  Show after = SmallShow();
  after.cast.textures[0].rgba.own()[5] = 0;
  EXPECT_THAT(Differences(SmallShow(), after),
              ::testing::Contains("face \"round\": texture changed in 25.0 % of its texels"));
}

// A face more shifts all numbers; who calls whom by name is still the same.
TEST(PackDiff, ComparesControlsByTheNamesOfWhatTheyCall) {
  Show after = SmallShow();
  after.cast.faces.insert(after.cast.faces.begin() + 1, after.cast.faces[0]);
  after.cast.faces[1].name = "twin";
  after.buttons[3].index = 3;
  after.keys[1].call.index = 2;
  after.face_fades.insert(after.face_fades.begin() + 1, show::ItemFade{});
  EXPECT_THAT(Differences(SmallShow(), after), ElementsAre("face \"twin\": is new"));
  after.buttons[3].index = 1;
  EXPECT_THAT(Differences(SmallShow(), after),
              ElementsAre("face \"twin\": is new", "button 4: face turned is now face twin"));
}

TEST(PackDiff, SaysWhatAKeyCallsOtherwise) {
  Show after = SmallShow();
  after.keys[0].call.index = 0;
  EXPECT_THAT(Differences(SmallShow(), after), ElementsAre("key 20: style flat is now style wire"));
  after.keys.clear();
  EXPECT_THAT(Differences(SmallShow(), after), ElementsAre("key 20: style flat is now nothing",
                                                           "key 21: momentary face round is now nothing"));
}

TEST(PackDiff, SaysWhatTheSecondSheetCallsAndHowItemsFadeOtherwise) {
  Show after = SmallShow();
  after.second_buttons[4].mode = show::CallMode::kMomentary;
  after.face_fades[1].out_s = 2;
  EXPECT_THAT(
      Differences(SmallShow(), after),
      ElementsAre(
          "button 5 of the second sheet: toggle expression smile is now momentary expression smile",
          "face \"round\": fade in 0.00 s, out 90.00 s, slow end is now in 0.00 s, out 2.00 s, slow end"));
}

TEST(PackDiff, SaysWhatTheLobbyDoesOtherwise) {
  Show after = SmallShow();
  after.lobby->cue = 0;
  after.lobby->by_itself = !after.lobby->by_itself;
  after.lobby->sleep_s = 45;
  after.lobby->greetings.pop_back();
  after.lobby->goodbyes.clear();
  after.lobby->hours = {{(4 * 24 + 17) * 60, (5 * 24 + 1) * 60 + 30}};
  EXPECT_THAT(Differences(SmallShow(), after),
              ElementsAre("lobby: cue 1.5 is now 1", "lobby: by_itself false is now true",
                          "lobby: sleep_s 90.00 is now 45.00",
                          "lobby: greeting nod (ja), nod (en-GB) is now nod (ja)",
                          "lobby: goodbye nod (fr) is now none",
                          "lobby: hours monday 10:00-15:00, sunday 06:00-00:20 is now friday 17:00-01:30"));
  after.lobby.reset();
  EXPECT_THAT(Differences(SmallShow(), after), ElementsAre("lobby: is gone"));
  EXPECT_THAT(Differences(after, SmallShow()), ElementsAre("lobby: is new"));
}

TEST(PackDiff, SaysWhatACueDoesOtherwiseAndWhichIsNewOrGone) {
  Show after = SmallShow();
  auto& cues = after.cue_list.cues;
  after.cue_list.goto_s = 1;
  cues[0].scene->in_s = 4;
  cues[0].notes = "";
  cues[1].use = {.layer = show::MotionLayer::kOver, .gain = 0.8F, .from_s = 0.5F};
  cues[1].wait = {show::CuePerson::kGazeOn, 0.3F, 20, 1};
  cues[1].gaze = 1;
  cues[1].lock = false;
  cues[1].release = 1U << static_cast<unsigned>(show::Level::kHeadYaw);
  cues.push_back({.number = "2", .motion = show::kEndsMotion});
  EXPECT_THAT(
      Differences(SmallShow(), after),
      ElementsAre("cue list: goto_s 2.00 s is now 1.00 s", "cue 1: notes with the drum is now nothing",
                  "cue 1: scene opening in 3.00 s is now opening in 4.00 s",
                  "cue 1.5: motion nod is now nod over, gain 0.80, from 0.50 s",
                  "cue 1.5: release nothing is now head_yaw", "cue 1.5: gaze nobody is now seat 12",
                  "cue 1.5: lock true is now nothing",
                  "cue 1.5: wait_for voice_quiet 1.00 s, at most 20.00 s is now gaze_on seat 12 0.30 s, at "
                  "most 20.00 s",
                  "cue 2: is new"));
  EXPECT_THAT(Differences(after, SmallShow()), ::testing::Contains("cue 2: is gone"));
}

TEST(PackDiff, SaysWhatASceneDoesOtherwise) {
  Show after = SmallShow();
  after.scenes[0].fade_s = 2;
  after.scenes[0].style = scene::Style::kWire;
  EXPECT_THAT(Differences(SmallShow(), after), ElementsAre("scene \"opening\": style soft is now wire",
                                                           "scene \"opening\": fade 0.80 s is now 2.00 s"));
}

}  // namespace
}  // namespace kaori::tests
