// The rig's camera through its real socket and shared memory.
#include "drivers/camera/local_camera.h"
#include "tests/hw-sim/link_fixture.h"

namespace kaori::sim {
namespace {

using namespace std::chrono_literals;

constexpr Duration kPeriod = 33'333'333ns;

class LinkCamera : public LinkFixture {
 protected:
  void SetUp() override {
    LinkFixture::SetUp();
    start = clock.now();
    auto opened = camera::LocalCamera::Open(folder.path());
    ASSERT_TRUE(opened) << opened.error().message();
    camera = std::move(*opened);
  }

  std::errc Cause() { return camera->Next().error().cause; }

  Time start;
  std::unique_ptr<ports::Camera> camera;
};

TEST_F(LinkCamera, HasNoFrameBeforeTheCameraAnswers) {
  EXPECT_EQ(Cause(), std::errc::resource_unavailable_try_again);
}

TEST_F(LinkCamera, AFrameComesEachPeriodWithItsExactTime) {
  rig->Pump();
  for (std::uint32_t n = 0; n < 5; ++n) {
    const auto frame = camera->Next();
    ASSERT_TRUE(frame) << frame.error().message();
    EXPECT_EQ(frame->at, start + n * kPeriod);
    EXPECT_EQ(frame->sequence, n);
    EXPECT_EQ(frame->format, (ports::CameraFormat{640, 480, ports::PixelFormat::kYuyv}));
    EXPECT_EQ(frame->bytes.size(), 640u * 480 * 2);
    EXPECT_EQ(frame->stride_bytes, 1280u);
    EXPECT_EQ(Cause(), std::errc::resource_unavailable_try_again);
    Step(kPeriod);
  }
}

TEST_F(LinkCamera, GivesTheNewestFrameOnly) {
  for (int n = 0; n < 3; ++n) Step(kPeriod);
  const auto frame = camera->Next();
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->sequence, 3u);
}

TEST_F(LinkCamera, AReaderThatSleepsLosesFramesAndNotTheCamera) {
  for (int n = 0; n < 50; ++n) Step(kPeriod);  // All slots are out: the camera drops frames.
  ASSERT_TRUE(camera->Next());
  for (int n = 0; n < 3; ++n) Step(kPeriod);
  const auto frame = camera->Next();
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->sequence, 53u);
}

TEST_F(LinkCamera, ABorrowedFrameIsNotDrawnOver) {
  rig->Pump();
  const auto frame = camera->Next();
  ASSERT_TRUE(frame);
  const std::vector<std::uint8_t> copy(frame->bytes.begin(), frame->bytes.end());
  rig->camera().SetMouth(0.9, 1.2);
  for (int n = 0; n < 20; ++n) Step(kPeriod);
  EXPECT_TRUE(std::ranges::equal(copy, frame->bytes));
}

TEST_F(LinkCamera, AStalledCameraSendsNothingAndGoesOnLater) {
  rig->Pump();
  ASSERT_TRUE(camera->Next());
  rig->camera().Stall(true);
  for (int n = 0; n < 10; ++n) Step(kPeriod);
  EXPECT_EQ(Cause(), std::errc::resource_unavailable_try_again);
  rig->camera().Stall(false);
  Step(kPeriod);
  EXPECT_EQ(camera->Next()->sequence, 11u);
}

TEST_F(LinkCamera, AChangedFormatComesWithTheFrame) {
  rig->Pump();
  for (const auto& format : {ports::CameraFormat{320, 240, ports::PixelFormat::kNv12},
                             ports::CameraFormat{1920, 1080, ports::PixelFormat::kYuyv},
                             ports::CameraFormat{640, 480, ports::PixelFormat::kMjpeg}}) {
    rig->camera().SetFormat(format);
    Step(kPeriod);
    const auto frame = camera->Next();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->format, format);
  }
}

TEST_F(LinkCamera, NonsenseIsDroppedAndTheStreamGoesOn) {
  rig->Pump();
  ASSERT_TRUE(camera->Next());
  rig->camera().SendGarbage();
  Step(kPeriod);
  EXPECT_EQ(Cause(), std::errc::bad_message);
  Step(kPeriod);
  EXPECT_TRUE(camera->Next());
}

TEST_F(LinkCamera, AnUnpluggedCameraIsGoneAndComesBack) {
  rig->Pump();
  ASSERT_TRUE(camera->Next());
  ASSERT_TRUE(rig->Unplug("camera"));
  EXPECT_EQ(Cause(), std::errc::no_such_device);
  EXPECT_EQ(camera::LocalCamera::Open(folder.path()).error().cause, std::errc::no_such_device);
  ASSERT_TRUE(rig->Plug("camera"));
  camera = *camera::LocalCamera::Open(folder.path());
  Step(kPeriod);
  EXPECT_TRUE(camera->Next());
}

TEST_F(LinkCamera, OpensAThousandTimesWithoutALeak) {
  camera.reset();
  rig->Pump();
  const int before = OpenDescriptors();
  for (int n = 0; n < 1000; ++n) {
    camera = *camera::LocalCamera::Open(folder.path());
    Step(kPeriod);
    if (n % 3 != 0) {
      ASSERT_TRUE(camera->Next());
    }
    camera.reset();
    rig->Pump();
  }
  EXPECT_LE(OpenDescriptors(), before + 1);  // The last frames' memory stays with the rig.
}

}  // namespace
}  // namespace kaori::sim
