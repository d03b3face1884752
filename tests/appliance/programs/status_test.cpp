// The status of the box: in sentences, and drawn as a picture.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "appliance/core/board/lines.h"
#include "appliance/core/board/mouth.h"
#include "appliance/programs/status/lines.h"
#include "appliance/programs/status/screens_file.h"
#include "appliance/programs/status/sheet.h"
#include "tests/appliance/core/board_file.h"

namespace kaori::status {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in minutes.
using board::SourceState;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class StatusWords : public ::testing::Test {
 protected:
  // What the line about `what` says, with its mark before it; empty where there is none.
  std::string Said(std::string_view what) const {
    for (const Line& line : Describe(state_))
      if (line.what == what) return TextOf({line}).substr(0, 2) + line.words;
    return {};
  }

  State state_{.board = {}, .sound = {}, .facts = {}, .now = Time{} + 1h};
};

TEST_F(StatusWords, ABoxWithNothingPluggedInNamesAllThatIsMissing) {
  for (const char* what : {"dial box", "left stick", "right stick", "keyboard", "camera", "microphone",
                           "loudspeaker", "switches"})
    EXPECT_THAT(Said(what), HasSubstr("- It is not plugged in;")) << what;
  EXPECT_THAT(Said("screens"), HasSubstr("! No screen is plugged in"));
  EXPECT_THAT(Said("show"), HasSubstr("! There is no screen"));
}

TEST_F(StatusWords, AnUnpluggedDeviceIsNamedWithTheTimeSince) {
  state_.board.surface = {{}, state_.now - 2s, SourceState::kStale};
  EXPECT_EQ(Said("dial box"), "- It was unplugged a moment ago; the dials keep their values.");
  state_.now += 5min;
  EXPECT_THAT(Said("dial box"), HasSubstr("It was unplugged 5 minutes ago;"));
  state_.now += 2h;
  EXPECT_THAT(Said("dial box"), HasSubstr("It was unplugged 2 hours ago;"));
}

TEST_F(StatusWords, AnUpdateThatGaveWayIsSaidWithItsReason) {
  state_.facts.update = {"version 12: it was tried and gave way; the system before plays (it is black)"};
  EXPECT_THAT(Said("update"), HasSubstr("- version 12: it was tried and gave way"));
}

TEST_F(StatusWords, AUsbDeviceThatStaysOutIsSaidWithItsPort) {
  EXPECT_THAT(Said("refused"), IsEmpty());
  state_.facts.usb = {"USB port 1-2: a storage device stays out while the service key is off"};
  EXPECT_EQ(Said("refused"), "- USB port 1-2: a storage device stays out while the service key is off");
}

TEST_F(StatusWords, AShowThatWasRefusedHasTheMarkOfAFaultAndAListHasNot) {
  state_.facts.shows = {"! guest: this box does not trust its signer"};
  EXPECT_EQ(Said("stick"), "! guest: this box does not trust its signer");
  state_.facts.shows = {"take a show by its number"};
  EXPECT_EQ(Said("stick"), "  take a show by its number");
}

TEST_F(StatusWords, APluggedInDeviceIsNamed) {
  state_.board.surface = {{}, state_.now, SourceState::kLive};
  EXPECT_EQ(Said("dial box"), "  It is plugged in.");
}

TEST_F(StatusWords, TheShowSaysItsRateAndWhatCameLate) {
  state_.facts.screens = {{.connector = "HDMI-A-1", .width_px = 640, .height_px = 480, .rate_hz = 60}};
  EXPECT_THAT(Said("show"), HasSubstr("! There is no picture yet"));
  state_.board.stage_status = {
      {.draw = 6200us, .missed_flips = 3, .frames_per_s = 59.9F}, state_.now, SourceState::kLive};
  EXPECT_EQ(Said("show"), "  The show has 60 frames a second, 6.2 ms each; 3 were late; basic quality.");
  state_.board.stage_status.value.quality = 1;
  EXPECT_EQ(Said("show"), "  The show has 60 frames a second, 6.2 ms each; 3 were late; fine quality.");
  state_.now += 30s;
  EXPECT_EQ(Said("show"), "! There has been no picture for less than a minute.");
}

TEST_F(StatusWords, ACameraThatSeesNoUsableMouthIsMarkedAsMissing) {
  state_.board.lips = {{.quality = 0}, state_.now, SourceState::kLive};
  EXPECT_EQ(Said("camera"), "- It is plugged in and sees no painted mouth.");
  state_.board.lips.value.quality = board::kUsableMouth;  // As the face follows it.
  EXPECT_EQ(Said("camera"), "  It sees the mouth.");
}

TEST_F(StatusWords, ABlackoutIsNamedSoThatNobodyLooksForAnotherCause) {
  state_.board.lines = {{.active = 1U << unsigned(board::Line::kBlackout)}, state_.now, SourceState::kLive};
  EXPECT_EQ(Said("switches"), "  It is plugged in. On: BLACKOUT.");
}

TEST_F(StatusWords, FaultsComeBeforeEverythingElse) {
  state_.facts.faults = {"box.toml, line 3: there is no setting profil; the profile is stage"};
  const auto lines = Describe(state_);
  ASSERT_GT(lines.size(), 2U);
  EXPECT_EQ(lines[1].mark, Mark::kFault);
  EXPECT_EQ(lines[1].words, state_.facts.faults[0]);
}

TEST_F(StatusWords, ScreensAreToldByTheirNames) {
  const ports::Output unplugged{.connector = "HDMI-A-2",
                                .width_px = 800,
                                .height_px = 600,
                                .rate_hz = 60,
                                .state = ports::OutputState::kUnplugged};
  state_.facts.screens = {{.connector = "HDMI-A-1", .width_px = 1920, .height_px = 1080, .rate_hz = 60},
                          unplugged};
  EXPECT_EQ(Said("HDMI-A-1"), "  1920 x 1080 at 60 Hz");
  EXPECT_EQ(Said("HDMI-A-2"), "- 800 x 600 at 60 Hz, pulled");
  EXPECT_THAT(Said("screens"), IsEmpty());
}

TEST_F(StatusWords, TheTitleSaysProfileAndRoot) {
  state_.facts.profile = "kiosk";
  state_.facts.root_hash = std::string(128, 'b');
  EXPECT_THAT(Said("Kaori box"), AllOf(HasSubstr("Profile kiosk"), HasSubstr("hash bbbbbbbbbbbb.")));
  state_.facts.slot = "B";
  state_.facts.name = "left-lobby";
  EXPECT_THAT(Said("Kaori box"), AllOf(HasSubstr("This box is left-lobby. Profile kiosk"),
                                       HasSubstr("hash bbbbbbbbbbbb, slot B.")));
}

ports::Output MadeOutput(ports::ModeOrigin origin, ports::OutputState state) {
  return {.connector = "DP-1",
          .width_px = 1280,
          .height_px = 720,
          .rate_hz = 60000.0 / 1001,
          .origin = origin,
          .state = state};
}

TEST(StatusScreens, EveryStateAndOriginIsReadAsItWasWritten) {
  std::vector<ports::Output> outputs;
  for (const auto origin :
       {ports::ModeOrigin::kWanted, ports::ModeOrigin::kSubstitute, ports::ModeOrigin::kSafeGuess})
    for (const auto state : {ports::OutputState::kShowsPicture, ports::OutputState::kUnplugged,
                             ports::OutputState::kShowsStatus, ports::OutputState::kShowsMonitor})
      outputs.push_back(MadeOutput(origin, state));
  EXPECT_EQ(ParseScreens(FormatScreens(outputs)), outputs);
}

TEST(StatusScreens, AnUnpluggedScreenIsMissingWhateverWordsPeopleReadOfIt) {
  State state{.board = {}, .sound = {}, .facts = {}, .now = Time{} + 1h};
  state.facts.screens = {MadeOutput(ports::ModeOrigin::kSubstitute, ports::OutputState::kUnplugged),
                         MadeOutput(ports::ModeOrigin::kSubstitute, ports::OutputState::kShowsStatus)};
  std::vector<Mark> marks;
  for (const Line& line : Describe(state))
    if (line.what == "DP-1") marks.push_back(line.mark);
  EXPECT_THAT(marks, ::testing::ElementsAre(Mark::kMissing, Mark::kGood));
}

TEST(StatusScreens, LinesThatAreNoScreensArePassedOver) {
  const std::string good =
      FormatScreens(std::vector{MadeOutput(ports::ModeOrigin::kWanted, ports::OutputState::kUnplugged)});
  for (const char* bad : {"", "DP-1", "DP-1 1280x720 60 wanted", "DP-1 1280x720 60 wanted pulled",
                          "DP-1 1280x720 60 lucky picture", "DP-1 1280 x 720 60 wanted picture"})
    EXPECT_EQ(ParseScreens(std::string(bad) + "\n" + good).size(), 1U) << bad;
  EXPECT_TRUE(ParseScreens(good.substr(0, good.size() / 2)).empty());
}

class StatusSheet : public ::testing::Test {
 protected:
  static Sheet Make(int width_px, int height_px) {
    return Sheet(image::Lettering::Open().value(), width_px, height_px);
  }
  // How many pixels of these rows are of this colour, nearly.
  static int Count(const image::Picture& picture, Sheet::Rows rows, int r, int g, int b) {
    int count = 0;
    for (int i = rows.first * picture.width_px; i < rows.end * picture.width_px; ++i) {
      const std::uint8_t* const p = picture.rgbx.data() + std::size_t(i) * 4;
      count += std::abs(p[0] - r) + std::abs(p[1] - g) + std::abs(p[2] - b) < 40 ? 1 : 0;
    }
    return count;
  }

  std::vector<Line> lines_{{Mark::kTitle, "Kaori box", "profile stage"},
                           {Mark::kGood, "dial box", "there"},
                           {Mark::kMissing, "camera", "not plugged in"}};
};

TEST_F(StatusSheet, DrawsOneLineAtATimeUntilAllOfThemStand) {
  Sheet sheet = Make(640, 480);
  int drawn = 0;
  int lowest = 480;
  while (const auto rows = sheet.DrawNext(lines_)) {
    EXPECT_LT(rows->first, rows->end);
    lowest = std::min(lowest, rows->first);
    ASSERT_LT(++drawn, 100);
  }
  EXPECT_GE(lowest, 0);
  EXPECT_GE(drawn, 3);
  EXPECT_FALSE(sheet.DrawNext(lines_)) << "nothing changed";
}

TEST_F(StatusSheet, ALineThatChangedAloneIsDrawnAnew) {
  Sheet sheet = Make(640, 480);
  while (sheet.DrawNext(lines_)) continue;
  const auto before = sheet.picture().rgbx;
  lines_[1] = {Mark::kMissing, "dial box", "gone for a moment"};
  const auto rows = sheet.DrawNext(lines_);
  ASSERT_TRUE(rows);
  EXPECT_FALSE(sheet.DrawNext(lines_));
  const auto& after = sheet.picture().rgbx;
  for (int y = 0; y < 480; ++y) {
    const auto row = std::ptrdiff_t{y} * 640 * 4;
    const bool same = std::equal(before.begin() + row, before.begin() + row + 640 * 4, after.begin() + row);
    EXPECT_TRUE(same || (y >= rows->first && y < rows->end)) << "row " << y;
  }
}

TEST_F(StatusSheet, WhatBecameAFaultIsSaidBeforeANumberThatChanged) {
  Sheet sheet = Make(640, 480);
  while (sheet.DrawNext(lines_)) continue;
  lines_[0].words = "profile kiosk";
  lines_[2].mark = Mark::kFault;
  const auto first = sheet.DrawNext(lines_), second = sheet.DrawNext(lines_);
  ASSERT_TRUE(first && second);
  EXPECT_LT(first->first, second->first) << "the lower line went first";
}

TEST_F(StatusSheet, MissingThingsAreAmberAndFaultsAreRed) {
  const auto amber = DrawAll({{Mark::kMissing, "camera", "not plugged in"}}, 640, 480).value();
  EXPECT_GT(Count(amber, {0, 480}, 235, 170, 50), 100);
  EXPECT_EQ(Count(amber, {0, 480}, 240, 80, 70), 0);
  EXPECT_GT(Count(DrawAll({{Mark::kFault, "camera", "broken"}}, 640, 480).value(), {0, 480}, 240, 80, 70),
            100);
}

TEST_F(StatusSheet, EverySentenceIsShownToItsEnd) {
  State state{.board = {}, .sound = {}, .facts = {}, .now = Time{} + 1h};
  state.facts.profile = "stage";
  state.facts.root_hash = std::string(64, '8');
  state.facts.slot = "B";
  state.facts.faults = {
      "box.toml, line 12: there is no setting status_scren; do you mean status_screen? It is passed over"};
  state.facts.screens = {MadeOutput(ports::ModeOrigin::kSafeGuess, ports::OutputState::kUnplugged)};
  const Time pulled = state.now - 50s;
  state.board.sticks.fill({{}, pulled, SourceState::kStale});
  state.board.surface.at = state.board.keys.at = state.board.lips.at = state.board.voice.at =
      state.board.lines.at = state.sound.at = pulled;
  state.board.surface.source = state.board.keys.source = state.board.lips.source = state.board.voice.source =
      state.board.lines.source = state.sound.source = SourceState::kStale;
  state.board.lines.value.active = 15;
  const auto lines = Describe(state);
  for (const auto& [width_px, height_px] : {std::pair{640, 480}, {1024, 768}}) {
    const auto picture = DrawAll(lines, width_px, height_px).value();
    for (std::size_t i = 0; i < lines.size(); ++i) {
      auto other = lines;
      other[i].words.back() = other[i].words.back() == '#' ? '.' : '#';
      EXPECT_NE(DrawAll(other, width_px, height_px).value().rgbx, picture.rgbx)
          << width_px << " x " << height_px << ": " << lines[i].words;
    }
  }
}

TEST_F(StatusSheet, LinesForWhichThereIsNoRoomAreCounted) {
  lines_.assign(200, {Mark::kGood, "screen", "there"});
  EXPECT_GT(Count(DrawAll(lines_, 640, 480).value(), {0, 480 / 8}, 235, 170, 50), 50) << "in amber";
}

TEST_F(StatusSheet, AnySizeIsDrawn) {
  lines_.push_back({Mark::kFault, std::string(400, 'x'), std::string(4000, 'y')});
  for (const auto& [width_px, height_px] :
       {std::pair{16, 16}, {17, 4000}, {4000, 16}, {320, 180}, {3840, 2160}}) {
    const auto picture = DrawAll(lines_, width_px, height_px).value();
    EXPECT_EQ(std::pair(picture.width_px, picture.height_px), std::pair(width_px, height_px));
  }
}

TEST_F(StatusSheet, SaysItInLettersThatCanBeReadInSmall) {
  Sheet sheet = Make(480, 270);
  lines_.resize(1);
  const auto rows = sheet.DrawNext(lines_);
  ASSERT_TRUE(rows);
  EXPECT_GE(rows->end - rows->first, 12) << "pixels from line to line";
  EXPECT_LT(Count(sheet.picture(), *rows, 16, 18, 22), 480 * (rows->end - rows->first) - 200)
      << "there is ink";
}

}  // namespace
}  // namespace kaori::status
