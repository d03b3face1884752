// What the contract of Camera leaves to cameras by requests, and the plug-in of libcamera's.
#include <cstring>
#include <filesystem>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include "drivers/camera/libcamera/libcamera_choice.h"
#include "drivers/camera/libcamera/request_camera.h"
#include "drivers/camera/named_camera.h"
#include "tests/drivers/camera_fake_requests.h"

namespace kaori::camera {
namespace {

using ports::CameraFormat;
using ports::PixelFormat;
using ::testing::HasSubstr;

using tests::kRequestBytes;

class Requests : public ::testing::Test {
 protected:
  Requests() {
    auto device = std::make_unique<tests::FakeRequests>();
    device_ = device.get();
    camera_ = RequestCamera::Start(std::move(device), tests::FakeStream(), clock_).value();
  }
  std::errc Cause() {
    const auto frame = camera_->Next();
    return frame ? std::errc{} : frame.error().cause;
  }
  bool Readable() const {
    pollfd waiting{camera_->pollable(), POLLIN, 0};
    return ::poll(&waiting, 1, 0) == 1;
  }

  ManualClock clock_;
  tests::FakeRequests* device_ = nullptr;
  std::unique_ptr<RequestCamera> camera_;
};

TEST_F(Requests, ShowTheNewestFrameWithItsStampAndGiveTheOthersBackAtOnce) {
  EXPECT_EQ(device_->queued.size(), 4u);
  EXPECT_FALSE(Readable());
  EXPECT_EQ(Cause(), std::errc::resource_unavailable_try_again);
  for (const std::uint8_t grey : {std::uint8_t{1}, std::uint8_t{2}, std::uint8_t{3}})
    device_->Fill(grey, clock_.now() - std::chrono::milliseconds(grey));
  EXPECT_TRUE(Readable());
  const auto frame = camera_->Next();
  ASSERT_TRUE(frame) << frame.error().message();
  EXPECT_EQ(frame->bytes[7], 3);
  EXPECT_EQ(frame->at, clock_.now() - std::chrono::milliseconds(3));
  EXPECT_EQ(frame->sequence, 2u);
  EXPECT_EQ(frame->format.width_px, 320);
  EXPECT_EQ(device_->queued.size(), 3u);
  EXPECT_FALSE(Readable());
  EXPECT_EQ(Cause(), std::errc::resource_unavailable_try_again);
  EXPECT_EQ(device_->queued.size(), 4u);
}

TEST_F(Requests, ThatCameBackTornAreDroppedAndQueuedAgain) {
  device_->Fill(1, clock_.now(), false);
  EXPECT_EQ(Cause(), std::errc::bad_message);
  for (const std::uint32_t bytes : {0U, 1000U, kRequestBytes + 1}) {
    device_->Fill(1, clock_.now(), true, bytes);
    EXPECT_EQ(Cause(), std::errc::bad_message);
  }
  EXPECT_EQ(device_->queued.size(), 4u);
  device_->Fill(5, clock_.now());
  device_->Fill(6, clock_.now(), false);
  EXPECT_EQ(camera_->Next()->bytes[0], 5);
}

TEST_F(Requests, BreakWhenTheLibraryRefusesABuffer) {
  device_->Fill(1, clock_.now());
  ASSERT_EQ(Cause(), std::errc{});
  device_->refuses = true;
  EXPECT_EQ(Cause(), std::errc::no_such_device);
  device_->refuses = false;
  EXPECT_EQ(Cause(), std::errc::no_such_device);
}

TEST_F(Requests, CrossFromTheLibrarysThreadWithoutLoss) {
  Completions completions;
  constexpr std::uint32_t kMany = 20000;
  std::thread library([&] {
    for (std::uint32_t n = 0; n < kMany; ++n) completions.Add({.sequence = n});
  });
  std::uint32_t next = 0;
  while (next < kMany)
    for (const CompletedRequest& request : completions.DrainAll()) ASSERT_EQ(request.sequence, next++);
  library.join();
  EXPECT_TRUE(completions.DrainAll().empty());
}

TEST(LibcameraFormat, IsTheSmallestThatLipsNeedWithoutJpegIfItCanBe) {
  const std::vector<CameraFormat> offered{{1920, 1080, PixelFormat::kMjpeg},
                                          {160, 120, PixelFormat::kNv12},
                                          {640, 480, PixelFormat::kYuyv},
                                          {640, 480, PixelFormat::kNv12},
                                          {320, 240, PixelFormat::kMjpeg}};
  EXPECT_EQ(ChooseFormat(offered), (CameraFormat{320, 240, PixelFormat::kMjpeg}));
  EXPECT_EQ(ChooseFormat(std::span(offered).first(4)), (CameraFormat{640, 480, PixelFormat::kNv12}));
  EXPECT_EQ(ChooseFormat(std::span(offered).first(1)), (CameraFormat{1920, 1080, PixelFormat::kMjpeg}));
  EXPECT_EQ(ChooseFormat({}), std::nullopt);
  EXPECT_EQ(NameOf(CameraFormat{640, 480, PixelFormat::kNv12}, 60), "640 x 480 NV12 at 60 frames/s");
}

TEST(LibcameraRate, StepsDownFromTheCamerasFastest) {
  const FrameTimes fast{8'333, 1'000'000};
  EXPECT_EQ(FrameTimeOf(fast, 0), 8'333);
  EXPECT_EQ(FrameTimeOf(fast, 1), 16'667);
  EXPECT_EQ(FrameTimeOf(fast, 2), 33'333);
  EXPECT_EQ(FrameTimeOf(fast, 4), std::nullopt);
  EXPECT_EQ(FrameTimeOf({33'333, 33'333}, 1), std::nullopt);
}

TEST(CameraPlugin, ThatCannotBeLoadedIsOneLine) {
  EXPECT_EQ(LoadCameraPlugin("/nowhere/plugin.so").error().message(),
            "load the camera plug-in /nowhere/plugin.so (it is not there): Operation not supported");
  const auto itself = LoadCameraPlugin("/proc/self/exe");
  EXPECT_EQ(itself.error().cause, std::errc::not_supported);
  const auto wrong = LoadCameraPlugin(PluginFile("wrong-camera-plugin"));
  EXPECT_THAT(wrong.error().message(), HasSubstr("(it is of version 99)"));
}

TEST(CameraPlugin, OfLibcameraSaysThatItSeesNoCameraAndWhichItLooksFor) {
  if (!std::filesystem::exists(PluginFile("kaori-camera-libcamera")))
    GTEST_SKIP() << "the plug-in was left out: libcamera-dev was not there at build";
  const SteadyClock clock;
  NamedCamera named("libcamera:no such camera", clock);
  const auto modes = named.ModesText();
  ASSERT_TRUE(modes) << modes.error().message();
  const auto camera = named.opener()();
  ASSERT_FALSE(camera);
  EXPECT_EQ(camera.error().cause, std::errc::no_such_device);
  EXPECT_THAT(camera.error().attempt, HasSubstr("find the camera no such camera among libcamera's ("));
  ASSERT_NE(named.tuning(), nullptr);
  EXPECT_EQ(named.tuning()->mode(), "");
  EXPECT_FALSE(named.tuning()->Slower());
}

TEST(NamedCamera, IsOfV4l2WhereNoLibraryIsNamed) {
  const SteadyClock clock;
  NamedCamera named("/dev/no-such-camera", clock);
  EXPECT_EQ(named.opener()().error().cause, std::errc::no_such_device);
  EXPECT_FALSE(named.ModesText());
}

}  // namespace
}  // namespace kaori::camera
