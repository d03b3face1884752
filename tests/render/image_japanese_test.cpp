// Japanese in pictures: which letters there are, how they stand beside Latin ones, and where lines end.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iconv.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <vector>

#include "drivers/base/utf8.h"
#include "render/image/break_line.h"
#include "render/image/text.h"

namespace kaori::image {
namespace {

using ::testing::ElementsAre;

// The letter at a place of JIS X 0208, in UTF-8; empty where there is none.
std::string LetterAt(int row, int cell) {
  const iconv_t to_utf8 = ::iconv_open("UTF-8", "EUC-JP");
  std::array<char, 2> from{static_cast<char>(0xA0 + row), static_cast<char>(0xA0 + cell)};
  std::array<char, 8> into{};
  char *in = from.data(), *out = into.data();
  std::size_t in_left = from.size(), out_left = into.size();
  const bool is_letter = ::iconv(to_utf8, &in, &in_left, &out, &out_left) != static_cast<std::size_t>(-1);
  ::iconv_close(to_utf8);
  return is_letter ? std::string(into.data(), into.size() - out_left) : std::string();
}

class JapaneseText : public ::testing::Test {
 protected:
  std::vector<std::uint8_t> Drawn(std::string_view text, int size_px = 20) {
    Picture picture = Picture::Blank(60, 40);
    lettering_.Draw(text, {.size_px = size_px}, 5, 5, picture);
    return std::move(picture.rgbx);
  }
  // Whether the fonts have no such letter: it is drawn as their box.
  bool IsBox(std::string_view letter) { return Drawn(letter) == box_; }
  // The rows with ink, the lowest one first; from the line's lower edge.
  std::pair<int, int> InkOf(std::string_view text, int size_px) {
    Picture picture = Picture::Blank(400, 120);
    lettering_.Draw(text, {.size_px = size_px}, 0, 20, picture);
    int lowest = picture.height_px, highest = -1;
    for (int i = 0; i < picture.width_px * picture.height_px; ++i) {
      if (picture.rgbx[static_cast<std::size_t>(i) * 4 + 3] == 0) continue;
      lowest = std::min(lowest, i / picture.width_px);
      highest = i / picture.width_px;
    }
    return {lowest - 20, highest - 20};
  }

  Lettering lettering_ = Lettering::Open().value();
  const std::vector<std::uint8_t> box_ = Drawn("\U000F0000");
};

TEST_F(JapaneseText, LettersAreDrawnAndDiffer) {
  std::set<std::vector<std::uint8_t>> drawn{box_};
  for (const char* letter :
       {"あ", "ア", "ー", "。", "、", "「", "香", "織", "劇", "鍵", "ｱ", "Ａ", "A", "é", "Ω"})
    EXPECT_TRUE(drawn.insert(Drawn(letter)).second) << letter;
  EXPECT_NE(Drawn("\u3000"), box_) << "a wide space";
}

// Rows 16 to 47 are level 1: 2965 kanji. Before them stand signs and kana.
TEST_F(JapaneseText, HasAllSignsAndKanaAndTheKanjiOfLevelOne) {
  int kanji = 0;
  for (int row = 1; row < 48; ++row)
    for (int cell = 1; cell < 95; ++cell) {
      const std::string letter = LetterAt(row, cell);
      if (letter.empty()) continue;
      EXPECT_FALSE(IsBox(letter)) << letter;
      kanji += row >= 16 ? 1 : 0;
    }
  EXPECT_EQ(kanji, 2965);
}

// Of level 2: what is taught in school, stands in names, or is played in theatres.
TEST_F(JapaneseText, HasKanjiOfNamesAndOfTheTheatre) {
  std::string_view letters = "髙﨑濵彌凜堯槇遙瑶薔薇傀儡囃鬘簪蝙蝠慟哭鬱彙憬惧箋翔飜";
  while (!letters.empty()) {
    const std::size_t bytes = utf8::FirstLetter(letters).bytes;
    EXPECT_FALSE(IsBox(letters.substr(0, bytes))) << letters.substr(0, bytes);
    letters.remove_prefix(bytes);
  }
}

TEST_F(JapaneseText, IsAsWideAsItIsHighAndStandsInTheLinesBox) {
  for (const int size : {12, 17, 40}) {
    EXPECT_EQ(lettering_.width_px("香織の箱", size), 4 * size);
    EXPECT_EQ(lettering_.width_px("a香b", size),
              lettering_.width_px("a", size) + size + lettering_.width_px("b", size))
        << "no kerning between the two fonts";
    const auto [lowest, highest] = InkOf("鬱鷲瓢（ぽ」、", size);
    EXPECT_GE(lowest, 0) << size;
    EXPECT_LT(highest, lettering_.height_px(size)) << size;
  }
}

// A kanji reaches a little below the baseline and above capitals, by about as much.
TEST_F(JapaneseText, StandsOnTheLineOfTheLatinLetters) {
  const auto [base, top] = InkOf("H", 80);
  const auto [lowest, highest] = InkOf("国", 80);
  EXPECT_NEAR(base - lowest, highest - top, 6);
  EXPECT_GT(base - lowest, 0);
}

TEST_F(JapaneseText, IsShortenedBetweenLetters) {
  const std::string name = "香織の夜 kaori";
  const int whole = lettering_.width_px(name, 20);
  for (int width = 0; width < whole; ++width) {
    const std::string part = Shorten(lettering_, name, 20, width);
    EXPECT_LE(lettering_.width_px(part, 20), width);
    for (std::string_view rest = part; !rest.empty(); rest.remove_prefix(utf8::FirstLetter(rest).bytes))
      EXPECT_NE(utf8::FirstLetter(rest).code, U'\uFFFD') << part;
  }
  EXPECT_EQ(Shorten(lettering_, name, 20, 60), "香織…");
}

TEST(GuessedWidth, IsThatOfJapaneseLettersAndAMeanOfOthers) {
  EXPECT_EQ(GuessWidth_px("香織", 20, 54), 40);
  EXPECT_EQ(GuessWidth_px("abé", 20, 50), 30);
  EXPECT_EQ(GuessWidth_px("", 20, 50), 0);
}

// The pieces of a line, of `most` columns each.
std::vector<std::string> PartedBy(std::string_view line, std::size_t most) {
  std::vector<std::string> pieces;
  BreakLine(
      line, [most](std::string_view text) { return utf8::Columns(text) <= most; }, pieces);
  return pieces;
}

TEST(JapaneseLines, AreBrokenBetweenAnyTwoLetters) {
  EXPECT_THAT(PartedBy("公演の後再起動", 6), ElementsAre("公演の", "後再起", "動"));
  EXPECT_THAT(PartedBy("公演の後再起動", 7), ElementsAre("公演の", "後再起", "動"));
  EXPECT_THAT(PartedBy("公演", 1), ElementsAre("公", "演")) << "one letter at least";
}

TEST(JapaneseLines, LeaveLatinWordsWholeAndBreakAtSpacesToo) {
  EXPECT_THAT(PartedBy("終わるkaoriです", 10), ElementsAre("終わる", "kaoriです"));
  EXPECT_THAT(PartedBy("guest: 鍵がありません", 14), ElementsAre("guest: 鍵があ", "りません"));
  EXPECT_THAT(PartedBy("一 二三", 4), ElementsAre("一", "二三"));
  EXPECT_THAT(PartedBy("Donaudampfschiff香", 5), ElementsAre("Donaudampfschiff", "香"));
}

TEST(JapaneseLines, BeginWithNothingThatClosesAndEndWithNothingThatOpens) {
  EXPECT_THAT(PartedBy("上演中です。次", 10), ElementsAre("上演中で", "す。次"));
  EXPECT_THAT(PartedBy("公開「鍵」と", 6), ElementsAre("公開", "「鍵」", "と"));
  EXPECT_THAT(PartedBy("ショーのデータ", 8), ElementsAre("ショーの", "データ"));
  EXPECT_THAT(PartedBy("のデータ", 6), ElementsAre("のデー", "タ"));
  EXPECT_THAT(PartedBy("設定 (box.toml) に", 12), ElementsAre("設定", "(box.toml)", "に"));
}

TEST(JapaneseLines, KeepWideGapsAsPlacesToBreakFirst) {
  EXPECT_THAT(PartedBy("M 鏡像   S 滑らか   Z 戻す", 20), ElementsAre("M 鏡像   S 滑らか", "Z 戻す"));
}

}  // namespace
}  // namespace kaori::image
