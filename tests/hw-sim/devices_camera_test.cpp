// The simulated lip camera: a mouth that can be measured, in every format that cameras send.
#include <gtest/gtest.h>
#include <turbojpeg.h>

#include <algorithm>
#include <cmath>

#include "hw-sim/devices/lip_camera.h"

namespace kaori::sim {
namespace {

// What a plain chroma key sees of the paint.
struct Measured {
  int pixels = 0;
  double height = 0;  // In widths of the mouth at rest.
  double width = 0;
};

// Blue is above 150 of Cb, where skin lies at 107: half-way.
Measured MeasureYuyv(std::span<const std::uint8_t> yuyv, int width_px, int height_px) {
  int left = width_px, right = -1, top = height_px, bottom = -1, count = 0;
  for (int y = 0; y < height_px; ++y) {
    for (int x = 0; x < width_px; x += 2) {
      const std::size_t at =
          (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) + static_cast<std::size_t>(x)) *
          2;
      if (yuyv[at + 1] < 150) continue;
      left = std::min(left, x), right = std::max(right, x + 1);
      top = std::min(top, y), bottom = std::max(bottom, y);
      count += 2;
    }
  }
  const double rest_px = kRestMouthOfPicture * width_px;
  return count == 0 ? Measured{}
                    : Measured{count, (bottom - top + 1) / rest_px, (right - left + 1) / rest_px};
}

class LipCameraTest : public ::testing::Test {
 protected:
  std::vector<std::uint8_t> Shot(std::uint32_t sequence = 1) {
    std::vector<std::uint8_t> bytes(camera.frame_bytes());
    bytes.resize(camera.Shoot(sequence, bytes));
    return bytes;
  }

  ManualClock clock;
  DeviceContext context{clock, {}};
  LipCamera camera{{640, 480, ports::PixelFormat::kYuyv}, context};
};

TEST_F(LipCameraTest, ShowsAMouthOfTheSizeThatWasSet) {
  for (const Mouth& mouth : {Mouth{0.25, 1}, Mouth{0.6, 1.1}, Mouth{0.8, 0.7}, Mouth{0.3, 1.25}}) {
    camera.SetMouth(mouth.height, mouth.width);
    const Measured measured = MeasureYuyv(Shot(), 640, 480);
    EXPECT_NEAR(measured.height, mouth.height, 0.03);
    EXPECT_NEAR(measured.width, mouth.width, 0.03);
  }
}

TEST_F(LipCameraTest, OpensAMouthThatIsNotPainted) {
  camera.SetMouth(0.8, 1);
  const auto frame = Shot();
  const std::size_t middle = (std::size_t{250} * 640 + 320) * 2;  // Between the lips.
  EXPECT_LT(frame[middle], 60);
  EXPECT_LT(frame[middle + 1], 150);
}

TEST_F(LipCameraTest, IsDeterministicAndNeverStill) {
  EXPECT_EQ(Shot(7), Shot(7));
  EXPECT_NE(Shot(7), Shot(8));
}

TEST_F(LipCameraTest, SeesNothingThroughACoveredLens) {
  camera.CoverLens(true);
  const auto frame = Shot();
  EXPECT_EQ(MeasureYuyv(frame, 640, 480).pixels, 0);
  EXPECT_LT(frame[0], 24);
  camera.CoverLens(false);
  EXPECT_GT(MeasureYuyv(Shot(), 640, 480).pixels, 1000);
}

TEST_F(LipCameraTest, ShowsTheSameMouthInNv12) {
  camera.SetMouth(0.6, 1.1);
  camera.SetFormat({640, 480, ports::PixelFormat::kNv12});
  const auto frame = Shot();
  ASSERT_EQ(frame.size(), 640u * 480 * 3 / 2);
  std::vector<std::uint8_t> yuyv(640 * 480 * 2);
  for (std::size_t y = 0; y < 480; ++y)
    for (std::size_t x = 0; x < 640; x += 2)
      yuyv[(y * 640 + x) * 2 + 1] = frame[640 * 480 + (y / 2) * 640 + x];
  EXPECT_NEAR(MeasureYuyv(yuyv, 640, 480).height, 0.6, 0.04);
}

TEST_F(LipCameraTest, SendsJpegThatADecoderReads) {
  camera.SetFormat({320, 240, ports::PixelFormat::kMjpeg});
  const auto frame = Shot();
  ASSERT_GT(frame.size(), 100u);
  const tjhandle decoder = ::tjInitDecompress();
  std::vector<std::uint8_t> rgb(320 * 240 * 3);
  EXPECT_EQ(::tjDecompress2(decoder, frame.data(), frame.size(), rgb.data(), 320, 0, 240, TJPF_RGB, 0), 0);
  ::tjDestroy(decoder);
  const auto skin = std::span(rgb).subspan((std::size_t{120} * 320 + 80) * 3, 3);
  EXPECT_GT(skin[0], skin[2] + 40);  // Skin is red,
  const auto paint = std::span(rgb).subspan((std::size_t{125} * 320 + 160) * 3, 3);
  EXPECT_GT(paint[2], paint[0] + 40);  // and the lips are blue.
}

TEST_F(LipCameraTest, RefusesSizesThatItCannotTake) {
  for (const auto& [width, height] : {std::pair{0, 480}, {641, 480}, {640, 481}, {4000, 480}, {-2, 2}}) {
    camera.SetFormat({width, height, ports::PixelFormat::kYuyv});
    EXPECT_EQ(camera.format().width_px, 640);
    EXPECT_EQ(camera.format().height_px, 480);
  }
}

TEST_F(LipCameraTest, DrawsAMouthLargerThanThePictureWithoutHarm) {
  camera.SetFormat({64, 16, ports::PixelFormat::kYuyv});
  camera.SetMouth(2, 2);
  EXPECT_EQ(Shot().size(), 64u * 16 * 2);
}

}  // namespace
}  // namespace kaori::sim
