// Takes in show packs, and fields that packs of before have not: what goes in comes out, and a loop that would jump is
// refused.
#include <gmock/gmock.h>

#include <limits>

#include "appliance/core/show/check.h"
#include "appliance/core/show/pack.h"
#include "appliance/core/show/pack_content.h"
#include "appliance/core/show/pack_layout.h"
#include "tests/appliance/core/pack_fixture.h"

namespace kaori::tests {
namespace {

using show::EncodePack;
using show::LoadPack;
using show::Show;
using ::testing::HasSubstr;

using PackOfTakes = PackTest;

show::Motion Sway() {
  return {
      .name = "sway",
      .curves = {{show::MotionTarget::kHeadLean, 0, {{0, 0}, {1, 0.05F}, {2, 0.02F}, {3, 0.05F}, {4, 0}}}},
      .recorded = true,
      .loop_from_s = 1,
      .loop_to_s = 3};
}

TEST_F(PackOfTakes, ComesOutAsItWentInWithWhatCallsAndEndsThem) {
  Show show = SmallShow();
  show.motions.push_back(Sway());
  show.motions[1].layer = show::MotionLayer::kUnder;
  show.buttons[5] = {show::CallKind::kMotion, 1};
  show.cue_list.cues[0].motion = show::kEndsMotion;
  ASSERT_THAT(CheckShow(show), ::testing::IsEmpty());
  const auto loaded = LoadPack(Write(EncodePack(show)));
  ASSERT_TRUE(loaded) << loaded.error().message();
  const show::Motion& take = loaded->motions.at(1);
  EXPECT_TRUE(take.recorded);
  EXPECT_EQ(take.loop_from_s, 1);
  EXPECT_EQ(take.loop_to_s, 3);
  EXPECT_EQ(take.curves.at(0).target, show::MotionTarget::kHeadLean);
  EXPECT_EQ(take.layer, show::MotionLayer::kUnder);
  EXPECT_EQ(loaded->motions[0].layer, show::MotionLayer::kAdd) << "as in packs of before";
  EXPECT_FALSE(loaded->motions[0].recorded);
  EXPECT_FALSE(loaded->motions[0].Loops()) << "as in packs of before";
  EXPECT_EQ(loaded->buttons[5], (show::Call{show::CallKind::kMotion, 1}));
  EXPECT_EQ(loaded->cue_list.cues.at(0).motion, show::kEndsMotion);
}

TEST_F(PackOfTakes, KeepsHowACuePlaysATakeAndForWhoseLookItWaits) {
  Show show = SmallShow();
  show.motions.push_back(Sway());
  show.cue_list.cues[0].motion = 1;
  show.cue_list.cues[0].use = {.layer = show::MotionLayer::kOver, .gain = 0.5F, .from_s = 1.25F};
  show.cue_list.cues[1].wait = {show::CuePerson::kGazeOn, 0.5F, 20, 1};
  ASSERT_THAT(CheckShow(show), ::testing::IsEmpty());
  const auto loaded = LoadPack(Write(EncodePack(show)));
  ASSERT_TRUE(loaded) << loaded.error().message();
  EXPECT_EQ(loaded->cue_list.cues[0].use, show.cue_list.cues[0].use);
  EXPECT_EQ(loaded->cue_list.cues[1].use, show::MotionUse{}) << "as in packs of before";
  EXPECT_EQ(loaded->cue_list.cues[1].wait.person, show::CuePerson::kGazeOn);
  EXPECT_EQ(loaded->cue_list.cues[1].wait.target, 1);
  EXPECT_EQ(loaded->cue_list.tracked[1].loops,
            (std::vector{show::TrackedLoop{1, show.cue_list.cues[0].use}}));
}

using PackOfBefore = PackTest;

// As an earlier program wrote it: the table of the show has no such field.
TEST_F(PackOfBefore, ButtonsOfSticksPlaysAsItDid) {
  std::vector<std::uint8_t> content = show::EncodeContent(SmallShow());
  const pack::Pack* const stored = pack::GetPack(content.data());
  const auto* const table = reinterpret_cast<const flatbuffers::Table*>(stored);
  const auto at =
      static_cast<std::size_t>(table->GetVTable() - content.data()) + pack::Pack::VT_STICK_BUTTONS;
  content.at(at) = content.at(at + 1) = 0;
  const auto loaded = show::DecodeContent(content);
  ASSERT_TRUE(loaded) << loaded.error().message();
  EXPECT_EQ(loaded->stick_buttons, Show().stick_buttons);
  EXPECT_EQ(loaded->buttons, SmallShow().buttons);
}

TEST(CheckTakes, RefusesALoopThatJumpsOrHasASoundOrIsNone) {
  const auto fault_of = [](void (*spoil)(show::Motion&)) {
    Show show = SmallShow();
    show.motions.push_back(Sway());
    spoil(show.motions[1]);
    const auto faults = CheckShow(show);
    return faults.empty() ? "none" : faults.front();
  };
  EXPECT_EQ(fault_of([](show::Motion&) {}), "none");
  EXPECT_THAT(fault_of([](show::Motion& m) { m.curves[0].keys[3].value = 0.052F; }),
              HasSubstr("its loop jumps"));
  EXPECT_THAT(fault_of([](show::Motion& m) { m.sound.samples = {1, 2}; }), HasSubstr("a sound cannot loop"));
  EXPECT_THAT(fault_of([](show::Motion& m) { m.loop_to_s = 1.25F; }), HasSubstr("is none of 0.5 s or more"));
  EXPECT_THAT(fault_of([](show::Motion& m) { m.loop_from_s = std::numeric_limits<float>::quiet_NaN(); }),
              HasSubstr("its loop from nan to 3 s"));
  EXPECT_THAT(fault_of([](show::Motion& m) { m.layer = static_cast<show::MotionLayer>(3); }),
              HasSubstr("its layer is not known"));
  EXPECT_THAT(fault_of([](show::Motion& m) { m.curves[0].keys.pop_back(); }),
              HasSubstr("must start and end at 0"));
}

TEST(CheckTakes, RefusesACueThatPlaysATakeAsNoneCanBePlayedOrWaitsForALookAtNobody) {
  const auto fault_of = [](void (*spoil)(show::Cue&)) {
    Show show = SmallShow();
    spoil(show.cue_list.cues[1]);
    const auto faults = CheckShow(show);
    return faults.empty() ? "none" : faults.front();
  };
  EXPECT_EQ(fault_of([](show::Cue& c) { c.use.from_s = 0.99F; }), "none");
  EXPECT_EQ(fault_of([](show::Cue& c) { c.use.from_s = 1; }),
            "cue 1.5: its motion begins at 1 s and ends at 1 s");
  EXPECT_THAT(fault_of([](show::Cue& c) { c.use.from_s = std::numeric_limits<float>::quiet_NaN(); }),
              HasSubstr("its motion begins at nan s"));
  EXPECT_EQ(fault_of([](show::Cue& c) { c.use.gain = 2.5F; }),
            "cue 1.5: the gain of its motion is 2.5, not within 0.1 to 2");
  EXPECT_EQ(fault_of([](show::Cue& c) { c.use.layer = static_cast<show::MotionLayer>(3); }),
            "cue 1.5: the layer of its motion is not known");
  EXPECT_EQ(fault_of([](show::Cue& c) {
              c.wait = {show::CuePerson::kGazeOn, 0.3F, 20, 2};
            }),
            "cue 1.5: it waits for a look at the gaze target 2, and there is none such");
}

TEST(CheckTakes, RefusesACueThatFollowsALoop) {
  Show show = SmallShow();
  show.motions.push_back(Sway());
  show.cue_list.cues[0].motion = 1;
  show.cue_list.cues[0].next = show::CueNext::kFollow;
  EXPECT_THAT(CheckShow(show),
              ::testing::ElementsAre(HasSubstr("cue 1: nothing can follow it: its motion loops")));
}

}  // namespace
}  // namespace kaori::tests
