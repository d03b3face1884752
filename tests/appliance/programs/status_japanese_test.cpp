// The status picture in Japanese: what the box says to whoever reads no English.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "appliance/programs/status/facts.h"
#include "appliance/programs/status/lines.h"
#include "appliance/programs/status/sheet.h"
#include "tests/appliance/core/board_file.h"

namespace kaori::status {
namespace {

using ::testing::Contains;

// Columns of a picture with ink of this colour, nearly: the first and the last one.
std::pair<int, int> InkOf(const image::Picture& picture, int r, int g, int b) {
  int first = picture.width_px, last = -1;
  for (int i = 0; i < picture.width_px * picture.height_px; ++i) {
    const std::uint8_t* const p = picture.rgbx.data() + std::size_t(i) * 4;
    if (std::abs(p[0] - r) + std::abs(p[1] - g) + std::abs(p[2] - b) > 90) continue;
    first = std::min(first, i % picture.width_px);
    last = std::max(last, i % picture.width_px);
  }
  return {first, last};
}

// Its letters are white, as those of a working part.
image::Picture Drawn(const std::string& words, int width_px = 1280, int height_px = 720) {
  return DrawAll({{Mark::kGood, "", words}}, width_px, height_px).value();
}

TEST(JapaneseStatus, SaysWhatFilesSayInBothLanguages) {
  const board::BoardFile place;
  Places places{place.folder(), place.folder() / "screens", place.folder() / "notices"};
  places.shows = place.folder() / "shows";
  std::ofstream(place.folder() / "faults") << "the box has no network\nネットワークにつながりません\n";
  std::ofstream(place.folder() / "shows") << "! 夜: it is damaged\n! 夜: 壊れています\n> 1  夜  2 MB\n";
  const auto lines = Describe({.board = {}, .sound = {}, .facts = ReadFacts(places), .now = Time{}});
  EXPECT_THAT(lines, Contains(Line{Mark::kFault, "fault", "ネットワークにつながりません"}));
  EXPECT_THAT(lines, Contains(Line{Mark::kFault, "stick", "夜: 壊れています"}));
  EXPECT_THAT(lines, Contains(Line{Mark::kGood, "stick", "> 1  夜  2 MB"}));
}

// Rows have 32 pixels, so that letters have 22.
TEST(JapaneseStatus, IsAsWideAsItsLettersAre) {
  const auto [first, last] = InkOf(Drawn("国国国国国国国国国国"), 235, 238, 242);
  EXPECT_NEAR(last - first, 10 * 22, 6);
}

TEST(JapaneseStatus, HasOtherLettersForOtherWords) {
  const auto box = Drawn("\U000F0000\U000F0000").rgbx;
  EXPECT_NE(Drawn("昼夜").rgbx, box);
  EXPECT_NE(Drawn("昼夜").rgbx, Drawn("夜昼").rgbx);
}

TEST(JapaneseStatus, IsBrokenWhereARowEndsAndShownToItsEnd) {
  const std::string words =
      "設定 (box.toml) "
      "に間違いがあります。間違いのない前の設定で動きます。直して入れ直してください。箱の公演データが壊"
      "れています。控えで上演中です。箱のアップデートを入れてください";
  for (const auto& [width_px, height_px] : {std::pair{640, 480}, {1024, 768}, {1280, 720}}) {
    const auto picture = Drawn(words + "。", width_px, height_px);
    const auto [first, last] = InkOf(picture, 235, 238, 242);
    EXPECT_LT(last, width_px - 4);
    EXPECT_GT(last, width_px * 9 / 10) << "rows are full";
    EXPECT_NE(picture.rgbx, Drawn(words + "」", width_px, height_px).rgbx) << width_px;
  }
}

// How many pixels a row of text takes, where it is drawn; 0 where nothing is to be drawn.
int HeightOfNext(Sheet& sheet, const std::vector<Line>& lines) {
  const auto rows = sheet.DrawNext(lines);
  return rows ? rows->end - rows->first : 0;
}

TEST(JapaneseStatus, ThatIsMoreThanFitsIsSaidInSmallerLettersAndInLargerOnesWhenThereIsRoom) {
  Sheet sheet(image::Lettering::Open().value(), 1280, 720);
  const Line line{Mark::kFault, "fault", "設定に間違いがあります"};
  std::vector<Line> lines(21, line);
  EXPECT_EQ(HeightOfNext(sheet, lines), 32) << "all of them fit";
  lines.assign(27, line);
  EXPECT_EQ(HeightOfNext(sheet, lines), 720) << "the picture is blank";
  int rows = 0;
  while (const int height = HeightOfNext(sheet, lines)) {
    EXPECT_EQ(height, 24);
    ++rows;
  }
  EXPECT_EQ(rows, 29) << "27 and those below them";
  lines.assign(21, line);
  EXPECT_EQ(HeightOfNext(sheet, lines), 720);
  EXPECT_EQ(HeightOfNext(sheet, lines), 27) << "a row is free, as one would not be in the largest letters";
  while (sheet.DrawNext(lines)) continue;
  lines.assign(20, line);
  EXPECT_EQ(HeightOfNext(sheet, lines), 720);
  EXPECT_EQ(HeightOfNext(sheet, lines), 32);
}

}  // namespace
}  // namespace kaori::status
