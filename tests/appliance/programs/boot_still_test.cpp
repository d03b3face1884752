// The picture with which the box lights its screens before anything else runs.
#include <gmock/gmock.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "appliance/core/last_face/last_face.h"
#include "appliance/programs/boot/still.h"

namespace kaori::boot {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using Bytes = std::vector<std::uint8_t>;

Bytes File(const std::string& header, std::size_t pixels, std::uint8_t value = 100) {
  Bytes file(header.begin(), header.end());
  file.resize(file.size() + pixels * 3, value);
  return file;
}

// A screen of our own with a guard behind each row.
struct Screen {
  Screen(int width_px, int height_px)
      : pitch_bytes(std::size_t(width_px) * 4 + 8),
        bytes(pitch_bytes * std::size_t(height_px), 7),
        memory{bytes.data(), width_px, height_px, pitch_bytes} {}
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  Bytes Pixel(int x, int y) const {
    const auto at = bytes.begin() + std::ptrdiff_t(std::size_t(y) * pitch_bytes + std::size_t(x) * 4);
    return {at, at + 4};
  }

  std::size_t pitch_bytes;
  Bytes bytes;
  ScreenMemory memory;
};

TEST(Still, IsReadWithItsSize) {
  const Bytes file = File("P6\n3 2\n255\n", 6, 42);
  const auto still = ReadStill(file);
  ASSERT_TRUE(still);
  EXPECT_EQ(still->width_px, 3);
  EXPECT_EQ(still->height_px, 2);
  EXPECT_EQ(still->rgb.size(), 18U);
  EXPECT_THAT(still->rgb, Each(42));
}

TEST(Still, AnythingElseIsNone) {
  for (const char* header :
       {"", "P", "P6", "P6\n", "P6\n3", "P6\n3 2", "P5\n3 2\n255\n", "P6\n0 2\n255\n", "P6\n3 0\n255\n",
        "P6\n3 2\n254\n", "P6\n-3 2\n255\n", "P6\n9000 1\n255\n", "P6\n99999999999999999999 2\n255\n"})
    EXPECT_FALSE(ReadStill(File(header, 6))) << header;
  Bytes cut = File("P6\n3 2\n255\n", 6);
  cut.pop_back();
  EXPECT_FALSE(ReadStill(cut));
}

TEST(Still, OnAScreenOfItsSizeEveryPixelIsItsOwn) {
  Bytes file = File("P6\n2 2\n255\n", 0);
  for (std::uint8_t value = 1; value <= 12; ++value) file.push_back(value);
  Screen screen(2, 2);
  LayStill(*ReadStill(file), screen.memory);
  EXPECT_THAT(screen.Pixel(0, 0), ElementsAre(3, 2, 1, 0)) << "blue comes first";
  EXPECT_THAT(screen.Pixel(1, 0), ElementsAre(6, 5, 4, 0));
  EXPECT_THAT(screen.Pixel(0, 1), ElementsAre(9, 8, 7, 0));
  EXPECT_THAT(screen.Pixel(1, 1), ElementsAre(12, 11, 10, 0));
}

TEST(Still, GrowsSmoothlyAndAWiderScreenGoesOnWithItsEdges) {
  Bytes file = File("P6\n2 1\n255\n", 0);
  for (const std::uint8_t value : Bytes{0, 0, 0, 200, 200, 200}) file.push_back(value);
  Screen screen(12, 4);
  LayStill(*ReadStill(file), screen.memory);
  std::vector<int> row;
  for (int x = 0; x < 12; ++x) row.push_back(screen.Pixel(x, 2)[0]);
  EXPECT_THAT(row, ElementsAre(0, 0, 0, 0, 25, 75, 125, 175, 200, 200, 200, 200));
}

TEST(Still, ANarrowerScreenShowsItsMiddle) {
  Bytes file = File("P6\n4 1\n255\n", 0);
  for (const std::uint8_t value : Bytes{10, 20, 30, 40})
    for (int colour = 0; colour < 3; ++colour) file.push_back(value);
  Screen screen(2, 1);
  LayStill(*ReadStill(file), screen.memory);
  EXPECT_EQ(screen.Pixel(0, 0)[0], 20);
  EXPECT_EQ(screen.Pixel(1, 0)[0], 30);
}

TEST(Still, NothingIsWrittenBeyondAScreensRows) {
  const Bytes file = File("P6\n31 17\n255\n", 31 * 17, 255);
  const auto still = ReadStill(file);
  ASSERT_TRUE(still);
  for (const auto& [width_px, height_px] : {std::pair{1, 1}, {1, 40}, {40, 1}, {640, 3}, {33, 33}}) {
    Screen screen(width_px, height_px);
    LayStill(*still, screen.memory);
    for (int y = 0; y < height_px; ++y) {
      const auto row = screen.bytes.begin() + std::ptrdiff_t(std::size_t(y) * screen.pitch_bytes);
      EXPECT_THAT(Bytes(row + width_px * 4, row + width_px * 4 + 8), Each(7))
          << width_px << " x " << height_px;
      for (int x = 0; x < width_px; ++x) ASSERT_EQ(screen.Pixel(x, y)[1], 255);
    }
  }
}

// A last face of a show whose pack begins with these bytes.
std::vector<std::uint8_t> LastFaceOf(std::string_view pack, std::string_view picture) {
  const auto bytes = [](std::string_view text) {
    return std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  };
  const last_face::Content face{
      .show = Fnv1a(bytes(pack)), .picture = bytes(picture), .state = bytes("state")};
  std::vector<std::uint8_t> file;
  const auto end = last_face::EndOf(face);
  for (const std::span<const std::uint8_t> part :
       {face.picture, face.state, std::span<const std::uint8_t>(end)})
    std::ranges::copy(part, std::back_inserter(file));
  return file;
}

TEST(LastStill, IsThePictureOfAWholeFileOfThisShow) {
  const std::vector<std::uint8_t> pack{'K', 'A'}, other{'K', 'B'};
  const auto file = LastFaceOf("KA", "P6\n1 1\n255\nabc");
  const auto still = ReadLastStill(file, pack);
  ASSERT_TRUE(still);
  EXPECT_EQ(still->width_px, 1);
  EXPECT_EQ(still->rgb[0], 'a');
  EXPECT_FALSE(ReadLastStill(file, other));
  EXPECT_FALSE(ReadLastStill({}, pack));
  EXPECT_FALSE(ReadLastStill(LastFaceOf("KA", "P6\n2 1\n255\nabc"), pack)) << "a picture that is cut short";
}

TEST(LastStill, OfATornFileIsNone) {
  const std::vector<std::uint8_t> pack{'K', 'A'};
  const auto whole = LastFaceOf("KA", "P6\n1 1\n255\nabc");
  for (std::size_t at = 0; at < whole.size(); ++at) {
    auto spoilt = whole;
    spoilt[at] ^= 1;
    EXPECT_FALSE(ReadLastStill(spoilt, pack)) << at;
    EXPECT_FALSE(ReadLastStill(std::span(whole).first(at), pack)) << at;
  }
}

TEST(LastStill, OfAFileThatIsTooLargeIsNone) {
  const std::vector<std::uint8_t> huge(last_face::kLargest_bytes + 1);
  EXPECT_FALSE(ReadLastStill(huge, {}));
}

}  // namespace
}  // namespace kaori::boot
