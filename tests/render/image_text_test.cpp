#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "render/image/break_line.h"
#include "render/image/text.h"

namespace kaori::image {
namespace {

using ::testing::ElementsAre;

struct Box {
  int left = 1 << 20;
  int right = -1;
  int bottom = 1 << 20;
  int top = -1;
  friend bool operator==(const Box&, const Box&) = default;
};

std::uint8_t CoverageAt(const Picture& picture, int x, int y) {
  return picture.rgbx[static_cast<std::size_t>(y * picture.width_px + x) * 4 + 3];
}

// Where there is ink.
Box InkOf(const Picture& picture) {
  Box ink;
  for (int y = 0; y < picture.height_px; ++y)
    for (int x = 0; x < picture.width_px; ++x) {
      if (CoverageAt(picture, x, y) == 0) continue;
      ink = {std::min(ink.left, x), std::max(ink.right, x), std::min(ink.bottom, y), std::max(ink.top, y)};
    }
  return ink;
}

class Text : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(opened_) << opened_.error().message(); }

  Picture Drawn(std::string_view text, int size_px, int x_px = 10, int y_px = 10) {
    Picture picture = Picture::Blank(300, 80);
    lettering().Draw(text, {.size_px = size_px}, x_px, y_px, picture);
    return picture;
  }

  Lettering& lettering() { return *opened_; }

 private:
  Result<Lettering> opened_ = Lettering::Open();
};

TEST_F(Text, InkStaysInTheBoxThatWasMeasured) {
  const std::string text = "Ågjpqy|";
  const Box ink = InkOf(Drawn(text, 30));
  EXPECT_GE(ink.left, 10);
  EXPECT_LE(ink.right, 10 + lettering().width_px(text, 30));
  EXPECT_GE(ink.bottom, 10);
  EXPECT_LT(ink.top, 10 + lettering().height_px(30));
  EXPECT_GT(ink.right - ink.left, lettering().width_px(text, 30) * 8 / 10);
}

TEST_F(Text, StandsUpright) {
  const Picture picture = Drawn("L", 60);  // Its foot is at the bottom, and points to the right.
  const Box ink = InkOf(picture);
  EXPECT_GT(CoverageAt(picture, ink.right - 1, ink.bottom + 2), 0);
  EXPECT_EQ(CoverageAt(picture, ink.right - 1, ink.top - 2), 0);
}

TEST_F(Text, GrowsWithItsSize) {
  EXPECT_EQ(lettering().width_px("", 20), 0);
  EXPECT_NEAR(lettering().width_px("Kaori", 40), 2 * lettering().width_px("Kaori", 20), 4);
  EXPECT_GT(lettering().height_px(40), 40);
}

TEST_F(Text, HasTheColourThatWasAskedFor) {
  Picture picture = Picture::Blank(100, 60);
  lettering().Draw("\u2588", {.size_px = 40, .rgb = {200, 100, 50}}, 10, 5, picture);  // A full block.
  const auto* pixel = picture.rgbx.data() + static_cast<std::size_t>(25 * 100 + 20) * 4;
  EXPECT_EQ(pixel[0], 200);
  EXPECT_EQ(pixel[1], 100);
  EXPECT_EQ(pixel[2], 50);
  EXPECT_EQ(pixel[3], 255);
}

TEST_F(Text, KeepsWhatItDoesNotCover) {
  Picture picture = Picture::Blank(100, 60);
  std::ranges::fill(picture.rgbx, std::uint8_t{77});
  const Picture before = picture;
  lettering().Draw(" ", {.size_px = 40}, 10, 5, picture);
  EXPECT_EQ(picture.rgbx, before.rgbx);
}

TEST_F(Text, IsCutAtThePicturesEdges) {
  for (const auto& [x, y] : {std::pair{-20, 10}, {280, 10}, {10, -15}, {10, 70}, {-1000, 10}, {10, 1000}})
    Drawn("WWWW", 40, x, y);  // The sanitizers watch.
  const Box ink = InkOf(Drawn("WWWW", 40, -20, 10));
  EXPECT_EQ(ink.left, 0);
}

TEST_F(Text, KnowsTheLettersOfEurope) {
  for (const char* letter : {"é", "ß", "Ж", "Ω", "·", "°", "→", "…"})
    EXPECT_NE(Drawn(letter, 40).rgbx, Drawn("\U000F0000", 40).rgbx) << letter;
}

TEST_F(Text, DrawsABoxForALetterThatTheFontLacks) {
  const Picture box = Drawn("\U000F0000", 40);
  EXPECT_GT(InkOf(box).right, InkOf(box).left);
  EXPECT_EQ(box.rgbx, Drawn("\U000F0001", 40).rgbx);
}

TEST_F(Text, TreatsControlCharactersAsSpaces) {
  EXPECT_EQ(Drawn("a\nb\tc", 20).rgbx, Drawn("a b c", 20).rgbx);
}

TEST_F(Text, SaysThatBytesAreNoLetters) {
  EXPECT_EQ(Drawn("a\xFFz", 20).rgbx, Drawn("a\uFFFDz", 20).rgbx);
}

TEST_F(Text, ShortensWhatDoesNotFit) {
  const std::string name = "embarrassed behind the fän";
  const int whole = lettering().width_px(name, 20);
  EXPECT_EQ(Shorten(lettering(), name, 20, whole), name);
  for (int width = 0; width < whole; ++width) {
    const std::string part = Shorten(lettering(), name, 20, width);
    EXPECT_LE(lettering().width_px(part, 20), width);
    EXPECT_TRUE(part.empty() || part.ends_with("\u2026")) << part;
  }
  EXPECT_TRUE(Shorten(lettering(), name, 20, whole - 1).starts_with("embarrassed"));
}

// The pieces of a line, of `most` letters each.
std::vector<std::string> Broken(std::string_view line, std::size_t most) {
  std::vector<std::string> pieces;
  BreakLine(
      line, [most](std::string_view text) { return text.size() <= most; }, pieces);
  return pieces;
}

TEST(LinesOfText, AreBrokenAtWideGapsFirst) {
  EXPECT_THAT(Broken("M mirror   S smooth   Z undo", 20), ElementsAre("M mirror   S smooth", "Z undo"));
  EXPECT_THAT(Broken("M mirror   S smooth   Z undo", 12), ElementsAre("M mirror", "S smooth", "Z undo"));
}

TEST(LinesOfText, AreBrokenBetweenWordsWhereNoWideGapHelps) {
  EXPECT_THAT(Broken("a name that is long   b", 12), ElementsAre("a name that", "is long   b"));
}

TEST(LinesOfText, LeaveAWordWhole) {
  EXPECT_THAT(Broken("Donaudampfschiff kapitaen", 5), ElementsAre("Donaudampfschiff", "kapitaen"));
}

TEST(LinesOfText, KeepEmptyLinesAndLoseOuterSpaces) {
  EXPECT_THAT(Broken("", 5), ElementsAre(""));
  EXPECT_THAT(Broken("   ", 5), ElementsAre(""));
  EXPECT_THAT(Broken("  a  ", 5), ElementsAre("a"));
}

}  // namespace
}  // namespace kaori::image
