// The lip camera's picture on its way to the operators' monitor.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "appliance/core/board/lip_picture.h"
#include "tests/appliance/core/board_file.h"

namespace kaori::board {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in milliseconds.

class LipsOnTheWay : public ::testing::Test {
 protected:
  static LipPicture Picture(std::uint8_t shade) {
    return {.width_px = 3, .height_px = 2, .at = Time{} + 7s, .pixels = std::vector<std::uint8_t>(24, shade)};
  }
  // False where the writer was not asked for one.
  bool Write(std::uint8_t shade) {
    now_ += 100ms;
    if (!writer_.IsDue(now_)) return false;
    writer_.Write(Picture(shade));
    return true;
  }

  BoardFile place_;
  std::string path_ = LipPicturePath(place_.path());
  Time now_ = Time{} + 100s;
  LipPictureWriter writer_{path_};
};

TEST_F(LipsOnTheWay, IsReadAsItWasWritten) {
  auto reader = LipPictureReader::Make(path_).value();
  EXPECT_FALSE(reader.Read());
  ASSERT_TRUE(Write(5));
  const auto read = reader.Read();
  ASSERT_TRUE(read);
  EXPECT_EQ(read->width_px, 3);
  EXPECT_EQ(read->height_px, 2);
  EXPECT_EQ(read->at, Time{} + 7s);
  EXPECT_EQ(read->pixels, Picture(5).pixels);
}

TEST_F(LipsOnTheWay, NoneIsDrawnUntilSomebodyMakesTheFileAndAfterItIsGone) {
  EXPECT_FALSE(Write(1));
  {
    const auto reader = LipPictureReader::Make(path_).value();
    EXPECT_TRUE(Write(1));
  }
  EXPECT_FALSE(std::filesystem::exists(path_));
  EXPECT_FALSE(Write(1));
}

TEST_F(LipsOnTheWay, ANewReaderOfAFileThatWasLeftThereSeesOnlyNewPictures) {
  { std::filesystem::copy_file("/proc/self/cmdline", path_); }
  auto reader = LipPictureReader::Make(path_).value();
  EXPECT_FALSE(reader.Read());
  ASSERT_TRUE(Write(9));
  EXPECT_TRUE(reader.Read());
}

TEST_F(LipsOnTheWay, TenASecondAreEnough) {
  const auto reader = LipPictureReader::Make(path_).value();
  int due = 0;
  for (int i = 0; i < 60; ++i) due += writer_.IsDue(now_ += 16'666'667ns) ? 1 : 0;
  EXPECT_GE(due, 8);
  EXPECT_LE(due, 10);
}

TEST_F(LipsOnTheWay, APictureThatIsBeingWrittenIsNone) {
  auto bytes = LipPictureBytes(Picture(5), 41);
  EXPECT_TRUE(ParseLipPicture(bytes));
  bytes.back() ^= 1U;
  EXPECT_FALSE(ParseLipPicture(bytes));
}

TEST_F(LipsOnTheWay, BytesThatAreNoPictureAreNone) {
  const auto whole = LipPictureBytes(Picture(5), 1);
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_FALSE(ParseLipPicture(std::span(whole).first(length))) << length;
  for (const std::size_t at : {0U, 8U, 11U, 12U, 15U}) {
    auto wrong = whole;
    wrong[at] ^= 0xFFU;
    EXPECT_FALSE(ParseLipPicture(wrong)) << at;
  }
}

TEST_F(LipsOnTheWay, AFileThatIsCutShortHarmsNeitherEnd) {
  auto reader = LipPictureReader::Make(path_).value();
  ASSERT_TRUE(Write(5));
  ASSERT_EQ(::truncate(path_.c_str(), 10), 0);
  EXPECT_FALSE(reader.Read());
  ASSERT_TRUE(Write(6));
  EXPECT_TRUE(reader.Read());
}

TEST_F(LipsOnTheWay, ALinkIsNotFollowed) {
  std::filesystem::create_symlink(place_.folder() / "elsewhere", path_);
  EXPECT_FALSE(LipPictureReader::Make(path_));
  EXPECT_FALSE(Write(1));
}

}  // namespace
}  // namespace kaori::board
