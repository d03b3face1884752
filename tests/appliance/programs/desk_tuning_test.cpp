// What desk and guide ask of the lips' settings, without a camera.
#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <thread>

#include "appliance/programs/lips/service/tuning.h"

namespace kaori::lips {
namespace {

class TuningFile : public ::testing::Test {
 protected:
  TuningFile() { std::filesystem::create_directories(folder_); }
  ~TuningFile() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) / ("tuning-" + std::to_string(::getpid()));
  Time now_ = Time{} + std::chrono::seconds(1);
};

TEST_F(TuningFile, OfTwoSavesThatOverlapIsSavedForTheFirstAndRefusedToTheSecond) {
  Tuning tuning({}, folder_ / "lips.settings", {.apply = [](const auto&) {}, .free_exposure = [](bool) {}});
  tuning.Execute({.number = 1, .kind = CommandKind::kSave}, now_);
  tuning.Execute({.number = 2, .kind = CommandKind::kSave}, now_);
  EXPECT_EQ(tuning.report().answered, 2U);
  EXPECT_THAT(tuning.report().complaint, ::testing::HasSubstr("already"));
  for (int n = 0; n < 5000 && tuning.report().answered == 2; ++n) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));  // The disk's own time.
    tuning.Step(now_);
  }
  EXPECT_EQ(tuning.report().answered, 1U) << "and not the second one again";
  EXPECT_EQ(tuning.report().complaint, "");
}

}  // namespace
}  // namespace kaori::lips
