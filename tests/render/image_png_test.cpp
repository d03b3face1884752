// Pictures as files: what is read, and what is refused before memory is asked for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string>

#include "render/image/png.h"

namespace kaori::image {
namespace {

class Png : public ::testing::Test {
 protected:
  ~Png() override { std::filesystem::remove(file_); }
  std::filesystem::path file_ = ::testing::TempDir() + "png-" + std::to_string(::getpid()) + ".png";
};

TEST_F(Png, IsReadAsItWasWritten) {
  Picture picture = Picture::Blank(3, 2);
  for (std::size_t i = 0; i < picture.rgbx.size(); ++i)
    picture.rgbx[i] = i % 4 == 3 ? 255 : static_cast<std::uint8_t>(10 * i);
  ASSERT_TRUE(WritePng(file_, picture));
  const auto read = ReadPng(file_);
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->width_px, 3);
  EXPECT_EQ(read->height_px, 2);
  EXPECT_EQ(read->rgbx, picture.rgbx);
}

// The signature, a header that promises the pixels, and no data (PNG, second edition, sections 5.2 and 11.2.2).
TEST_F(Png, OfManyPixelsIsRefusedHoweverShortTheFileIs) {
  constexpr std::array<std::uint8_t, 45> kPromises{
      0x89, 'P',  'N',  'G',  0x0D, 0x0A, 0x1A, 0x0A, 0,    0,   0,   13,   'I',  'H',  'D',
      'R',  0,    0,    0x4E, 0x20, 0,    0,    0x03, 0xE8, 8,   2,   0,    0,    0,    0xB4,
      0x75, 0x59, 0x0E, 0,    0,    0,    0,    'I',  'D',  'A', 'T', 0x35, 0xAF, 0x06, 0x1E};
  std::ofstream(file_, std::ios::binary)
      .write(reinterpret_cast<const char*>(kPromises.data()), static_cast<std::streamsize>(kPromises.size()));
  const auto read = ReadPng(file_);
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message(), ::testing::HasSubstr("a picture of 20000 x 1000 pixels"));
}

}  // namespace
}  // namespace kaori::image
