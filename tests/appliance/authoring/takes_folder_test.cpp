// The files of takes in a show's folder: read, written and checked, with all of their faults at once.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <ostream>

#include "appliance/authoring/script/show_file.h"
#include "appliance/authoring/takes/take_file.h"
#include "tests/appliance/authoring/takes_played.h"

namespace kaori::authoring {
namespace {

using show::MotionTarget;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A show's folder with takes.
class TakesFolder : public ::testing::Test {
 protected:
  TakesFolder() {
    std::filesystem::create_directories(folder_ / "takes");
    Write("show.toml", kShow);
  }
  ~TakesFolder() override { std::filesystem::remove_all(folder_); }

  static constexpr const char* kShow =
      "[[scene]]\nname = \"studio\"\nface = \"kaori\"\nbackdrop = { top = \"#ffffff\", bottom = \"#000000\" "
      "}\n"
      "[[motion]]\nname = \"nod\"\nkey = \"2\"\nlids = [[0, 0], [1, 1], [2, 0]]\n";
  static constexpr const char* kTake = "[curves]\nhead_yaw = [[0, 3], [1, 20], [2, -4]]\n";

  void Write(const std::filesystem::path& file, const std::string& text) const {
    std::ofstream(folder_ / file) << text;
  }
  std::vector<std::string> Read() {
    show_ = {};
    show_.cast.faces.resize(1);
    show_.cast.faces[0].name = "kaori";
    show_.cast.expressions.resize(2);
    show_.cast.expressions[0].name = "neutral";
    show_.cast.expressions[1].name = "jaw_open";
    return ReadShowFile(folder_ / "show.toml", show_);
  }

  std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) / ("kaori-takes-" + std::to_string(::getpid()));
  show::Show show_;
};

TEST_F(TakesFolder, GiveMotionsThatKeysButtonsAndCuesCall) {
  Write("takes/wave.toml", std::string("key = \"3\"\n") + kTake + "jaw_open = [[0, 0], [2, 1]]\n");
  Write("takes/sway.toml", std::string("loop = true\n") + kTake);
  Write("show.toml", std::string("[keys]\nq = \"take sway\"\n") + kShow);
  Write("cues.toml",
        "[[cue]]\nnumber = \"1\"\ntake = \"wave\"\n[[cue]]\nnumber = \"2\"\ntake = \"none\"\n"
        "[[cue]]\nnumber = \"3\"\nmotion = \"nod\"\n");
  EXPECT_THAT(Read(), IsEmpty());
  ASSERT_EQ(show_.motions.size(), 3U);
  EXPECT_EQ(show_.motions[1].name, "sway");
  EXPECT_TRUE(show_.motions[1].Loops());
  EXPECT_TRUE(show_.motions[2].recorded);
  EXPECT_FALSE(show_.motions[2].Loops());
  EXPECT_EQ(show_.motions[2].key_usage, 0x20);
  ASSERT_EQ(show_.motions[2].curves.size(), 2U);
  EXPECT_EQ(show_.motions[2].curves[1].channel, 1);
  EXPECT_EQ(show_.keys.at(0).call, (show::Call{show::CallKind::kMotion, 1}));
  EXPECT_EQ(show_.cue_list.cues.at(0).motion, 2);
  EXPECT_EQ(show_.cue_list.cues[1].motion, show::kEndsMotion);
  EXPECT_EQ(show_.cue_list.cues[2].motion, 0);
}

TEST_F(TakesFolder, LieUnderOrOverWhatIsPlayedLiveOrAreAddedToIt) {
  Write("takes/sway.toml", std::string("layer = \"under\"\n") + kTake);
  Write("takes/turn.toml", std::string("layer = \"over\"\n") + kTake);
  Write("takes/wave.toml", kTake);
  Write("show.toml", std::string(kShow) + "layer = \"under\"\n");
  EXPECT_THAT(Read(), IsEmpty());
  ASSERT_EQ(show_.motions.size(), 4U);
  using show::MotionLayer;
  EXPECT_EQ(show_.motions[0].layer, MotionLayer::kUnder) << "a motion that is written may lie so too";
  EXPECT_EQ(show_.motions[1].layer, MotionLayer::kUnder);
  EXPECT_EQ(show_.motions[2].layer, MotionLayer::kOver);
  EXPECT_EQ(show_.motions[3].layer, MotionLayer::kAdd);
  Write("takes/turn.toml", std::string("notes = \"x\"\nlayer = \"below\"\n") + kTake);
  EXPECT_THAT(Read(), ElementsAre(HasSubstr("turn.toml:2: layer: \"below\" is none of add, under, over")));
}

TEST_F(TakesFolder, ArePlayedAsACueSays) {
  Write("takes/wave.toml", kTake);
  Write("show.toml", std::string("[gaze]\n\"seat 12\" = [0, 0, 5]\n") + kShow);
  Write("cues.toml",
        "[[cue]]\nnumber = \"1\"\ntake = { name = \"wave\", layer = \"over\", gain = 0.8, from_s = 1.5 }\n"
        "[[cue]]\nnumber = \"2\"\nmotion = { name = \"nod\" }\nwait_for = { gaze_on = \"seat 12\", at_most_s "
        "= 9 }\n"
        "[[cue]]\nnumber = \"3\"\ntake = { name = \"none\" }\n"
        "wait_for = { gaze_on = \"seat 12\", gaze_s = 2, at_most_s = 9 }\n");
  EXPECT_THAT(Read(), IsEmpty());
  const auto& cues = show_.cue_list.cues;
  ASSERT_EQ(cues.size(), 3U);
  EXPECT_EQ(cues[0].motion, 1);
  EXPECT_EQ(cues[0].use, (show::MotionUse{show::MotionLayer::kOver, 0.8F, 1.5F}));
  EXPECT_EQ(cues[1].motion, 0);
  EXPECT_EQ(cues[1].use, show::MotionUse{});
  EXPECT_EQ(cues[1].wait.person, show::CuePerson::kGazeOn);
  EXPECT_EQ(show_.gaze_targets.at(static_cast<std::size_t>(cues[1].wait.target)).name, "seat 12");
  EXPECT_FLOAT_EQ(cues[1].wait.for_s, 0.3F);
  EXPECT_EQ(cues[2].motion, show::kEndsMotion);
  EXPECT_FLOAT_EQ(cues[2].wait.for_s, 2);
}

TEST_F(TakesFolder, AreWrittenAsTheyAreReadToTheBit) {
  Take take = WaveOf(3);
  take.curves.push_back(
      {MotionTarget::kChannel, "brow \"up\"",
       CurveOf(MotionTarget::kHeadYaw, 3, [](float s) { return 0.5F + 0.4F * std::sin(s); }).keys});
  take.curves.push_back(CurveOf(MotionTarget::kHeadLean, 3));
  take.notes = "The \"second\" evening";
  take.from_s = 0.1F;
  take.to_s = 2.7F;
  take.stretch = 1.3F;
  take.gain = 0.7F;
  take.ease_s = 0.3F;
  take.loop = true;
  take.blend_s = 0.4F;
  const auto saved = SaveTake(folder_, take);
  ASSERT_TRUE(saved) << saved.error().message();
  const auto again = LoadTake(folder_, "wave");
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_EQ(again->notes, take.notes);
  EXPECT_EQ(again->to_s, take.to_s);
  EXPECT_EQ(again->stretch, take.stretch);
  EXPECT_TRUE(again->loop);
  ASSERT_EQ(again->curves.size(), 3U);
  for (const TakeCurve& curve : again->curves) {
    const auto same =
        std::ranges::find_if(take.curves, [&](const TakeCurve& c) { return SameChannel(c, curve); });
    ASSERT_NE(same, take.curves.end());
    EXPECT_TRUE(SameKeys(curve.keys, same->keys)) << NameOf(curve);
  }
  EXPECT_EQ(TextOf(*again), TextOf(*LoadTake(folder_, "wave")));
}

TEST_F(TakesFolder, AreNotWrittenWhereThePackerWouldRefuseThem) {
  ASSERT_TRUE(SaveTake(folder_, WaveOf(3)));
  Take wrong = WaveOf(3);
  wrong.to_s = 9;
  const auto saved = SaveTake(folder_, wrong);
  ASSERT_FALSE(saved);
  EXPECT_THAT(saved.error().message(), HasSubstr("to_s: is 9 s, and the take was recorded for 3"));
  EXPECT_FALSE(LoadTake(folder_, "wave")->to_s) << "the file is as it was";
}

TEST_F(TakesFolder, AreCheckedWithAllOfTheirFaultsAtOnce) {
  Write("takes/a.toml", "stretch = 5\nease_s = 9\nlop = true\n[curves]\nhead_yaw = [[0, 3], [0, 4]]\n");
  Write("takes/b.toml", "loop = 1\n");
  const auto faults = Read();
  EXPECT_EQ(faults.size(), 6U) << ::testing::PrintToString(faults);
  EXPECT_THAT(faults, Contains(HasSubstr("a.toml:1: stretch: is 5, not within 0.25 to 4")));
  EXPECT_THAT(faults, Contains(HasSubstr("a.toml:2: ease_s: is 9 s, not within 0.05 to 5")));
  EXPECT_THAT(faults, Contains(HasSubstr("a.toml:3: lop: is not known here; did you mean \"loop\"?")));
  EXPECT_THAT(faults, Contains(HasSubstr("a.toml:5: curves.head_yaw: second 0 must lie after second 0")));
  EXPECT_THAT(faults, Contains(HasSubstr("b.toml:1: loop: must be true or false")));
  EXPECT_THAT(faults, Contains(HasSubstr("curves: is missing: it moves nothing")));
}

struct WrongTake {
  const char* name;
  const char* text;
  const char* line;
  friend void PrintTo(const WrongTake& wrong, std::ostream* out) { *out << wrong.name; }
};
const WrongTake kWrongTakes[] = {
    {"OfAChannelThatIsNone", "[curves]\njaw_opne = [[0, 0], [1, 1]]",
     "wave.toml:2: curves.jaw_opne: there is no target or channel \"jaw_opne\"; did you mean \"jaw_open\"?"},
    {"OnAKeyThatIsTaken", "key = \"2\"\n[curves]\nlids = [[0, 0], [1, 1]]",
     "wave.toml:1: key: the key \"2\" is given twice: it is that of motion \"nod\""},
    {"WithASoundThatIsMissing", "sound = \"hello.wav\"\n[curves]\nlids = [[0, 0], [1, 1]]",
     "wave.toml:1: sound: "},
    {"WithASoundThatLoops", "sound = \"hello.wav\"\nloop = true\n[curves]\nlids = [[0, 0], [2, 1]]",
     "wave.toml:2: loop: a take with a sound cannot loop"},
    {"WithASoundThatIsStretched", "sound = \"hello.wav\"\nstretch = 2\n[curves]\nlids = [[0, 0], [2, 1]]",
     "wave.toml:2: stretch: a take with a sound cannot be stretched"},
    {"TrimmedToNothing", "from_s = 0.9\n[curves]\nlids = [[0, 0], [1, 1]]",
     "wave.toml:1: from_s: leaves nothing of the 1 s that were recorded"},
    {"ThatIsTooShortForALoop", "loop = true\n[curves]\nlids = [[0, 0], [0.8, 1]]",
     "wave.toml:1: loop: wants 1 s at least, and 0.80 s are played"},
    {"ThatIsStretchedTooLong", "stretch = 4\n[curves]\nlids = [[0, 0], [200, 1]]",
     "wave.toml:1: stretch: makes it 800 s long, and 600 s is the most"},
    {"WithACurveThatIsANumber", "[curves]\nhead_yaw = 3",
     "wave.toml:2: curves.head_yaw: must be a list of pairs"},
    {"WithACurveOfOnePair", "[curves]\nhead_yaw = [[0, 3]]",
     "wave.toml:2: curves.head_yaw: must have two pairs"},
    {"ThatIsNoToml", "loop = = 1", "wave.toml:1:"},
    {"WithATurnTooFar", "[curves]\nhead_yaw = [[0, 0], [1, 1200]]",
     "wave.toml:2: curves.head_yaw: 1200 degrees, and 229 to either side are the most"},
};

class AWrongTake : public TakesFolder, public ::testing::WithParamInterface<WrongTake> {};

TEST_P(AWrongTake, IsNamedWithItsFileAndLine) {
  Write("takes/wave.toml", std::string(GetParam().text) + "\n");
  const auto faults = Read();
  EXPECT_THAT(faults, Contains(HasSubstr(GetParam().line)));
  RecordProperty("faulty_files", 1);
  RecordProperty("faulty_files_named",
                 ::testing::Value(faults, Contains(HasSubstr(GetParam().line))) ? 1 : 0);
}

INSTANTIATE_TEST_SUITE_P(Each, AWrongTake, ::testing::ValuesIn(kWrongTakes),
                         [](const auto& wrong) { return std::string(wrong.param.name); });

TEST_F(TakesFolder, ThatAreMissingAreRefusedWhenTheShowIsPacked) {
  Write("takes/wave.toml", kTake);
  Write("show.toml", std::string("[keys]\nq = \"take wvae\"\n") + kShow);
  Write("cues.toml",
        "[[cue]]\nnumber = \"1\"\ntake = \"greeting\"\n[[cue]]\nnumber = \"2\"\ntake = \"wave\"\nmotion = "
        "\"nod\"\n");
  EXPECT_THAT(Read(),
              ElementsAre(HasSubstr("show.toml:2: keys.q: there is no take \"wvae\"; did you mean \"wave\"?"),
                          HasSubstr("cues.toml:3: cue 1.take: there is no take \"greeting\""),
                          HasSubstr("cues.toml:6: cue 2.take: stands beside a motion")));
}

TEST_F(TakesFolder, ThatHaveFaultsAreNotSaidToBeMissingAsWell) {
  Write("takes/wave.toml", "stretch = 9\n" + std::string(kTake));
  Write("show.toml", std::string("[keys]\nq = \"take wave\"\n") + kShow);
  EXPECT_THAT(Read(), ElementsAre(HasSubstr("stretch: is 9")));
}

TEST_F(TakesFolder, OfAMotionsNameAreNamed) {
  Write("takes/nod.toml", kTake);
  EXPECT_THAT(Read(), ElementsAre(HasSubstr("nod.toml:1: show.toml has a motion \"nod\" already")));
}

TEST_F(TakesFolder, ThatLoopAreFollowedByNothing) {
  Write("takes/sway.toml", std::string("loop = true\n") + kTake);
  Write("cues.toml",
        "[[cue]]\nnumber = \"1\"\ntake = \"sway\"\ncontinue = \"follow\"\n[[cue]]\nnumber = \"2\"\nface = "
        "\"kaori\"\n");
  EXPECT_THAT(Read(),
              ElementsAre(HasSubstr(
                  "cues.toml:4: cue 1.continue: \"sway\" loops and has no end: nothing can follow it")));
}

// 100 ms of a loud tone, as a WAV file of 48 kHz.
std::string ToneFile() {
  std::string samples;
  for (int i = 0; i < 4800; ++i)
    samples += {static_cast<char>(0x00), static_cast<char>(i % 2 == 0 ? 0x40 : 0xC0)};
  const auto number = [](std::size_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> 8 * i & 0xFFU);
    return text;
  };
  return "RIFF" + number(36 + samples.size(), 4) + "WAVEfmt " + number(16, 4) + number(1, 2) + number(1, 2) +
         number(48000, 4) + number(96000, 4) + number(2, 2) + number(16, 2) + "data" +
         number(samples.size(), 4) + samples;
}

TEST_F(TakesFolder, TrimTheirSoundAsTheyTrimTheirCurves) {
  Write("tone.wav", ToneFile());
  Write("takes/wave.toml",
        "sound = \"tone.wav\"\nfrom_s = 0.025\nto_s = 1\n[curves]\nlids = [[0, 0], [1, 1], [2, 0]]\n");
  EXPECT_THAT(Read(), IsEmpty());
  const show::Sound& sound = show_.motions.at(1).sound;
  EXPECT_EQ(sound.samples.size(), 3600U);
  EXPECT_EQ(sound.samples.front(), 0) << "a cut is soft";
  EXPECT_NEAR(std::abs(sound.samples[1800]), 0x4000, 1);
}

}  // namespace
}  // namespace kaori::authoring
