// What a person gets to look at when a picture is not as it was accepted.
#include "tests/golden/compare.h"

#include <gmock/gmock.h>

namespace kaori::golden {
namespace {

namespace fs = std::filesystem;

using ::testing::HasSubstr;

const fs::path kAcceptedFolder = KAORI_GOLDEN_ACCEPTED;
const fs::path kDifferingFolder = KAORI_GOLDEN_DIFFERING;
const std::string kPictureName = "play-00.8";

// An accepted picture, and what may be drawn in its place.
class Compared : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto accepted = image::ReadPng(kAcceptedFolder / (kPictureName + ".png"));
    ASSERT_TRUE(accepted) << accepted.error().message();
    accepted_ = *accepted;
  }

  image::Picture accepted_;
};

// A channel of the lowest left pixel of a column.
std::uint8_t At(const image::Picture& picture, int x_px, std::size_t channel) {
  return picture.rgbx[4 * static_cast<std::size_t>(x_px) + channel];
}

TEST_F(Compared, SaysNothingOfTheAcceptedPictureItself) {
  EXPECT_EQ(Compare(accepted_, kPictureName), "");
}

TEST_F(Compared, LaysAcceptedDrawnAndTheirDifferenceSideBySide) {
  image::Picture drawn = accepted_;
  const int width_px = drawn.width_px;
  for (std::size_t i = 0; i < 4 * static_cast<std::size_t>(width_px); i += 4)
    drawn.rgbx[i] =
        static_cast<std::uint8_t>(drawn.rgbx[i] ^ 0x20);  // The lowest row's red is 32 levels off.

  const std::string said = Compare(drawn, kPictureName, {.mean = 0.01});
  EXPECT_THAT(said, HasSubstr(kPictureName));
  EXPECT_THAT(said, HasSubstr("play-00.8-compared.png"));

  const auto beside = image::ReadPng(kDifferingFolder / (kPictureName + "-compared.png"));
  ASSERT_TRUE(beside) << beside.error().message();
  ASSERT_EQ(beside->width_px, 3 * width_px);
  ASSERT_EQ(beside->height_px, drawn.height_px);
  EXPECT_EQ(At(*beside, 0, 0), At(accepted_, 0, 0));
  EXPECT_EQ(At(*beside, width_px, 0), At(drawn, 0, 0));
  EXPECT_EQ(At(*beside, 2 * width_px, 0), 4 * 32) << "four times as bright as it is off";
  EXPECT_EQ(At(*beside, 2 * width_px, 1), 0) << "green is the same";
  const auto kept = image::ReadPng(kDifferingFolder / (kPictureName + ".png"));
  ASSERT_TRUE(kept) << kept.error().message();
  EXPECT_EQ(kept->rgbx[0], drawn.rgbx[0]);
  for (const char* end : {".png", "-compared.png"}) fs::remove(kDifferingFolder / (kPictureName + end));
}

}  // namespace
}  // namespace kaori::golden
