#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <turbojpeg.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

#include "drivers/decode/planes.h"

namespace kaori::decode {
namespace {

using ports::CameraFrame;
using ports::PixelFormat;
using ::testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

CameraFrame Frame(PixelFormat pixels, int width_px, int height_px, std::uint32_t stride_bytes,
                  const Bytes& bytes) {
  return {.format = {width_px, height_px, pixels}, .stride_bytes = stride_bytes, .bytes = bytes};
}

// One colour all over: R 40, G 80, B 200.
Bytes BlueJpeg(int width_px, int height_px, int subsampling) {
  Bytes rgb;
  for (int n = 0; n < width_px * height_px; ++n)
    for (const std::uint8_t part : Bytes{40, 80, 200}) rgb.push_back(part);
  tjhandle encoder = tjInitCompress();
  unsigned char* jpeg = nullptr;
  unsigned long bytes = 0;
  EXPECT_EQ(
      tjCompress2(encoder, rgb.data(), width_px, 0, height_px, TJPF_RGB, &jpeg, &bytes, subsampling, 95, 0),
      0);
  Bytes copy(jpeg, jpeg + bytes);
  tjFree(jpeg);
  tjDestroy(encoder);
  return copy;
}

TEST(Planes, ReadYuyvInPlaceWithItsStride) {
  const Bytes bytes = {10, 20, 11, 30, 12, 21, 13, 31, 0, 0,  // Row 0 and two bytes of padding.
                       14, 22, 15, 32, 16, 23, 17, 33};       // Row 1; its padding may lack.
  PlaneReader reader;
  const auto planes = reader.Read(Frame(PixelFormat::kYuyv, 4, 2, 10, bytes));
  ASSERT_TRUE(planes) << planes.error().message();
  EXPECT_EQ(planes->y.at(3, 0), 13);
  EXPECT_EQ(planes->y.at(0, 1), 14);
  EXPECT_EQ(planes->cb.at(1, 1), 23);
  EXPECT_EQ(planes->cr.at(0, 1), 32);
  EXPECT_EQ(planes->cb.width_px, 2);
  EXPECT_EQ(planes->cb.height_px, 2);
  EXPECT_EQ(planes->y.bytes.data(), bytes.data());
}

TEST(Planes, ReadNv12InPlace) {
  const Bytes bytes = {1, 2, 3, 4, 5, 6, 7, 8, 20, 30, 21, 31};
  PlaneReader reader;
  const auto planes = reader.Read(Frame(PixelFormat::kNv12, 4, 2, 4, bytes));
  ASSERT_TRUE(planes) << planes.error().message();
  EXPECT_EQ(planes->y.at(3, 1), 8);
  EXPECT_EQ(planes->cb.at(1, 0), 21);
  EXPECT_EQ(planes->cr.at(1, 0), 31);
  EXPECT_EQ(planes->cr.height_px, 1);
}

TEST(Planes, ReadMjpegOfEverySubsampling) {
  PlaneReader reader;
  for (const int subsampling : {TJSAMP_444, TJSAMP_422, TJSAMP_420}) {
    const Bytes jpeg = BlueJpeg(36, 18, subsampling);
    const auto planes = reader.Read(Frame(PixelFormat::kMjpeg, 36, 18, 0, jpeg));
    ASSERT_TRUE(planes) << planes.error().message();
    EXPECT_NEAR(planes->y.at(35, 17), 0.299 * 40 + 0.587 * 80 + 0.114 * 200, 2);
    EXPECT_NEAR(planes->cb.at(planes->cb.width_px - 1, planes->cb.height_px - 1), 128 + 0.564 * (200 - 81.7),
                3);
    EXPECT_LT(planes->cr.at(0, 0), 110);
    EXPECT_TRUE(planes->full_range);
  }
}

TEST(Planes, RefuseFramesWithTooFewBytes) {
  PlaneReader reader;
  const Bytes bytes(100);
  for (const PixelFormat pixels : {PixelFormat::kYuyv, PixelFormat::kNv12}) {
    const auto torn = reader.Read(Frame(pixels, 640, 480, 1280, bytes));
    ASSERT_FALSE(torn);
    EXPECT_EQ(torn.error().cause, std::errc::bad_message);
    EXPECT_THAT(torn.error().attempt, HasSubstr("640x480 frame of 100 bytes: too few bytes"));
  }
  EXPECT_THAT(reader.Read(Frame(PixelFormat::kYuyv, 640, 480, 12, bytes)).error().attempt,
              HasSubstr("stride"));
  EXPECT_FALSE(reader.Read(Frame(PixelFormat::kYuyv, -4, 2, 8, bytes)));
  EXPECT_FALSE(reader.Read(Frame(PixelFormat::kNv12, 4, 3, 4, bytes)));
}

TEST(Planes, RefuseNonsenseThatIsMarkedAsJpeg) {
  PlaneReader reader;
  EXPECT_FALSE(reader.Read(Frame(PixelFormat::kMjpeg, 36, 18, 0, {})));
  EXPECT_FALSE(reader.Read(Frame(PixelFormat::kMjpeg, 36, 18, 0, Bytes(5000, 0xAB))));
  const auto other = reader.Read(Frame(PixelFormat::kMjpeg, 640, 480, 0, BlueJpeg(36, 18, TJSAMP_420)));
  EXPECT_THAT(other.error().attempt, HasSubstr("another size"));
  const auto grey = reader.Read(Frame(PixelFormat::kMjpeg, 36, 18, 0, BlueJpeg(36, 18, TJSAMP_GRAY)));
  EXPECT_THAT(grey.error().attempt, HasSubstr("no Y, Cb and Cr"));
}

TEST(Planes, RefuseEveryTornJpegAndReadTheNextWholeOne) {
  PlaneReader reader;
  const Bytes whole = BlueJpeg(36, 18, TJSAMP_420);
  for (std::size_t length = 0; length + 2 < whole.size(); ++length) {
    const Bytes torn(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
    EXPECT_FALSE(reader.Read(Frame(PixelFormat::kMjpeg, 36, 18, 0, torn))) << length;
  }
  const auto next = reader.Read(Frame(PixelFormat::kMjpeg, 36, 18, 0, whole));
  EXPECT_TRUE(next) << next.error().attempt;
}

TEST(Planes, RefuseAPictureThatIsTooLarge) {
  PlaneReader reader;
  Bytes bomb = BlueJpeg(36, 18, TJSAMP_420);
  const Bytes frame_start = {0xFF, 0xC0};  // Then 2 bytes of length, 1 of precision, height, width.
  const auto at = std::search(bomb.begin(), bomb.end(), frame_start.begin(), frame_start.end());
  ASSERT_NE(at, bomb.end());
  at[5] = at[7] = 0x40;
  at[6] = at[8] = 0;
  const auto refused = reader.Read(Frame(PixelFormat::kMjpeg, 16384, 16384, 0, bomb));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().attempt, HasSubstr("no size that we read"));
  EXPECT_FALSE(reader.Read(Frame(PixelFormat::kMjpeg, 36, 18, 0, Bytes((16u << 20) + 1))));
}

// A camera that shares its memory with us may change the way colour is subsampled after we looked at it.
TEST(Planes, SurviveACameraThatRewritesItsPictureMeanwhile) {
  constexpr int kSide_px = 256;
  Bytes jpeg = BlueJpeg(kSide_px, kSide_px, TJSAMP_420);
  const Bytes frame_start = {0xFF, 0xC0};
  const auto at = std::search(jpeg.begin(), jpeg.end(), frame_start.begin(), frame_start.end());
  ASSERT_NE(at, jpeg.end());
  std::uint8_t& sampling = at[11];  // Of Y.
  ASSERT_EQ(sampling, 0x22);
  std::atomic<bool> done = false;
  std::thread liar([&] {
    while (!done) {
      for (const std::uint8_t value : {std::uint8_t{0x11}, std::uint8_t{0x22}})
        std::atomic_ref(sampling).store(value, std::memory_order_relaxed);
    }
  });
  for (int n = 0; n < 200; ++n) {
    PlaneReader reader;
    const auto planes = reader.Read(Frame(PixelFormat::kMjpeg, kSide_px, kSide_px, 0, jpeg));
    if (!planes) continue;
    EXPECT_LE(planes->cb.width_px, kSide_px);
  }
  done = true;
  liar.join();
}

TEST(Planes, ReadAJpegWithPaddingBehindIt) {
  PlaneReader reader;
  Bytes padded = BlueJpeg(36, 18, TJSAMP_420);
  padded.resize(padded.size() + 500);
  EXPECT_TRUE(reader.Read(Frame(PixelFormat::kMjpeg, 36, 18, 0, padded)));
}

}  // namespace
}  // namespace kaori::decode
