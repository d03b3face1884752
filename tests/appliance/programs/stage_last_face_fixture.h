// The last face in a folder that is a test's own, of a show that a test plays.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

#include "appliance/programs/stage/last_face.h"
#include "tests/appliance/core/performance_fixture.h"

namespace kaori::stage {

class LastFaceTest : public performance::PerformanceTest {
 protected:
  LastFaceTest()
      : folder_(std::filesystem::path(::testing::TempDir()) / ("last-face-" + std::to_string(::getpid()))),
        place_{.file = folder_ / "last-face", .show = 77} {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    Begin();
  }
  ~LastFaceTest() override {
    keeper_.reset();
    std::filesystem::permissions(folder_, std::filesystem::perms::owner_all);
    std::filesystem::remove_all(folder_);
  }

  void Begin(const std::optional<performance::State>& recalled = {}) {
    keeper_.reset();
    keeper_.emplace(
        place_,
        [this](SmallImage& into) {
          ++looks_;
          into = {.width_px = 2, .height_px = 1, .pixels = {1, 2, 3, 0, 4, 5, 6, 0}};
          return true;
        },
        [this] { return is_on_trial_; }, recalled);
  }
  // Each look is on the disk before the next frame.
  void Play(Duration time) {
    for (const Time end = now_ + time; now_ < end;) {
      Step();
      keeper_->Observe(state_, performed_.scene, now_);
      keeper_->Finish();
    }
  }
  std::string File() const {
    std::ifstream file(place_.file, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void Write(const std::string& bytes) const { std::ofstream(place_.file, std::ios::binary) << bytes; }
  std::string Refusal(const LastFaceFile& place) {
    const auto state = RecallLastFace(place, show_, board_, now_);
    return state ? "" : state.error().message();
  }

  std::filesystem::path folder_;
  LastFaceFile place_;
  std::optional<LastFace> keeper_;
  int looks_ = 0;
  bool is_on_trial_ = false;
};

}  // namespace kaori::stage
