#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drivers/camera/v4l2_camera.h"
#include "tests/drivers/camera_v4l2_fake.h"

namespace kaori::camera {
namespace {

using ports::PixelFormat;
using ::testing::HasSubstr;

class V4l2CameraTest : public ::testing::Test {
 protected:
  std::unique_ptr<V4l2Camera> Opened() {
    auto camera = V4l2Camera::Open("/dev/video0", {}, clock_, kernel_);
    EXPECT_TRUE(camera) << camera.error().message();
    return camera ? std::move(*camera) : nullptr;
  }
  std::errc Refusal() {
    const auto camera = V4l2Camera::Open("/dev/video0", {}, clock_, kernel_);
    return camera ? std::errc{} : camera.error().cause;
  }

  ManualClock clock_;
  tests::FakeV4l2 kernel_;
};

TEST_F(V4l2CameraTest, GivesTheNewestOfThoseThatWaitAndQueuesTheOthersAgain) {
  const auto camera = Opened();
  for (const std::uint8_t grey : {std::uint8_t{1}, std::uint8_t{2}, std::uint8_t{3}})
    kernel_.Expose(grey, clock_.now());
  const auto frame = camera->Next();
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->bytes[0], 3);
  EXPECT_EQ(frame->sequence, 2u);
  EXPECT_EQ(kernel_.free_buffers(), 3u);
  EXPECT_EQ(camera->Next().error().cause, std::errc::resource_unavailable_try_again);
  EXPECT_EQ(kernel_.free_buffers(), 4u);
}

TEST_F(V4l2CameraTest, ChoosesTheFastestFormatAndAtEqualRatesTheCheapest) {
  kernel_.offers = {{V4L2_PIX_FMT_MJPEG, 60}, {V4L2_PIX_FMT_YUYV, 30}};
  EXPECT_EQ(Opened()->format().format().pixels, PixelFormat::kMjpeg);
  kernel_.offers = {{V4L2_PIX_FMT_MJPEG, 30}, {V4L2_PIX_FMT_YUYV, 30}};
  EXPECT_EQ(Opened()->format().format().pixels, PixelFormat::kYuyv);
  kernel_.offers = {{V4L2_PIX_FMT_MJPEG, 30}, {V4L2_PIX_FMT_YUYV, 30}, {V4L2_PIX_FMT_NV12, 30}};
  EXPECT_EQ(Opened()->format().format().pixels, PixelFormat::kNv12);
  EXPECT_EQ(kernel_.chosen().fourcc, V4L2_PIX_FMT_NV12);
}

TEST_F(V4l2CameraTest, UsesTheSizeThatTheCameraGives) {
  kernel_.gives = {V4L2_PIX_FMT_YUYV, 30, 320, 240};
  EXPECT_EQ(Opened()->format().format(), (ports::CameraFormat{320, 240, PixelFormat::kYuyv}));
}

TEST_F(V4l2CameraTest, RefusesWhatIsNoCamera) {
  kernel_.offers = {{V4L2_PIX_FMT_H264, 30}};
  EXPECT_EQ(Refusal(), std::errc::not_supported);
  kernel_.capabilities = V4L2_CAP_VIDEO_OUTPUT;
  EXPECT_EQ(Refusal(), std::errc::not_supported);
  for (const auto& [error, cause] :
       std::vector<std::pair<int, std::errc>>{{ENOENT, std::errc::no_such_device},
                                              {EACCES, std::errc::permission_denied},
                                              {EBUSY, std::errc::device_or_resource_busy}}) {
    kernel_.open_error = error;
    EXPECT_EQ(Refusal(), cause);
  }
}

TEST_F(V4l2CameraTest, SaysThatAnotherProgramHasTheCamera) {
  kernel_.failing_error = EBUSY;
  for (const unsigned long request : {VIDIOC_S_FMT, VIDIOC_REQBUFS, VIDIOC_STREAMON}) {
    kernel_.failing_request = request;
    EXPECT_EQ(Refusal(), std::errc::device_or_resource_busy);
    EXPECT_EQ(kernel_.mapped(), 0u);
  }
}

TEST_F(V4l2CameraTest, DropsTornFramesAndGoesOn) {
  const auto camera = Opened();
  const auto torn = [&](std::uint32_t bytes, std::uint32_t flags) {
    kernel_.Expose(9, clock_.now(), bytes, flags);
    return camera->Next().error().cause;
  };
  EXPECT_EQ(torn(0, 0), std::errc::bad_message);
  EXPECT_EQ(torn(1000, 0), std::errc::bad_message);
  EXPECT_EQ(torn(tests::FakeV4l2::kBufferBytes + 1, 0), std::errc::bad_message);
  EXPECT_EQ(torn(tests::FakeV4l2::kBufferBytes, V4L2_BUF_FLAG_ERROR), std::errc::bad_message);
  EXPECT_EQ(kernel_.free_buffers(), 4u);
  kernel_.Expose(9, clock_.now());
  EXPECT_TRUE(camera->Next());
}

TEST_F(V4l2CameraTest, ShowsTheWholeFrameBesideATornOne) {
  const auto camera = Opened();
  kernel_.Expose(5, clock_.now());
  kernel_.Expose(6, clock_.now(), 0);
  const auto frame = camera->Next();
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->bytes[0], 5);
}

TEST_F(V4l2CameraTest, BreaksOnAnIoErrorAndLivesWhenOpenedAnew) {
  const auto open = [this] { return V4l2Camera::Open("/dev/video0", {}, clock_, kernel_); };
  auto camera = open().value();
  kernel_.failing_error = EIO;
  kernel_.failing_request = VIDIOC_DQBUF;
  EXPECT_EQ(camera->Next().error().cause, std::errc::io_error);
  kernel_.failing_error = 0;
  EXPECT_EQ(camera->Next().error().message(), "read /dev/video0: Input/output error");
  camera.reset();
  EXPECT_EQ(kernel_.mapped(), 0u);
  camera = open().value();
  EXPECT_EQ(kernel_.opened(), 2);
  kernel_.Expose(5, clock_.now());
  EXPECT_TRUE(camera->Next());
}

TEST_F(V4l2CameraTest, BreaksWhenItStallsAndNotBefore) {
  const auto camera = Opened();
  clock_.Advance(std::chrono::milliseconds(900));
  EXPECT_EQ(camera->Next().error().cause, std::errc::resource_unavailable_try_again);
  kernel_.Expose(5, clock_.now());
  EXPECT_TRUE(camera->Next());
  clock_.Advance(std::chrono::milliseconds(900));
  EXPECT_EQ(camera->Next().error().cause, std::errc::resource_unavailable_try_again);
  clock_.Advance(std::chrono::milliseconds(101));
  const auto stalled = camera->Next();
  EXPECT_EQ(stalled.error().cause, std::errc::io_error);
  EXPECT_THAT(stalled.error().attempt, HasSubstr("wait any longer for /dev/video0"));
}

TEST_F(V4l2CameraTest, BreaksWhenItsSourceChangesSize) {
  const auto camera = Opened();
  kernel_.source_changed = true;
  kernel_.Expose(5, clock_.now());
  EXPECT_EQ(camera->Next().error().cause, std::errc::io_error);
  kernel_.gives = {V4L2_PIX_FMT_YUYV, 30, 320, 240};
  EXPECT_EQ(Opened()->format().format().width_px, 320);
}

}  // namespace
}  // namespace kaori::camera
