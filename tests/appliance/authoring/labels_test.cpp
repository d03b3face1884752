// What is written on the controls is what the controls do.
#include "appliance/authoring/script/labels.h"

#include <fstream>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "appliance/core/performance/calls.h"
#include "appliance/core/performance/levels.h"
#include "appliance/core/roles/own_buttons.h"
#include "hw-sim/console/labels.h"
#include "tests/appliance/core/performance_fixture.h"

namespace kaori::authoring {
namespace {

using performance::State;

constexpr std::uint16_t kKeyQ = 0x14;  // HID usage page 7.

show::Show NamedShow() {
  show::Show show = performance::SmallShow();
  for (std::size_t i = 0; i < show.cast.faces.size(); ++i)
    show.cast.faces[i].name = "face_" + std::to_string(i);
  for (std::size_t i = 0; i < show.cast.expressions.size(); ++i)
    show.cast.expressions[i].name = "in_mood_" + std::to_string(i);
  show.scenes[0].name = "studio";
  show.scenes[1].name = "kitchen";
  show.second_buttons[2] = {show::CallKind::kExpression, 1, show::CallMode::kToggle};
  show.second_buttons[3] = {show::CallKind::kFace, 1};
  show.second_buttons[4] = {show::CallKind::kSheet, 0};
  show.stick_buttons[show::kStickButtonCount + 11] = {show::CallKind::kFace, 3};
  show.roles.mixes = {{show::CallKind::kFace, 2}};
  show.keys = {{kKeyQ, {show::CallKind::kStyle, static_cast<std::uint16_t>(scene::Style::kWire)}}};
  return show;
}

// The labels as the simulator's page reads them.
class AuthoredLabels : public ::testing::Test {
 protected:
  AuthoredLabels() {
    std::ofstream(path_) << LabelsJson(show_);
    labels_ = console::LoadLabels(path_).value();
  }
  ~AuthoredLabels() override { std::remove(path_.c_str()); }

  // The stage's knob after so many turns of its dial.
  float Turned(std::size_t dial, double turns) const {
    State state = performance::Opening(show_, {}, Time{});
    performance::InputEvents events;
    events.turned[dial] = static_cast<std::int32_t>(turns * 256);
    performance::MoveLevels(state, {}, events, show_.roles, 0);
    return state.knobs[dial];
  }

  std::string path_ = ::testing::TempDir() + "kaori-atelier-labels-" + std::to_string(::getpid());
  show::Show show_ = NamedShow();
  console::Labels labels_;
};

TEST_F(AuthoredLabels, TellTheValuesThatThePerformancePlays) {
  for (std::size_t n = 0; n < labels_.dials.size(); ++n) {
    const console::DialLabel& dial = labels_.dials[n];
    EXPECT_NEAR(Turned(n, 0), dial.start, 1e-6) << dial.text;
    EXPECT_NEAR(Turned(n, -100), dial.low, 1e-6) << dial.text;
    EXPECT_NEAR(Turned(n, 100), dial.high, 1e-6) << dial.text;
    const double turns = dial.start < (dial.low + dial.high) / 2 ? 0.125 : -0.125;
    EXPECT_NEAR(Turned(n, turns), dial.start + turns * dial.per_turn, 1e-6) << dial.text;
  }
}

TEST_F(AuthoredLabels, TellWhichDialsACallFills) {
  State state = performance::Opening(show_, {}, Time{});
  state.knobs.fill(0);
  board::Snapshot board;
  board.surface.source = board::SourceState::kLive;
  board::NotePress(board.surface.value, 1, Time{});  // A face.
  performance::PlayCalls(state, performance::ReadEvents(state.seen, board), show_, 0);
  for (std::size_t n = 0; n < labels_.dials.size(); ++n)
    EXPECT_EQ(state.knobs[n] == 1, std::ranges::count(labels_.dials[n].filled_by, "face") == 1)
        << labels_.dials[n].text;
}

TEST_F(AuthoredLabels, NameEveryButtonByWhatItCalls) {
  EXPECT_EQ(labels_.buttons[2].text, "Face 2");
  EXPECT_EQ(labels_.buttons[2].group, "face");
  EXPECT_EQ(labels_.buttons[6].text, "In mood 1");
  EXPECT_EQ(labels_.buttons[6].group, "expression");
  EXPECT_EQ(labels_.buttons[21].text, "Wireframe");
  EXPECT_EQ(labels_.buttons[31].text, "") << "it calls nothing";
}

TEST_F(AuthoredLabels, NameTheButtonsOfTheSecondSheetAndWhichOfThemFillADial) {
  EXPECT_EQ(labels_.second_buttons[2].text, "In mood 1");
  EXPECT_EQ(labels_.second_buttons[2].group, "") << "a toggle joins what was called";
  EXPECT_EQ(labels_.second_buttons[3].text, "Face 1");
  EXPECT_EQ(labels_.second_buttons[3].group, "face");
  EXPECT_EQ(labels_.second_buttons[4].text, "Sheet 1");
}

TEST_F(AuthoredLabels, NameTheButtonsOfTheSticks) {
  EXPECT_EQ(labels_.sticks[0].buttons[0].text, "") << "it calls nothing";
  EXPECT_EQ(labels_.sticks[1].buttons[11].text, "Face 3");
  EXPECT_EQ(labels_.sticks[1].buttons[11].group, "face");
}

TEST_F(AuthoredLabels, NameTheLevelsOfSingleFaces) {
  ASSERT_EQ(labels_.levels.size(), show::kNamedLevels + 1) << "as many as the show plays";
  EXPECT_EQ(labels_.levels.back().text, "Face face 2");
  const std::size_t items = show_.cast.faces.size() + show_.cast.expressions.size();
  const auto calls = roles::TeachableCalls(roles::ItemsOf(show_));
  ASSERT_EQ(labels_.teachable.size(), show::kNamedLevels + items + calls.size() + 1)
      << "the last is the turn of a dial";
  EXPECT_EQ(labels_.teachable[show::kNamedLevels + items], "Call GO");
  EXPECT_EQ(labels_.teachable[show::kNamedLevels + items + show::kCueVerbCount],
            Readable("call face " + show_.cast.faces[0].name));
  EXPECT_EQ(labels_.teachable[static_cast<std::size_t>(show::Level::kHeadYaw)], "Head yaw");
  EXPECT_EQ(labels_.teachable[show::kNamedLevels + 1], "Face " + Readable(show_.cast.faces[1].name));
  EXPECT_EQ(labels_.levels.back().unit, "%");
}

TEST_F(AuthoredLabels, SayOfEachMotionHowLongItIsAndWhatItMoves) {
  ASSERT_EQ(labels_.motions.size(), show_.motions.size());
  ASSERT_FALSE(labels_.motions.empty());
  const show::Motion& motion = show_.motions[0];
  EXPECT_EQ(labels_.motions[0].text, Readable(motion.name));
  EXPECT_NEAR(labels_.motions[0].length_s, show::EndOf(motion), 1e-3);
  EXPECT_EQ(labels_.motions[0].loops, motion.Loops());
  EXPECT_EQ(labels_.motions[0].take, motion.recorded);
  EXPECT_NE(labels_.motions[0].moves, "");
}

TEST_F(AuthoredLabels, NameTheKeysThatDoSomething) {
  const auto text = [this](std::uint8_t usage) -> std::optional<std::string> {
    const auto it = std::ranges::find(labels_.keys, usage, &console::KeyLabel::usage);
    return it == labels_.keys.end() ? std::nullopt : std::optional(it->text + " " + it->group);
  };
  EXPECT_EQ(text(performance::kSpace), "Blink blink");
  EXPECT_EQ(text(performance::kKey1), "Nod motion");
  EXPECT_EQ(text(performance::kF1), "Kitchen scene");
  EXPECT_EQ(text(kKeyQ), "Wireframe style");
  EXPECT_EQ(labels_.keys.size(), 6U) << "a scene without a key has none";
}

TEST(Readable, IsWhatPeopleWouldWrite) {
  EXPECT_EQ(Readable("in_love"), "In love");
  EXPECT_EQ(Readable("look around"), "Look around");
  EXPECT_EQ(Readable(""), "");
}

}  // namespace
}  // namespace kaori::authoring
