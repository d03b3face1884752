// Scenarios as people write them: what a line means, and what is said about a wrong one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hw-sim/devices/lip_picture.h"
#include "hw-sim/scenario/key_names.h"
#include "hw-sim/scenario/reader.h"
#include "hw-sim/scenario/speech.h"
#include "hw-sim/scenario/writer.h"

namespace kaori::sim {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

// The actions of a text that is right.
std::vector<TimedAction> Actions(std::string_view text) {
  const Reading reading = ReadScenario(text);
  EXPECT_EQ(Describe(reading.problems, "t"), "");
  return reading.scenario.actions;
}

// What is said of a text that is wrong.
std::string Complaint(std::string_view text) {
  return Describe(ReadScenario(text).problems, "play.txt");
}

TEST(ScenarioReader, KnowsEveryHand) {
  const auto one = [](const char* line) {
    const auto actions = Actions(line);
    return actions.size() == 1 ? actions[0].action : OperatorAction{};
  };
  EXPECT_EQ(one("at 1s dial 1 turn 0.4"), (OperatorAction{DevicePort::kDialBox, Verb::kTurn, 0, 0.4, 0}));
  EXPECT_EQ(one("at 1s hold 9"), (OperatorAction{DevicePort::kDialBox, Verb::kPush, 8, 0, 0}));
  EXPECT_EQ(one("at 1s release 32"), (OperatorAction{DevicePort::kDialBox, Verb::kRelease, 31, 0, 0}));
  EXPECT_EQ(one("at 1s left move 0.5 -1"), (OperatorAction{DevicePort::kStickLeft, Verb::kMove, 0, 0.5, -1}));
  EXPECT_EQ(one("at 1s right twist -.5"),
            (OperatorAction{DevicePort::kStickRight, Verb::kTwist, 0, -0.5, 0}));
  EXPECT_EQ(one("at 1s right slide +1"), (OperatorAction{DevicePort::kStickRight, Verb::kSlide, 0, 1, 0}));
  EXPECT_EQ(one("at 1s left hat up-left"), (OperatorAction{DevicePort::kStickLeft, Verb::kHat, 7, 0, 0}));
  EXPECT_EQ(one("at 1s left hat centre"), (OperatorAction{DevicePort::kStickLeft, Verb::kHat, -1, 0, 0}));
  EXPECT_EQ(one("at 1s left hold 12"), (OperatorAction{DevicePort::kStickLeft, Verb::kPush, 11, 0, 0}));
  EXPECT_EQ(one("at 1s key F1 press"), (OperatorAction{DevicePort::kKeyboard, Verb::kPush, 0x3A, 0, 0}));
  EXPECT_EQ(one("at 1s key a release"), (OperatorAction{DevicePort::kKeyboard, Verb::kRelease, 0x04, 0, 0}));
  EXPECT_EQ(one("at 1s pointer 0.4 0.5"), (OperatorAction{DevicePort::kPointer, Verb::kMove, 0, 0.4, 0.5}));
  EXPECT_EQ(one("at 1s press pointer"), (OperatorAction{DevicePort::kPointer, Verb::kPush, 0, 0, 0}));
  EXPECT_EQ(one("at 1s release pointer 3"), (OperatorAction{DevicePort::kPointer, Verb::kRelease, 2, 0, 0}));
  EXPECT_EQ(one("at 1s roll pointer -2"), (OperatorAction{DevicePort::kPointer, Verb::kRoll, 0, -2, 0}));
  EXPECT_EQ(one("at 1s unplug pointer"), (OperatorAction{DevicePort::kPointer, Verb::kUnplug, 0, 0, 0}));
  EXPECT_EQ(one("at 1s lips 0.6 1.1"), (OperatorAction{DevicePort::kCamera, Verb::kLips, 0, 0.6, 1.1}));
  EXPECT_EQ(one("at 1s lens cover"), (OperatorAction{DevicePort::kCamera, Verb::kCoverLens, 1, 0, 0}));
  EXPECT_EQ(one("at 1s camera run"), (OperatorAction{DevicePort::kCamera, Verb::kStall, 0, 0, 0}));
  EXPECT_EQ(one("at 1s unplug stick-left"), (OperatorAction{DevicePort::kStickLeft, Verb::kUnplug, 0, 0, 0}));
  EXPECT_EQ(one("at 1s line panic on"), (OperatorAction{DevicePort::kLines, Verb::kPush, 5, 0, 0}));
  EXPECT_EQ(one("at 1s line go on"), (OperatorAction{DevicePort::kLines, Verb::kPush, 0, 0, 0}));
  EXPECT_EQ(one("at 1s line presence off"), (OperatorAction{DevicePort::kLines, Verb::kRelease, 3, 0, 0}));
  EXPECT_EQ(Actions("at 1s line blackout tap").size(), 2U);
  EXPECT_EQ(one("at 1s plug screen"), (OperatorAction{DevicePort::kScreen, Verb::kPlug, 0, 0, 0}));
}

TEST(ScenarioReader, APushIsDownAndUpAgain) {
  const auto actions = Actions("at 2s push 9\nat 2.05s key space tap");
  ASSERT_EQ(actions.size(), 4u);
  EXPECT_EQ(actions[0], (TimedAction{2s, {}, {DevicePort::kDialBox, Verb::kPush, 8, 0, 0}}));
  EXPECT_EQ(actions[1], (TimedAction{2050ms, {}, {DevicePort::kKeyboard, Verb::kPush, 0x2C, 0, 0}}));
  EXPECT_EQ(actions[2], (TimedAction{2s + kTap, {}, {DevicePort::kDialBox, Verb::kRelease, 8, 0, 0}}));
}

TEST(ScenarioReader, TimesStandBeforeOrAfter) {
  const auto before = Actions("at 3.2s over 800ms left move 0.4 -0.2");
  EXPECT_EQ(before, Actions("over 0.8s at 3.2s left move 0.4 -0.2"));
  EXPECT_EQ(before, Actions("left move 0.4 -0.2 at 3.2s over 0.8s  # a comment"));
  EXPECT_EQ(before[0].at, 3200ms);
  EXPECT_EQ(before[0].over, 800ms);
}

TEST(ScenarioReader, OrdersByTimeAndKeepsTheOrderOfEqualTimes) {
  const auto actions = Actions("at 2s hold 1\nat 1s hold 2\nat 2s release 1");
  ASSERT_EQ(actions.size(), 3u);
  EXPECT_EQ(actions[0].action.index, 1);
  EXPECT_EQ(actions[1].action.verb, Verb::kPush);
  EXPECT_EQ(actions[2].action.verb, Verb::kRelease);
}

TEST(ScenarioReader, ASceneBeginsWithWhatFollowsIt) {
  const auto scenario =
      ReadScenario("scene poster\nat 2s hold 1\nscene dog\nat 5s hold 2\nat 9s scene end").scenario;
  EXPECT_EQ(scenario.beats, (std::vector<Beat>{{2s, "poster"}, {5s, "dog"}, {9s, "end"}}));
  EXPECT_EQ(scenario.length, 9s);
}

// Of the lips, or of the voice alone.
std::vector<TimedAction> Of(DevicePort port, std::vector<TimedAction> actions) {
  std::erase_if(actions, [port](const TimedAction& timed) { return timed.action.port != port; });
  return actions;
}

TEST(ScenarioReader, SpeechEndsAtRestWithinItsTime) {
  const auto actions = Of(DevicePort::kCamera, Actions("at 1s say \"a i u e o\" over 2s"));
  ASSERT_EQ(actions.size(), 6u);
  EXPECT_EQ(actions.front().at, 1s);
  EXPECT_EQ(actions.back().at + actions.back().over, 3s);
  EXPECT_EQ(actions.back().action.a, Mouth{}.height);
  EXPECT_GT(actions[0].action.a, actions[1].action.a);  // a is higher than i,
  EXPECT_GT(actions[1].action.b, actions[2].action.b);  // i wider than u.
}

TEST(ScenarioReader, LipsMeetBeforeM) {
  const auto actions = Of(DevicePort::kCamera, Actions("at 0s say \"ma\" over 1s"));
  ASSERT_EQ(actions.size(), 3u);
  EXPECT_LT(actions[0].action.a, Mouth{}.height);
  EXPECT_GT(actions[1].action.a, 0.5);
}

TEST(ScenarioReader, TheVoiceSoundsWhenTheLipsBeginToOpen) {
  const auto all = Actions("at 1s say \"ka mo n\" over 3s");
  const auto lips = Of(DevicePort::kCamera, all), voice = Of(DevicePort::kMicrophone, all);
  ASSERT_EQ(lips.size(), 5u);
  ASSERT_EQ(voice.size(), 5u);  // a, silence while the lips meet, o, a hum, silence.
  EXPECT_EQ(voice[0].at, lips[0].at);
  EXPECT_EQ(voice[0].action.index, 0);
  EXPECT_EQ(voice[1].at, lips[1].at);
  EXPECT_EQ(voice[1].action.a, 0);
  EXPECT_EQ(voice[2].at, lips[2].at);
  EXPECT_EQ(voice[2].action.index, 4);
  EXPECT_LT(voice[3].action.a, voice[2].action.a);
  EXPECT_EQ(voice[4].action.a, 0);
  EXPECT_EQ(voice[4].at, lips[4].at);
}

TEST(ScenarioReader, AVoiceMaySoundWithoutLips) {
  const auto actions = Actions("at 1s voice e 0.5\nat 2s voice off\nat 3s loudspeaker stall");
  ASSERT_EQ(actions.size(), 3u);
  EXPECT_EQ(actions[0].action, (OperatorAction{DevicePort::kMicrophone, Verb::kVoice, 3, 0.5, 0}));
  EXPECT_EQ(actions[1].action.a, 0);
  EXPECT_EQ(actions[2].action, (OperatorAction{DevicePort::kLoudspeaker, Verb::kStall, 1, 0, 0}));
  EXPECT_EQ(Complaint("at 1s voice y 1"), "play.txt:1:13: no vowel \"y\"; vowels are a, i, u, e, o, or off");
  EXPECT_THAT(Complaint("at 1s microphone break"), HasSubstr("expected stall or run"));
}

TEST(ScenarioReader, NamesLineColumnAndWhatWasExpected) {
  EXPECT_EQ(Complaint("\nat 2.5s dial 9 turn 1"), "play.txt:2:14: no dial 9; dials are 1 to 8");
  EXPECT_EQ(Complaint("at 2s push x"), "play.txt:1:12: no button x; buttons are 1 to 32");
  EXPECT_EQ(Complaint("at 2s left push 13"), "play.txt:1:17: no stick button 13; stick buttons are 1 to 12");
  EXPECT_EQ(Complaint("at 2 push 1"),
            "play.txt:1:4: \"2\" is no time; times are such as 2.5s or 800ms, up to 24 hours");
  EXPECT_EQ(Complaint("push 1"), "play.txt:1:1: when? A line begins with its time, such as at 2.5s");
  EXPECT_EQ(Complaint("at 1s left move 0.5"),
            "play.txt:1:20: the line ends where y, back to forwards is expected");
  EXPECT_EQ(Complaint("at 1s left move 2 0"), "play.txt:1:17: \"2\" is not x, left to right (-1 to 1)");
  EXPECT_EQ(Complaint("at 1s push 1 2"), "play.txt:1:14: nothing more is expected in this line");
  EXPECT_EQ(Complaint("at 1s at 2s push 1"), "play.txt:1:7: a second time of the same kind in one line");
  EXPECT_EQ(Complaint("at 1s say \"a i"), "play.txt:1:11: a quote that nothing closes");
  EXPECT_THAT(Complaint("at 1s dail 1 turn 1"), HasSubstr("1:7: unknown word \"dail\"; expected dial, push"));
  EXPECT_THAT(Complaint("at 1s over 1s push 1"), HasSubstr("1:15: this happens at once"));
  EXPECT_THAT(Complaint("at 1s say \"a\""), HasSubstr("1:7: say wants a time"));
  EXPECT_THAT(Complaint("at 1s say \"123\" over 1s"), HasSubstr("1:11: this cannot be said"));
  EXPECT_THAT(Complaint("at 1s key hyper tap"), HasSubstr("1:11: no key \"hyper\""));
  EXPECT_THAT(Complaint("at 1s plug toaster"), HasSubstr("1:12: no device \"toaster\""));
  EXPECT_THAT(Complaint("at 1s left hat north"), HasSubstr("1:16: the hat knows no \"north\""));
  EXPECT_THAT(Complaint("at 1s press"), HasSubstr("1:12: expected pointer"));
  EXPECT_EQ(Complaint("at 1s press pointer 4"),
            "play.txt:1:21: no pointer button 4; pointer buttons are 1 to 3");
  EXPECT_EQ(Complaint("at 1s pointer 0.5 -0.1"), "play.txt:1:19: \"-0.1\" is not y, from above (0 to 1)");
  EXPECT_THAT(Complaint("at 1s lens remove"), HasSubstr("1:12: expected cover or uncover"));
  EXPECT_THAT(Complaint("at 1s dial 1 spin 2"), HasSubstr("1:14: expected turn"));
  EXPECT_THAT(Complaint("at 1s"), HasSubstr("1:6: the line ends where"));
}

TEST(ScenarioReader, ColumnsCountCharactersNotBytes) {
  EXPECT_EQ(Complaint("at 1s say \"カオリ\" over 1s"),
            "play.txt:1:11: this cannot be said; syllables are such as \"ka o ri\"");
  EXPECT_THAT(Complaint("at 1s scene \"カオリ\" x"), HasSubstr("1:19: nothing more"));
}

TEST(ScenarioReader, TellsEveryWrongLineAndEachOnce) {
  const auto problems = ReadScenario("at 1s push 99\nat 2s push 1\nat x push 99 99\n# fine\ndial\n").problems;
  ASSERT_EQ(problems.size(), 3u);
  EXPECT_EQ(problems[0].line, 1);
  EXPECT_EQ(problems[1].line, 3);
  EXPECT_EQ(problems[2].line, 5);
}

TEST(ScenarioReader, RefusesNamesThatCouldNotBeWrittenAgain) {
  EXPECT_EQ(Complaint("at 1s scene po\"ster"),
            "play.txt:1:15: a quote within a word; put the whole word into quotes");
  EXPECT_EQ(Complaint("at 1s scene " + std::string(101, 'x')),
            "play.txt:1:13: a scene's name of more than 100 bytes");
  EXPECT_TRUE(ReadScenario("scene \"the poster\"\nat 1s push 1").problems.empty());
}

TEST(ScenarioReader, LeavesAFileThatIsNoScenarioSoon) {
  std::string noise;
  for (int n = 0; n < 100'000; ++n) noise += "? ? ?\n";
  EXPECT_EQ(ReadScenario(noise).problems.size(), 100u);
  const Reading endless = ReadScenario(std::string(8u << 20, '?') + "\nat 1s push 1\n");
  ASSERT_EQ(endless.problems.size(), 1u);
  EXPECT_EQ(endless.problems[0].line, 1);
  std::string text;
  for (int n = 0; n < 2'000'000; ++n) text += "a ";
  EXPECT_EQ(ReadScenario(text).problems.size(), 1u);
}

TEST(ScenarioReader, RefusesNumbersThatAreNone) {
  for (const char* number : {"nan", "inf", "1e999", "0x1", "1,5", "--1", "1.0.0", "", "1001"})
    EXPECT_NE(Complaint(std::string("at 1s dial 1 turn ") + number), "") << number;
  for (const char* time : {"-1s", "1e9s", "s", "nans", "infs", "1m"})
    EXPECT_NE(Complaint(std::string("at ") + time + " push 1"), "") << time;
}

TEST(ScenarioReader, ReadsLinesOfOtherSystems) {
  EXPECT_EQ(Actions("at 1s hold 1\r\n\r\n\tat 2s\trelease 1\r\n").size(), 2u);
}

TEST(ScenarioReader, NamesTheFileThatIsNotThere) {
  const auto loaded = LoadScenario("/nowhere/x.play");
  EXPECT_EQ(loaded.error().message(), "read /nowhere/x.play: No such file or directory");
}

TEST(ScenarioReader, ReadsThePlaysThatComeWithTheSimulator) {
  for (const char* name : {"warm-up", "kaori", "faults"}) {
    const auto loaded = LoadScenario(std::string(KAORI_PLAYS) + "/" + name + ".play");
    ASSERT_TRUE(loaded) << loaded.error().attempt;
    EXPECT_GT(loaded->actions.size(), 40u);
  }
}

TEST(KeyNames, AreReadAsTheyAreWritten) {
  for (int usage = 0x04; usage <= 0xE7; ++usage)
    EXPECT_EQ(KeyNamed(KeyName(static_cast<std::uint8_t>(usage))), usage)
        << KeyName(static_cast<std::uint8_t>(usage));
  EXPECT_EQ(KeyName(0x2C), "space");
  EXPECT_EQ(KeyName(0x27), "0");
  EXPECT_EQ(KeyNamed("F12"), 0x45);
  EXPECT_FALSE(KeyNamed("f13"));
  EXPECT_FALSE(KeyNamed("usage-3"));
  EXPECT_FALSE(KeyNamed(""));
}

TEST(ScenarioWriter, WritesWhatTheReaderReadsBack) {
  const Scenario scenario =
      ReadScenario(
          "scene a\nat 0.000000001s push 1\nat 1s over 2s dial 8 turn -0.123456789012345\n"
          "at 1s left move 0.1 -0.3\nat 1s right hat down\nat 1s key up tap\nat 2s lens cover\n"
          "at 3s say \"ka o ri\" over 1s\nat 4s unplug camera\nat 4s plug camera\nat 5s over 1s pointer 0.1 "
          "0.7\nat 5s roll pointer -0.5\nat 6s voice u 0.25\nat 6s microphone stall\nat 6s unplug "
          "loudspeaker\nat 6s click pointer 2\nat 9s scene \"b c\"")
          .scenario;
  const Reading again = ReadScenario(WriteScenario(scenario));
  EXPECT_EQ(Describe(again.problems, "t"), "");
  EXPECT_EQ(WriteScenario(again.scenario), WriteScenario(scenario));
  EXPECT_EQ(again.scenario.beats, scenario.beats);
  EXPECT_EQ(again.scenario.actions.size(), scenario.actions.size());
}

}  // namespace
}  // namespace kaori::sim
