// What the status says of a line check and of learn mode.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "appliance/programs/status/lines.h"

namespace kaori::status {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in minutes.
using board::SourceState;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class StatusOfALineCheck : public ::testing::Test {
 protected:
  // What the line about `what` says, with its mark before it; empty where there is none.
  std::string Said(std::string_view what) const {
    for (const Line& line : Describe(state_))
      if (line.what == what) return TextOf({line}).substr(0, 2) + line.words;
    return {};
  }

  State state_{.board = {}, .sound = {}, .facts = {}, .now = Time{} + 1h};
};

TEST_F(StatusOfALineCheck, ALineCheckThatRunsListsEveryControlInThePlaceOfTheDevices) {
  board::LineCheck check{.phase = board::LineCheckPhase::kRunning, .count = 5};
  check.items[0] = {
      .kind = board::CheckedKind::kAxis, .state = board::CheckedState::kSeen, .low = -1, .high = 1};
  check.items[1] = {.kind = board::CheckedKind::kAxis,
                    .number = 2,
                    .state = board::CheckedState::kShort,
                    .low = -0.4F,
                    .high = 1};
  check.items[2] = {.kind = board::CheckedKind::kButton, .device = 2, .number = 2};
  check.items[3] = {.kind = board::CheckedKind::kButton, .device = 2, .number = 3};
  check.items[4] = {.kind = board::CheckedKind::kCamera, .state = board::CheckedState::kMissing};
  state_.board.line_check = {check, state_.now, SourceState::kLive};
  EXPECT_THAT(Said("line check"), HasSubstr("- 1 of 5 are seen."));
  EXPECT_EQ(Said("left stick"), "! twist short way, -0.40 to 1.00; x seen, -1.00 to 1.00.");
  EXPECT_EQ(Said("dial box"), "- buttons 3-4 not yet seen.");
  EXPECT_EQ(Said("camera"), "! not plugged in.");
  EXPECT_THAT(Said("right stick"), IsEmpty()) << "the show has no use for it";
  state_.board.line_check.value.phase = board::LineCheckPhase::kEnded;
  state_.now += 5min;
  EXPECT_THAT(Said("line check"),
              HasSubstr("- It ended 5 minutes ago: 1 of 5 work; camera not plugged in; "));
  EXPECT_THAT(Said("right stick"), HasSubstr("It is not plugged in;")) << "devices are told of again";
}

TEST_F(StatusOfALineCheck, LearnModeSaysWhatIsToBeDoneUntilItEndsOrItsStageDies) {
  EXPECT_THAT(Said("learn mode"), IsEmpty());
  board::Learn learn{.phase = board::LearnPhase::kAsking};
  state_.learn = {learn, state_.now, SourceState::kLive};
  EXPECT_THAT(Said("learn mode"), HasSubstr("- Move the control"));
  learn.phase = board::LearnPhase::kFound;
  learn.found = {.kind = board::CheckedKind::kDial, .device = 2, .number = 2};
  state_.learn.value = learn;
  EXPECT_EQ(Said("learn mode"), "- dial box dial 3 was found: Enter keeps it. No control moves the face.");
  state_.learn.value.phase = board::LearnPhase::kRefused;
  EXPECT_THAT(Said("learn mode"), HasSubstr("! dial box dial 3 could not be kept"));
  state_.now += 10s;
  EXPECT_THAT(Said("learn mode"), IsEmpty()) << "its stage died";
  state_.learn = {learn, state_.now, SourceState::kLive};
  state_.learn.value.phase = board::LearnPhase::kEnded;
  EXPECT_THAT(Said("learn mode"), IsEmpty());
}

}  // namespace
}  // namespace kaori::status
