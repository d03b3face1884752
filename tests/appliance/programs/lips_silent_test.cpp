// Lip cameras that open and send nothing, and drivers that block.
#include <algorithm>

#include <gtest/gtest.h>

#include "appliance/programs/lips/lip_reader.h"
#include "tests/appliance/core/board_file.h"

namespace kaori::lips {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

class SilentCamera final : public ports::Camera {
 public:
  SilentCamera(ManualClock& clock, Duration closes_after) : clock_(clock), closes_after_(closes_after) {}
  ~SilentCamera() override { clock_.Advance(closes_after_); }
  int pollable() const override { return -1; }
  Result<ports::CameraFrame> Next() override {
    return Fail(std::errc::resource_unavailable_try_again, "read a frame");
  }

 private:
  ManualClock& clock_;
  Duration closes_after_;
};

class SilentCameras : public ::testing::Test {
 protected:
  // Gives the log.
  std::string Live(Duration time) {
    testing::internal::CaptureStderr();
    for (const Time end = clock_.now() + time; clock_.now() < end; clock_.Advance(milliseconds(25)))
      reader_.Step();
    return testing::internal::GetCapturedStderr();
  }

  const board::BoardFile file_;
  const board::Board board_ = file_.Open();
  ManualClock clock_;
  int opened_ = 0;
  Duration opens_after_{}, closes_after_{};
  std::errc failure_{};
  LipReader reader_{[this]() -> Result<std::unique_ptr<ports::Camera>> {
                      ++opened_;
                      clock_.Advance(opens_after_);
                      if (failure_ != std::errc{}) return Fail(failure_, "open the camera");
                      return std::make_unique<SilentCamera>(clock_, closes_after_);
                    },
                    board_, board_.AcquireWriter<board::Lips>().value(), LipSettings{}, clock_};
};

TEST_F(SilentCameras, AreOpenedLessAndLessOftenAndFillNoLog) {
  const std::string log = Live(seconds(60));
  EXPECT_LE(opened_, 12);
  EXPECT_GE(opened_, 8);
  EXPECT_LE(std::ranges::count(log, '\n'), 4) << log;
  EXPECT_NE(log.find("lip camera: no frame for 2 s; the lip camera is opened again"), log.npos) << log;
}

TEST_F(SilentCameras, WhoseDriverBlocksAreOpenedSeldom) {
  failure_ = std::errc::io_error;
  opens_after_ = seconds(5);
  Live(seconds(100));
  EXPECT_LE(opened_, 2);
}

TEST_F(SilentCameras, WhoseDriverBlocksAtTheEndAreOpenedSeldom) {
  closes_after_ = seconds(5);
  Live(seconds(100));
  EXPECT_LE(opened_, 2);
}

}  // namespace
}  // namespace kaori::lips
