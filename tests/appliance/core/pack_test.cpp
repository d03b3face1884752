// Show packs: what goes in comes out, and what is not a sound show is refused with one line.
#include "appliance/core/show/pack.h"

#include <gmock/gmock.h>

#include <limits>
#include <ostream>

#include "appliance/core/show/check.h"
#include "tests/appliance/core/pack_fixture.h"

namespace kaori::tests {
namespace {

using show::EncodePack;
using show::LoadPack;
using show::SavePack;
using show::Show;
using ::testing::HasSubstr;

TEST_F(PackTest, AShowComesOutAsItWentIn) {
  Show show = SmallShow();
  show.lobby->by_itself = true;
  show.cast.expressions[1].pupil = 1.25F;
  ASSERT_THAT(CheckShow(show), ::testing::IsEmpty());
  const auto file = folder_ / "small.kaori";
  ASSERT_TRUE(SavePack(show, file));
  const auto loaded = LoadPack(file);
  ASSERT_TRUE(loaded) << loaded.error().message();
  EXPECT_EQ(loaded->name, "small");
  EXPECT_EQ(loaded->cast.faces[2].positions, show.cast.faces[2].positions);
  EXPECT_EQ(loaded->cast.net.to_cage.weight, show.cast.net.to_cage.weight);
  EXPECT_EQ(loaded->cast.expressions[1].displacement, show.cast.expressions[1].displacement);
  EXPECT_EQ(loaded->cast.expressions[1].pupil, 1.25F);
  EXPECT_EQ(loaded->cast.expressions[2].pupil, 1);
  EXPECT_EQ(loaded->cast.topology.lids[1].upper, show.cast.topology.lids[1].upper);
  EXPECT_EQ(loaded->buttons[3].index, 2);
  EXPECT_EQ(loaded->stick_buttons, show.stick_buttons);
  ASSERT_EQ(loaded->keys.size(), 2U);
  EXPECT_EQ(loaded->keys[0].key_usage, 0x14);
  EXPECT_EQ(loaded->keys[0].call.kind, show::CallKind::kStyle);
  EXPECT_EQ(loaded->motions[0].curves[0].keys[1].value, 0.3F);
  EXPECT_EQ(loaded->motions[0].sound.channels, 2);
  EXPECT_EQ(loaded->motions[0].sound.samples, show.motions[0].sound.samples);
  EXPECT_EQ(loaded->scenes[0].backdrop, show.scenes[0].backdrop);
  EXPECT_EQ(loaded->cast.faces[2].surface.print, 0.75F);
  EXPECT_EQ(loaded->cast.faces[2].surface.folds, 0.5F);
  EXPECT_EQ(loaded->cast.faces[2].eye_surface.white, glm::vec3(0.1F, 0.2F, 0.3F));
  EXPECT_EQ(loaded->cast.faces[2].eye_surface.glow, 0.5F);
  EXPECT_EQ(loaded->cast.faces[2].outgrowth_kind, 1);
  EXPECT_EQ(loaded->cast.faces[2].withdrawn, show.cast.faces[2].withdrawn);
  EXPECT_EQ(loaded->cast.faces[2].hang_arms_m, show.cast.faces[2].hang_arms_m);
  EXPECT_EQ(loaded->cast.topology.outgrowth, show.cast.topology.outgrowth);
  EXPECT_EQ(loaded->channels.brow_frown, 4);
  const show::CueList& list = loaded->cue_list;
  EXPECT_EQ(list.goto_s, 2);
  ASSERT_EQ(list.cues.size(), 2U);
  EXPECT_EQ(list.cues[0].notes, "with the drum");
  EXPECT_EQ(list.cues[0].scene->in_s, 3);
  EXPECT_FALSE(list.cues[1].scene);
  EXPECT_EQ(list.cues[1].light->value, 0.25F);
  EXPECT_EQ(list.cues[1].wait.person, show::CuePerson::kVoiceQuiet);
  EXPECT_EQ(loaded->roles.handover_s, 0.5F);
  ASSERT_EQ(loaded->roles.roles.size(), show.roles.roles.size());
  EXPECT_EQ(loaded->roles.roles[1].maps[0].points, show.roles.roles[1].maps[0].points);
  EXPECT_EQ(loaded->roles.roles[2].maps.back().takeover, show::Takeover::kScale);
  EXPECT_EQ(loaded->gaze_targets[1].name, "seat 12");
  EXPECT_EQ(loaded->gaze_targets[1].at_m, show.gaze_targets[1].at_m);
  EXPECT_EQ(loaded->scenes[0].life, show.scenes[0].life);
  EXPECT_EQ(loaded->scenes[0].gaze, 1);
  EXPECT_EQ(loaded->second_buttons[4].kind, show::CallKind::kExpression);
  EXPECT_EQ(loaded->second_buttons[4].mode, show::CallMode::kToggle);
  EXPECT_EQ(loaded->keys[1].call.mode, show::CallMode::kMomentary);
  EXPECT_EQ(loaded->face_fades, show.face_fades);
  ASSERT_EQ(loaded->roles.mixes.size(), 1U);
  EXPECT_EQ(loaded->roles.mixes[0].index, 2);
  EXPECT_EQ(list.cues[1].life, show.cue_list.cues[1].life);
  EXPECT_EQ(list.cues[1].gaze, show::kNoTarget);
  EXPECT_FALSE(list.cues[0].gaze);
  EXPECT_TRUE(list.cues[1].lock);
  EXPECT_FALSE(list.cues[0].lock);
  EXPECT_EQ(list.tracked[2].life, (show::LifeAmounts{0.5F, 0.5F, 1, 1, 0}))
      << "what a cue does not name stays";
  EXPECT_EQ(list.tracked.size(), 3U) << "what stands after each cue is known at once";
  ASSERT_TRUE(loaded->lobby);
  EXPECT_TRUE(loaded->lobby->by_itself);
  EXPECT_EQ(loaded->lobby->greetings[1].language, "en-GB");
  EXPECT_EQ(loaded->lobby->hours[1].to, 10'100);
  EXPECT_EQ(loaded->lobby->stuck_s, 900);
  EXPECT_EQ(EncodePack(*loaded), EncodePack(show)) << "a second writing gives the same bytes";
}

TEST_F(PackTest, ItsSoundsAloneAreThoseOfTheWholeShow) {
  const auto file = Write(EncodePack(SmallShow()));
  for (const bool verified : {false, true}) {
    const auto sounds = show::LoadSounds(file, {.signed_by = {}, .on_verified_root = verified});
    ASSERT_TRUE(sounds) << sounds.error().message();
    ASSERT_EQ(sounds->size(), SmallShow().motions.size());
    EXPECT_EQ(sounds->at(0).channels, 2);
    EXPECT_EQ(sounds->at(0).samples, SmallShow().motions[0].sound.samples);
  }
}

TEST_F(PackTest, SoundsThatAreNoneAreRefused) {
  for (const show::Sound& wrong :
       {show::Sound{3, {1, 2, 3}}, show::Sound{2, {1, 2, 3}}, show::Sound{0, {1}}}) {
    Show show = SmallShow();
    show.motions[0].sound = wrong;
    EXPECT_THAT(show::LoadSounds(Write(EncodePack(show))).error().attempt, HasSubstr("whole frames"));
  }
  auto damaged = EncodePack(SmallShow());
  damaged[damaged.size() / 2] ^= 0x10;
  EXPECT_THAT(show::LoadSounds(Write(damaged)).error().attempt, HasSubstr("its checksum does not fit"));
  EXPECT_FALSE(show::LoadSounds(folder_ / "nowhere"));
}

TEST_F(PackTest, AMissingAnEmptyAndAForeignFileAreNamed) {
  EXPECT_THAT(LoadPack(folder_ / "nowhere").error().message(), HasSubstr("nowhere: No such file"));
  EXPECT_THAT(LoadPack(folder_).error().message(), HasSubstr("Is a directory"));
  EXPECT_THAT(LoadPack("/dev/zero").error().message(),
              HasSubstr("open the show /dev/zero: it is a device, not a file"));
  EXPECT_THAT(LoadPack(Write({})).error().attempt, HasSubstr("is empty"));
  EXPECT_THAT(LoadPack(Write(std::vector<std::uint8_t>(4096, 'x'))).error().attempt,
              HasSubstr("show.kaori is no show pack"));
}

TEST_F(PackTest, AFaceThatIsNoFaceIsRefusedByName) {
  Show show = SmallShow();
  show.cast.faces[1].positions[7].y = std::numeric_limits<float>::quiet_NaN();
  const auto loaded = LoadPack(Write(EncodePack(show)));
  ASSERT_FALSE(loaded);
  EXPECT_THAT(loaded.error().attempt, HasSubstr(show.cast.faces[1].name));
}

TEST(CheckShow, NamesEveryControlThatCallsNothing) {
  Show show = SmallShow();
  show.buttons[0] = {show::CallKind::kExpression, 99};
  show.keys[0].call.index = 77;
  show.scenes[0].face = 42;
  show.motions[0].curves[0].keys.back().value = 1;
  EXPECT_THAT(show::CheckShow(show),
              ::testing::UnorderedElementsAre(HasSubstr("button 1"), HasSubstr("key 20"),
                                              HasSubstr("scene \"opening\""), HasSubstr("motion \"nod\"")));
}

struct ShowFault {
  const char* name;
  void (*spoil)(Show&);
  const char* line;
  friend void PrintTo(const ShowFault& fault, std::ostream* out) { *out << fault.name; }
};

void SetKeys(Show& show, std::vector<show::MotionKey> keys) {
  show.motions[0].curves[0].keys = std::move(keys);
}

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
const ShowFault kShowFaults[] = {
    {"ButtonOfNoKnownKind",
     [](Show& s) {
       s.buttons[7] = {show::CallKind{99}, 0};
     },
     "button 8: calls number 0 of 0"},
    {"ButtonThatTogglesAScene",
     [](Show& s) {
       s.second_buttons[1] = {show::CallKind::kScene, 0, show::CallMode::kToggle};
     },
     "button 2 of the second sheet: only faces, expressions and sheets are toggles or momentary"},
    {"FadeThatNeverEnds", [](Show& s) { s.face_fades[1].out_s = 1e9F; },
     "fades: one of faces is longer than 1800 s, or none"},
    {"FadeThatIsNoTime", [](Show& s) { s.face_fades[1].in_s = kNan; }, "fades: one of faces"},
    {"LevelOfNoExpression", [](Show& s) { s.roles.mixes[0].index = 99; },
     "roles: a level is of a face or an expression that the show has not"},
    {"CueOfNoFace",
     [](Show& s) {
       s.cue_list.cues[1].face = show::CueCall{99, 1};
     },
     "cue 1.5: there is no face 99"},
    {"CueOfNoMotion", [](Show& s) { s.cue_list.cues[1].motion = 7; }, "cue 1.5: there is no motion 7"},
    {"CueThatStandsBeforeItself", [](Show& s) { s.cue_list.cues[1].number = "0.9"; },
     "cue 0.9: stands after cue 1; numbers must rise"},
    {"CueWithoutANumber", [](Show& s) { s.cue_list.cues[1].number = "x"; },
     "cue x: its number is not of digits and single dots"},
    {"CueThatWaitsForEver", [](Show& s) { s.cue_list.cues[1].wait.at_most_s = 0; },
     "cue 1.5: a wait for a person wants at_most_s"},
    {"CueOfNoLight",
     [](Show& s) { s.cue_list.cues[1].light->value = std::numeric_limits<float>::quiet_NaN(); },
     "cue 1.5: light is nan"},
    {"CueOfNoKindOfNext", [](Show& s) { s.cue_list.cues[0].next = show::CueNext{9}; },
     "cue 1: what begins the next cue is not known"},
    {"LobbyOfNoCue", [](Show& s) { s.lobby->cue = 2; }, "lobby: there is no cue 2"},
    {"LobbyWithoutAGreeting", [](Show& s) { s.lobby->greetings.clear(); }, "lobby: it has no greeting"},
    {"LobbyOfNoTake", [](Show& s) { s.lobby->stays[0].motion = 7; }, "lobby: stays: there is no motion 7"},
    {"LobbyThatNeverSleeps", [](Show& s) { s.lobby->sleep_s = kNan; }, "lobby: a time is nan s"},
    {"LobbyThatOpensOnNoDay", [](Show& s) { s.lobby->hours[0].from = show::kWeekMinutes; },
     "lobby: it cannot be open from 10080 to 900 min of the week"},
    {"LobbyThatLooksAtNobody", [](Show& s) { s.lobby->visitor = 5; }, "lobby: there is no gaze target 5"},
    {"PanicOfNoScene", [](Show& s) { s.cue_list.panic.index = 5; }, "cue list: there is no scene of panic 5"},
    {"RoleOfNoLevel", [](Show& s) { s.roles.roles[1].maps[3].level = show::Level{99}; },
     "role \"head\", slider: its level is not known"},
    {"RoleOfAControlThatItsDeviceHasNot",
     [](Show& s) { s.roles.roles[1].maps[0].control = show::Control::kDial; },
     "role \"head\", dial 1: its device has no such control"},
    {"RoleWithoutARange", [](Show& s) { s.roles.roles[1].maps[1].to = s.roles.roles[1].maps[1].from; },
     "role \"head\", y: its range is none of its level"},
    {"RoleWhoseCurveFalls",
     [](Show& s) {
       s.roles.roles[1].maps[0].points = {{0, 0}, {1, 0}};
     },
     "role \"head\", x: its curve"},
    {"RolesOfTooManyMaps", [](Show& s) { s.roles.roles[0].maps.resize(65, s.roles.roles[0].maps[7]); },
     "maps, and 64 at most can be played"},
    {"ButtonForAStyleThatIsNone",
     [](Show& s) {
       s.buttons[0] = {show::CallKind::kStyle, 5};
     },
     "button 1"},
    {"ButtonForASceneThatIsNone",
     [](Show& s) {
       s.buttons[0] = {show::CallKind::kScene, 1};
     },
     "button 1"},
    {"SceneInAStyleThatIsNone", [](Show& s) { s.scenes[0].style = scene::Style{9}; }, "there is no style 9"},
    {"SceneThatNeverArrives", [](Show& s) { s.scenes[0].fade_s = 1e30F; }, "scene \"opening\": its fade is"},
    {"SceneThatGoesBack", [](Show& s) { s.scenes[0].fade_s = -1; }, "scene \"opening\": its fade is -1 s"},
    {"SceneThatBlinds", [](Show& s) { s.scenes[0].exposure = 1e9F; }, "scene \"opening\": its light is"},
    {"SceneBeforeNoKindOfBackdrop",
     [](Show& s) { s.scenes[0].backdrop.kind = static_cast<scene::BackdropKind>(77); },
     "there is no kind of backdrop 77"},
    {"SceneBeforeNoPicture",
     [](Show& s) {
       s.scenes[0].backdrop.kind = scene::BackdropKind::kPicture;
       s.scenes[0].backdrop.picture = 9;
     },
     "there is no picture 9"},
    {"FacePrintedTwice", [](Show& s) { s.cast.faces[1].surface.print = 2; },
     "its print is not within 0 to 1"},
    {"SceneBeforeNothing", [](Show& s) { s.scenes[0].backdrop.top.y = kNan; }, "its backdrop holds a colour"},
    {"SceneOnAKeyThatIsNone", [](Show& s) { s.scenes[0].key_usage = 999; },
     "scene \"opening\": there is no key 999"},
    {"TakeThatStartsInTheMiddle",
     [](Show& s) {
       SetKeys(s, {{-1, 0}, {1, 0.3F}, {2, 0}});
     },
     "a curve leaves 0 to"},
    {"TakeThatJumps",
     [](Show& s) {
       SetKeys(s, {{0, 0}, {1, 0}, {1, 0.3F}, {2, 0}});
     },
     "the times of a curve must rise"},
    {"TakeThatTurnsTheHeadOff",
     [](Show& s) {
       SetKeys(s, {{0, 0}, {1, 400}, {2, 0}});
     },
     "or -4 to 4"},
    {"TakeOfNoNumber",
     [](Show& s) {
       SetKeys(s, {{0, 0}, {kNan, 0.3F}, {2, 0}});
     },
     "motion \"nod\""},
    {"TakeOfAChannelThatIsNone",
     [](Show& s) {
       s.motions[0].curves[0] = {show::MotionTarget::kChannel, 99, {{0, 0}, {1, 0}}};
     },
     "a curve moves nothing that exists"},
    {"SoundThatEndsWithinAFrame",
     [](Show& s) {
       s.motions[0].sound = {2, {1, 2, 3}};
     },
     "motion \"nod\": its sound ends within a frame"},
    {"SoundOfManyChannels",
     [](Show& s) {
       s.motions[0].sound = {6, {}};
     },
     "a sound of 6 channels"},
    {"SoundThatNeverEnds",
     [](Show& s) {
       s.motions[0].sound = {1, std::vector<std::int16_t>(601 * 48000)};
     },
     "its sound is longer than 600 s"},
    {"RoleOfAnExpressionThatIsNone", [](Show& s) { s.channels.mouth[2] = 99; },
     "channel mouth: there is no expression"},
    {"NoTexture", [](Show& s) { s.cast.textures.clear(); }, "textures: there is none"},
    {"MoreItemsThanIndices", [](Show& s) { s.scenes.resize(5000, s.scenes[0]); },
     "scenes: 5000, and 4096 at most"},
};

class AFaultOfAShow : public ::testing::TestWithParam<ShowFault> {};

TEST_P(AFaultOfAShow, IsFoundAndNamed) {
  Show show = SmallShow();
  GetParam().spoil(show);
  EXPECT_THAT(show::CheckShow(show), ::testing::Contains(HasSubstr(GetParam().line)));
}

INSTANTIATE_TEST_SUITE_P(Each, AFaultOfAShow, ::testing::ValuesIn(kShowFaults),
                         [](const auto& fault) { return std::string(fault.param.name); });

}  // namespace
}  // namespace kaori::tests
