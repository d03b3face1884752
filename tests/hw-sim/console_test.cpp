// The console without a browser: lines of input, what is let go of, pictures, and what the page is told.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <turbojpeg.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>

#include "drivers/base/clock.h"
#include "drivers/web/jpeg.h"
#include "hw-sim/console/dial_values.h"
#include "hw-sim/console/held.h"
#include "hw-sim/console/input.h"
#include "hw-sim/console/labels.h"
#include "hw-sim/console/rate.h"

namespace kaori::console {
namespace {

using sim::DevicePort;
using sim::OperatorAction;
using sim::Verb;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string Refused(std::string_view lines) {
  const auto actions = ReadInput(lines);
  return actions ? "taken" : actions.error().attempt;
}

TEST(ConsoleInput, AreReadFromLines) {
  const auto actions = ReadInput(
      "dial 1 turn 0.25\nhold 32\n\nleft move -1 0.5\nright twist 1\nleft slide 0.75\nright hat right\n"
      "key usage-44 press\nkey usage-44 release\npointer 0.25 1\npress pointer\nroll pointer -0.5\nlips 0.9 "
      "1.2\nlens cover\nunplug camera\n");
  ASSERT_TRUE(actions) << actions.error().message();
  EXPECT_THAT(*actions, ElementsAre(OperatorAction{DevicePort::kDialBox, Verb::kTurn, 0, 0.25},
                                    OperatorAction{DevicePort::kDialBox, Verb::kPush, 31},
                                    OperatorAction{DevicePort::kStickLeft, Verb::kMove, 0, -1, 0.5},
                                    OperatorAction{DevicePort::kStickRight, Verb::kTwist, 0, 1},
                                    OperatorAction{DevicePort::kStickLeft, Verb::kSlide, 0, 0.75},
                                    OperatorAction{DevicePort::kStickRight, Verb::kHat, 2},
                                    OperatorAction{DevicePort::kKeyboard, Verb::kPush, 44},
                                    OperatorAction{DevicePort::kKeyboard, Verb::kRelease, 44},
                                    OperatorAction{DevicePort::kPointer, Verb::kMove, 0, 0.25, 1},
                                    OperatorAction{DevicePort::kPointer, Verb::kPush},
                                    OperatorAction{DevicePort::kPointer, Verb::kRoll, 0, -0.5},
                                    OperatorAction{DevicePort::kCamera, Verb::kLips, 0, 0.9, 1.2},
                                    OperatorAction{DevicePort::kCamera, Verb::kCoverLens, 1},
                                    OperatorAction{DevicePort::kCamera, Verb::kUnplug}));
}

TEST(ConsoleInput, AreNoneInAnEmptyMessage) {
  const auto actions = ReadInput("\n  \n");
  ASSERT_TRUE(actions);
  EXPECT_THAT(*actions, IsEmpty());
}

TEST(ConsoleInput, NameLineAndColumnOfABadOne) {
  EXPECT_EQ(Refused("dial 1 turn 0\ndial 9 turn 1"), "2:6: no dial 9; dials are 1 to 8");
  EXPECT_THAT(Refused("hold 33"), HasSubstr("buttons are 1 to 32"));
  EXPECT_THAT(Refused("left move 0 1.01"), HasSubstr("1:13: \"1.01\""));
  EXPECT_THAT(Refused("kettle 1"), HasSubstr("unknown word \"kettle\""));
  EXPECT_THAT(Refused("lens cover twice"), HasSubstr("1:12: nothing more is expected"));
}

TEST(ConsoleInput, TakeNoTime) {
  for (const char* line :
       {"push 3", "left push 1", "key space tap", "click pointer", "say \"ka\"", "scene poster"})
    EXPECT_THAT(Refused(line), HasSubstr("this takes time")) << line;
  for (const char* line : {"at 1s dial 1 turn 1", "over 1s dial 1 turn 1", "dial 1 turn 1 over 1s"})
    EXPECT_NE(Refused(line), "taken") << line;
}

TEST(ConsoleInput, AreNeverNumbersThatAreNone) {
  for (const char* number : {"nan", "inf", "-inf", "1e999", "0x1", "1,5", "", "--1", "1 1"})
    EXPECT_NE(Refused(std::string("dial 1 turn ") + number), "taken") << number;
}

TEST(ConsoleInput, AllStayStillWhenOneLineIsWrong) {
  EXPECT_FALSE(ReadInput("dial 1 turn 1\nhold 40\ndial 2 turn 1"));
}

TEST(ConsoleHeld, LetsGoOfWhatIsHeldAndOfNothingElse) {
  Held held;
  const auto lines = ReadInput(
      "hold 3\nhold 4\nrelease 3\nleft move 1 0\nleft move 0.5 0\nright twist 1\nright twist 0\n"
      "left slide 1\nkey usage-44 press\npointer 0.3 0.4\npress pointer\nroll pointer 2\nlips 1 1\ndial 1 "
      "turn 1\nunplug screen");
  ASSERT_TRUE(lines) << lines.error().message();
  for (const OperatorAction& action : *lines) held.Note(action);
  EXPECT_THAT(held.LetGo(), ElementsAre(OperatorAction{DevicePort::kDialBox, Verb::kRelease, 3},
                                        OperatorAction{DevicePort::kStickLeft, Verb::kMove},
                                        OperatorAction{DevicePort::kKeyboard, Verb::kRelease, 44},
                                        OperatorAction{DevicePort::kPointer, Verb::kRelease},
                                        OperatorAction{DevicePort::kCamera, Verb::kLips, 0, 0.25, 1}));
  EXPECT_THAT(held.LetGo(), IsEmpty());
}

TEST(ConsoleHeld, LeavesSwitchesThatStayAsTheyWerePut) {
  Held held;
  const auto lines = ReadInput("line go on\nline blackout on\nline service on");
  ASSERT_TRUE(lines) << lines.error().message();
  for (const OperatorAction& action : *lines) held.Note(action);
  EXPECT_THAT(held.LetGo(), ElementsAre(OperatorAction{DevicePort::kLines, Verb::kRelease, 0}));
}

// Two rows: the lower one red, the upper one blue; 16 columns and rows a colour, so that JPEG keeps them
// apart.
std::vector<std::uint8_t> RedBelowBlue() {
  std::vector<std::uint8_t> rgbx;
  for (int pixel = 0; pixel < 32 * 32; ++pixel) {
    const bool lower = pixel < 32 * 16;
    const std::uint8_t red = lower ? 255 : 0;
    const std::uint8_t blue = lower ? 0 : 255;
    rgbx.insert(rgbx.end(), {red, 0, blue, 0});
  }
  return rgbx;
}

TEST(ConsolePicture, HasItsTopAtTheTop) {
  web::JpegEncoder encoder;
  const auto jpeg = encoder.Encode({32, 32, RedBelowBlue()}, 95);
  ASSERT_TRUE(jpeg) << jpeg.error().message();
  std::vector<std::uint8_t> rgb(32 * 32 * 3);
  tjhandle decoder = tjInitDecompress();
  ASSERT_EQ(tjDecompress2(decoder, reinterpret_cast<const unsigned char*>(jpeg->data()), jpeg->size(),
                          rgb.data(), 32, 0, 32, TJPF_RGB, 0),
            0);
  tjDestroy(decoder);
  EXPECT_GT(rgb[2], 200) << "the first row that a browser shows is the upper one";
  EXPECT_GT(rgb[32 * 31 * 3], 200);
}

TEST(ConsolePicture, IsRefusedWhenItsSizeLies) {
  web::JpegEncoder encoder;
  const auto rgbx = RedBelowBlue();
  EXPECT_FALSE(encoder.Encode({32, 33, rgbx}, 85));
  EXPECT_FALSE(encoder.Encode({0, 0, {}}, 85));
  EXPECT_FALSE(encoder.Encode({-32, -32, rgbx}, 85));
}

TEST(ConsoleWords, KeepLabelsWithQuotesAndBrokenTextWhole) {
  Labels labels;
  labels.buttons[0] = {"\"Kaori\" \xE3\x82\xAB", "face"};
  labels.dials[0].text = "torn \xE3\x82";
  const auto json = LabelsJson(labels);
  EXPECT_THAT(json, HasSubstr("\\\"Kaori\\\" \xE3\x82\xAB"));
  EXPECT_THAT(json, HasSubstr("torn \xEF\xBF\xBD"));
}

// A file of labels, gone with the test.
class ConsoleLabels : public ::testing::Test {
 protected:
  ~ConsoleLabels() override { std::remove(path_.c_str()); }
  Result<Labels> Load(std::string_view text) {
    std::ofstream(path_) << text;
    return LoadLabels(path_);
  }
  std::string path_ = ::testing::TempDir() + "kaori-labels-" + std::to_string(::getpid());
};

TEST_F(ConsoleLabels, ComeBackAsTheyWereWritten) {
  Labels labels;
  labels.show = "Kaori";
  labels.dials[7] = {"Light", "%", 0, 1.2, 1, 1, {"scene"}};
  labels.buttons[31] = {"Night", "scene"};
  labels.second_buttons[4] = {"Angry", "expression"};
  labels.sticks = {{{"Head", "Tilt", "Lean in"}, {"Gaze"}}};
  labels.sticks[1].buttons[11] = {"Laugh", "motion"};
  labels.keys = {{0x3A, "Poster", "scene"}};
  const auto loaded = Load(LabelsJson(labels));
  ASSERT_TRUE(loaded) << loaded.error().message();
  EXPECT_EQ(LabelsJson(*loaded), LabelsJson(labels));
  EXPECT_EQ(loaded->second_buttons[4].text, "Angry");
  EXPECT_EQ(loaded->sticks[1].buttons[11].text, "Laugh");
}

TEST_F(ConsoleLabels, KeepTheirDefaultsWhereNothingIsSaid) {
  const auto loaded = Load("{\"dials\": [\"Face\"]}");
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->dials[0].text, "Face");
  EXPECT_FALSE(loaded->dials[0].has_value());
  ASSERT_EQ(loaded->keys.size(), 1u);
  EXPECT_EQ(loaded->keys[0].text, "Blink");
}

TEST_F(ConsoleLabels, NameTheEntryThatIsWrong) {
  const auto fault = [this](std::string_view text) {
    const auto loaded = Load(text);
    return loaded ? "taken" : loaded.error().attempt;
  };
  EXPECT_THAT(fault("{"), HasSubstr("no JSON object"));
  EXPECT_THAT(fault("[]"), HasSubstr("no JSON object"));
  EXPECT_THAT(fault("{\"dials\": [\"a\", 2]}"), HasSubstr("dials, entry 2"));
  EXPECT_THAT(fault("{\"dials\": [1,2,3,4,5,6,7,8,9]}"), HasSubstr("8 at most"));
  EXPECT_THAT(fault("{\"buttons\": [\"a\"]}"), HasSubstr("buttons, entry 1"));
  EXPECT_THAT(fault("{\"sticks\": [{\"buttons\": [3]}]}"), HasSubstr("sticks, entry 1"));
  EXPECT_THAT(fault("{\"keys\": [{\"usage\": 300}]}"), HasSubstr("keys, entry 1"));
  EXPECT_THAT(fault("{\"keys\": 3}"), HasSubstr("keys are"));
  EXPECT_FALSE(LoadLabels("/nowhere/labels.json"));
}

// A dial box and a keyboard that somebody plays, and one dial that shows a value.
class ConsoleDialValues : public ::testing::Test {
 protected:
  static Labels OneDial() {
    Labels labels;
    labels.dials[0] = {"Face", "%", 0, 1.2, 2, 1, {"face"}};
    labels.buttons[3] = {"Dog", "face"};
    labels.second_buttons[5] = {"Kettle", "face"};
    labels.keys = {{0x3A, "Poster", "face"}};
    return labels;
  }
  double Value(std::size_t sheet = 0) {
    values_.Follow(box_, keyboard_, sheet);
    return values_.value(0).value();
  }

  ManualClock clock_;
  sim::DeviceContext context_{clock_, {}};
  sim::DialBox box_{context_};
  sim::Keyboard keyboard_{context_};
  DialValues values_{OneDial()};
};

TEST_F(ConsoleDialValues, MoveWithTheDialAndStopAtTheirEnds) {
  EXPECT_DOUBLE_EQ(Value(), 1);
  box_.Turn(0, -0.25);
  EXPECT_DOUBLE_EQ(Value(), 0.5);
  box_.Turn(0, 3);
  EXPECT_DOUBLE_EQ(Value(), 1.2) << "the dial went on, the value did not";
  box_.Turn(0, -0.1);
  EXPECT_DOUBLE_EQ(Value(), 1.0) << "and comes back at once";
}

TEST_F(ConsoleDialValues, AreFilledByAPushOnce) {
  box_.Turn(0, -0.5);
  EXPECT_DOUBLE_EQ(Value(), 0);
  box_.Push(3);
  EXPECT_DOUBLE_EQ(Value(), 1);
  box_.Turn(0, -0.25);
  EXPECT_DOUBLE_EQ(Value(), 0.5) << "a button that stays down fills no more";
  keyboard_.Press(0x3A);
  EXPECT_DOUBLE_EQ(Value(), 1);
  box_.Turn(0, -0.25);
  EXPECT_DOUBLE_EQ(Value(), 0.5);
}

TEST_F(ConsoleDialValues, AreFilledByWhatButtonsCallOnTheSheetThatIsThere) {
  box_.Turn(0, -0.5);
  box_.Push(3);
  EXPECT_DOUBLE_EQ(Value(1), 0);
  box_.Push(5);
  EXPECT_DOUBLE_EQ(Value(1), 1);
}

TEST_F(ConsoleDialValues, AreUnknownWhereNoLabelTellsOfThem) {
  values_.Follow(box_, keyboard_, 0);
  EXPECT_FALSE(values_.value(1));
}

TEST(ConsoleRate, IsCountedOverASecond) {
  Rate rate;
  const Time start = Time{} + std::chrono::seconds(5);
  rate.See(100, start);
  EXPECT_EQ(rate.per_s(), 0) << "one look is no rate";
  rate.See(130, start + std::chrono::milliseconds(500));
  EXPECT_EQ(rate.per_s(), 0);
  rate.See(160, start + std::chrono::seconds(1));
  EXPECT_EQ(rate.per_s(), 60);
}

}  // namespace
}  // namespace kaori::console
