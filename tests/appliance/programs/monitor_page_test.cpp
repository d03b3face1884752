// The operators' monitor laid out and drawn: at every size, with whatever a show calls its cues.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "appliance/programs/monitor/palette.h"
#include "appliance/programs/monitor/sheet.h"
#include "tests/appliance/programs/monitor_fixture.h"

namespace kaori::monitor {
namespace {

struct ScreenOf {
  int width_px, height_px;
};

class MonitorPage : public ::testing::TestWithParam<ScreenOf> {
 protected:
  Page LaidOut() const { return LayOut(evening_.Now(), GetParam().width_px, GetParam().height_px); }
  static bool IsWithin(const Box& box, const Box& outer) {
    return box.left >= outer.left && box.top >= outer.top && box.right() <= outer.right() &&
           box.bottom() <= outer.bottom();
  }

  MonitorEvening evening_;
};

TEST_P(MonitorPage, WhatMattersIsReadFromTwoMetres) {
  const Page page = LaidOut();
  const int unit = UnitOf(GetParam().width_px, GetParam().height_px);
  if (GetParam().width_px * 9 >= GetParam().height_px * 16) {
    EXPECT_EQ(unit, GetParam().height_px / 36);
  }
  for (const auto& [text, units] : {std::pair{"3", 2.4},
                                    {"He comes", 1.0},
                                    {"After her", 1.0},
                                    {"19:43:10", 1.9},
                                    {"GO", 1.0},
                                    {"poster", 1.0}}) {
    const Piece* const piece = PieceWith(page, text);
    ASSERT_NE(piece, nullptr) << text;
    EXPECT_GE(piece->size_px, static_cast<int>(units * unit)) << text;
  }
  const Piece* const standby = PieceWith(page, "He comes");
  EXPECT_GT(standby->size_px, PieceWith(page, "House lights")->size_px)
      << "what comes is larger than what is";
}

TEST_P(MonitorPage, NothingLeavesTheScreenOrItsCellAndNoCellLiesOnAnother) {
  evening_.show.cue_list.cues[2].name = std::string(300, 'W');
  evening_.show.cue_list.cues[1].name =
      "A name of many words that goes on and on as names of cues in long plays do";
  evening_.show.cue_list.cues[2].notes = std::string(2000, 'm') + std::string(500, ' ') + "end";
  evening_.show.cue_list.cues[2].number = "12345.678.90123";
  evening_.status = {{status::Mark::kFault, "fault", std::string(500, 'x')}};
  evening_.show_now.value.locked = 1;
  const Page page = LaidOut();
  const Box screen{0, 0, GetParam().width_px, GetParam().height_px};
  for (std::size_t i = 0; i < page.cells.size(); ++i) {
    const Cell& cell = page.cells[i];
    EXPECT_TRUE(IsWithin(cell.box, screen)) << i;
    for (const Piece& piece : cell.pieces)
      EXPECT_TRUE(IsWithin(piece.box, cell.box)) << i << " " << piece.text;
    for (const Box& picture : {page.programme, page.lip_picture})
      EXPECT_FALSE(std::max(picture.left, cell.box.left) < std::min(picture.right(), cell.box.right()) &&
                   std::max(picture.top, cell.box.top) < std::min(picture.bottom(), cell.box.bottom()))
          << i;
    for (std::size_t other = 0; other < i; ++other) {
      const Box& b = page.cells[other].box;
      EXPECT_FALSE(std::max(b.left, cell.box.left) < std::min(b.right(), cell.box.right()) &&
                   std::max(b.top, cell.box.top) < std::min(b.bottom(), cell.box.bottom()))
          << i << " lies on " << other;
    }
  }
}

TEST_P(MonitorPage, CellsStayAtTheirPlacesWhateverHappens) {
  const Page before = LaidOut();
  evening_.show_now.value = {};
  evening_.status = {{status::Mark::kFault, "fault", "The disk is full."}};
  evening_.time_of_day.clear();
  evening_.state.voices[0] = {.motion = 0, .at_s = 1, .gain = 1};
  const Page after = LaidOut();
  EXPECT_TRUE(std::ranges::equal(before.cells, after.cells, {}, &Cell::box, &Cell::box));
}

TEST_P(MonitorPage, AShowWithoutCuesAndAListThatIsOverSaySo) {
  evening_.show_now.value.cue_standby = 3;
  EXPECT_NE(PieceWith(LaidOut(), "The list is over"), nullptr);
  evening_.show.cue_list.cues.clear();
  EXPECT_NE(PieceWith(LaidOut(), "This show has no cues"), nullptr);
  EXPECT_NE(PieceWith(LaidOut(), "No cue was called yet"), nullptr);
}

TEST_P(MonitorPage, ALevelThatSomebodyHasIsShownBeforeThoseThatNobodyHas) {
  for (std::size_t i = 0; i < show::kLevelCount; ++i)
    evening_.show_now.value.levels[i] = {0, board::LevelOwner::kRemote, 0};
  const Page page = LaidOut();
  EXPECT_NE(PieceWith(page, "remote"), nullptr);
  for (auto& level : evening_.show_now.value.levels) level.owner = board::LevelOwner::kNobody;
  evening_.show_now.value.levels[static_cast<std::size_t>(show::Level::kLidRight)].owner =
      board::LevelOwner::kCue;
  const Page one = LaidOut();
  EXPECT_NE(PieceWith(one, "cue"), nullptr);
}

TEST_P(MonitorPage, ABarIsAsLongAsItsLevelIsFromItsRest) {
  auto& level = evening_.show_now.value.levels[static_cast<std::size_t>(show::Level::kMouthOpen)];
  const auto widest = [&](float value) {
    level = {value, board::LevelOwner::kLips, 0};
    int width = 0;
    for (const Cell& cell : LaidOut().cells)
      for (const Piece& piece : cell.pieces)
        if (piece.size_px == 0 && piece.colour == kByLips && piece.box.height < piece.box.width)
          width = piece.box.width;
    return width;
  };
  const int whole = widest(1);
  ASSERT_GT(whole, 8);
  EXPECT_NEAR(widest(0.5F), whole / 2, 1);
}

INSTANTIATE_TEST_SUITE_P(Screens, MonitorPage,
                         ::testing::Values(ScreenOf{1280, 720}, ScreenOf{1920, 1080}, ScreenOf{3840, 2160},
                                           ScreenOf{1024, 768}, ScreenOf{640, 480}, ScreenOf{800, 600},
                                           ScreenOf{1080, 1920}, ScreenOf{2560, 1080}),
                         [](const auto& screen) {
                           return std::to_string(screen.param.width_px) + "x" +
                                  std::to_string(screen.param.height_px);
                         });

class MonitorSheet : public ::testing::Test {
 protected:
  static constexpr int kWidth_px = 640, kHeight_px = 360;

  void DrawAll() {
    sheet_.Set(LayOut(evening_.Now(), kWidth_px, kHeight_px));
    for (drawn_ = 0; sheet_.DrawNext();) ++drawn_;
  }
  // How many pixels of the box have this colour.
  int CountIn(const Box& box, const Colour& colour) const {
    int count = 0;
    for (int y = box.top; y < box.bottom(); ++y)
      for (int x = box.left; x < box.right(); ++x) {
        const auto* at =
            sheet_.picture().rgbx.data() + (std::size_t(kHeight_px - 1 - y) * kWidth_px + std::size_t(x)) * 4;
        count += std::equal(colour.begin(), colour.end(), at) ? 1 : 0;
      }
    return count;
  }

  MonitorEvening evening_;
  Sheet sheet_{image::Lettering::Open().value(), kWidth_px, kHeight_px};
  int drawn_ = 0;
};

TEST_F(MonitorSheet, DrawsOnlyWhatChanged) {
  DrawAll();
  EXPECT_GT(drawn_, 20);
  DrawAll();
  EXPECT_EQ(drawn_, 0);
  evening_.time_of_day = "19:43:11";
  DrawAll();
  EXPECT_EQ(drawn_, 1);
}

TEST_F(MonitorSheet, HasLettersWhereThePageSaysAndInTheirColour) {
  DrawAll();
  EXPECT_GT(CountIn(PieceWith(sheet_.page(), "He comes")->box, kText), 20);
  EXPECT_GT(CountIn(PieceWith(sheet_.page(), "3")->box, kAmber), 20);
}

TEST_F(MonitorSheet, ACellThatAlwaysChangesKeepsNoOtherWaiting) {
  DrawAll();
  const auto turn = [&](int n) {
    evening_.time_of_day = std::to_string(n);
    evening_.show.cue_list.cues[2].name = "Renamed";
    sheet_.Set(LayOut(evening_.Now(), kWidth_px, kHeight_px));
    sheet_.DrawNext();
  };
  turn(1);
  turn(2);
  sheet_.Set(LayOut(evening_.Now(), kWidth_px, kHeight_px));
  const Box& name = PieceWith(sheet_.page(), "Renamed")->box;
  const int letters = CountIn(name, kText);
  while (sheet_.DrawNext()) continue;
  EXPECT_EQ(CountIn(name, kText), letters) << "it was drawn at the second turn";
}

TEST_F(MonitorSheet, TheProgrammeKeepsItsProportionsBetweenBlackBars) {
  DrawAll();
  const std::vector<std::uint8_t> red = {200, 0, 0, 9, 200, 0, 0, 9};  // Two above one another.
  sheet_.DrawProgramme({1, 2, red});
  const Box& place = sheet_.page().programme;
  EXPECT_NEAR(CountIn(place, {200, 0, 0}), place.height * place.height / 2, place.height);
  EXPECT_EQ(CountIn(place, {0, 0, 0}) + CountIn(place, {200, 0, 0}), place.width * place.height);
  sheet_.DrawProgramme({});
  EXPECT_EQ(CountIn(place, {0, 0, 0}), place.width * place.height);
}

TEST_F(MonitorSheet, TheTopRowOfAPictureIsAtTheTop) {
  DrawAll();
  const std::vector<std::uint8_t> rows = {200, 0, 0, 9, 0, 200, 0, 9};
  sheet_.DrawProgramme({1, 2, rows});
  Box upper = sheet_.page().programme;
  upper = CutTop(upper, upper.height / 2);
  EXPECT_EQ(CountIn(upper, {0, 200, 0}), 0);
  EXPECT_GT(CountIn(upper, {200, 0, 0}), 100);
}

TEST_F(MonitorSheet, PaintIsTintedInTheLipsPictureAndSkinIsNot) {
  DrawAll();
  const std::vector<std::uint8_t> pixels = {90, 90, 90, 0, 90, 90, 90, 255};
  sheet_.DrawLips({2, 1, pixels});
  const Box& place = sheet_.page().lip_picture;
  const int skin = CountIn(place, {90, 90, 90});
  EXPECT_GT(skin, 100);
  EXPECT_NEAR(
      CountIn(place, {std::uint8_t((90 + 2 * kByLips[0]) / 3), std::uint8_t((90 + 2 * kByLips[1]) / 3),
                      std::uint8_t((90 + 2 * kByLips[2]) / 3)}),
      skin, place.height);
}

TEST(MonitorSheetOf, AnyMadSizeIsNoCrash) {
  const MonitorEvening evening;
  for (const auto& [width, height] : {std::pair{16, 16}, {17, 900}, {900, 17}, {5000, 20}}) {
    Sheet sheet(image::Lettering::Open().value(), width, height);
    sheet.Set(LayOut(evening.Now(), width, height));
    while (sheet.DrawNext()) continue;
    sheet.DrawProgramme({});
    sheet.DrawLips({});
  }
}

}  // namespace
}  // namespace kaori::monitor
