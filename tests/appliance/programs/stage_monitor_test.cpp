// The operators' monitor beside the stage: what it shows, how often, and that the show is before it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "appliance/core/performance/animate.h"
#include "appliance/programs/stage/stage_monitor.h"
#include "tests/appliance/core/board_file.h"
#include "tests/appliance/core/pack_fixture.h"

namespace kaori::stage {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in milliseconds.

constexpr int kWide_px = 640, kHigh_px = 360;
constexpr std::time_t kEvening = 1'790'000'000;

// Keeps what it is shown.
class KeptDisplay final : public ports::SideDisplay {
 public:
  int width_px() const override { return kWide_px; }
  int height_px() const override { return kHigh_px; }
  bool fresh() const override { return shows == 0; }
  Result<void> Show(std::span<const std::uint8_t> rgbx, std::span<const ports::DisplayArea> areas) override {
    ++calls;
    if (fault != std::errc()) return Fail(fault, "show on the kept display");
    ++shows;
    for (const ports::DisplayArea& area : areas)
      for (int y = area.bottom_px; y < area.top_px; ++y)
        for (int x = area.left_px; x < area.right_px; ++x) {
          const auto at = (std::size_t(y) * kWide_px + std::size_t(x)) * 4;
          std::copy_n(rgbx.begin() + std::ptrdiff_t(at), 4, picture.begin() + std::ptrdiff_t(at));
        }
    return {};
  }
  // How many pixels of a box, counted from the top, are brighter than this.
  int CountBright(const monitor::Box& box, int than) const {
    int count = 0;
    for (int y = box.top; y < box.bottom(); ++y)
      for (int x = box.left; x < box.right(); ++x) {
        const auto* pixel = picture.data() + (std::size_t(kHigh_px - 1 - y) * kWide_px + std::size_t(x)) * 4;
        count += std::max({pixel[0], pixel[1], pixel[2]}) > than ? 1 : 0;
      }
    return count;
  }

  std::errc fault{};
  int calls = 0, shows = 0;
  std::vector<std::uint8_t> picture = std::vector<std::uint8_t>(std::size_t(kWide_px) * kHigh_px * 4);
};

// Every look at it takes a millisecond.
class SlowClock final : public Clock {
 public:
  Time now() const override { return now_ += 1ms; }
  Time seen() const { return now_; }
  void Advance(Duration by) { now_ += by; }

 private:
  mutable Time now_ = Time{} + 1000s;
};

class MonitorOfStage : public ::testing::Test {
 protected:
  void DrawAFrame() {
    const auto scene =
        performance::Animate(performance::Opening(studio_->show(), {}, {}), {}, {}, studio_->show(), {})
            .scene;
    std::vector<std::uint8_t> drawn(96 * 54 * 4);
    ASSERT_TRUE(studio_->Draw(scene, {.width_px = 96, .height_px = 54, .target = ports::PixelMemory{drawn}}));
  }
  void Steps(int count, std::optional<Duration> until_frame = {}) {
    for (; count > 0; --count) {
      clock_.Advance(StageMonitor::kPeriod);
      const auto next = until_frame ? std::optional(clock_.now() + *until_frame) : std::nullopt;
      monitor_.Step(plugged_ ? &display_ : nullptr, {state_, next});
    }
  }
  monitor::Page PageOf() const {
    return monitor::LayOut(monitor::Describe({.show = studio_->show(), .state = state_}), kWide_px, kHigh_px);
  }
  std::string LipFile() const { return board::LipPicturePath(place_.path()); }

  board::BoardFile place_;
  board::Board board_ = place_.Open();
  ManualClock clock_;
  std::unique_ptr<Studio> studio_ = Studio::Open(tests::SmallShow()).value();
  performance::State state_ = performance::Opening(studio_->show(), {}, {});
  StageStatusDisplay status_{board_, clock_, {place_.folder(), place_.folder() / "screens"}};
  KeptDisplay display_;
  bool plugged_ = true;
  StageMonitor monitor_{board_, clock_, *studio_, status_, [] { return kEvening; }};
};

TEST_F(MonitorOfStage, ShowsTheFaceAndTheWords) {
  Steps(1);
  EXPECT_EQ(display_.CountBright(PageOf().programme, 30), 0) << "nothing was drawn on stage yet";
  DrawAFrame();
  Steps(20);
  const monitor::Box& programme = PageOf().programme;
  EXPECT_GT(display_.CountBright(programme, 30), 1000);
  EXPECT_GT(display_.CountBright({0, 0, kWide_px / 4, kHigh_px / 10}, 200), 50) << "the time of day";
}

TEST_F(MonitorOfStage, DrawsPicturesAboutFifteenTimesASecond) {
  Steps(10);
  const int before = display_.shows;
  for (int i = 0; i < 50; ++i) {
    DrawAFrame();
    Steps(1);
  }
  EXPECT_GE(display_.shows - before, 12);
  EXPECT_LE(display_.shows - before, 17);
}

TEST_F(MonitorOfStage, HasNoMoreThanAThirtiethOfTheTimeHoweverSlowTheMachineIs) {
  SlowClock slow;
  StageMonitor monitor(board_, slow, *studio_, status_, [] { return kEvening; });
  const Time began = slow.seen();
  Duration spent{};
  for (int i = 0; i < 3000; ++i) {
    slow.Advance(StageMonitor::kPeriod);
    const Time before = slow.seen();
    const int calls = display_.calls;
    monitor.Step(&display_, {state_});
    if (display_.calls != calls) spent += slow.seen() - before;
  }
  EXPECT_GT(display_.shows, 10);
  EXPECT_LT(Seconds(spent), Seconds(slow.seen() - began) / 30);
}

TEST_F(MonitorOfStage, LetsAFrameBeginThatIsAboutToBegin) {
  DrawAFrame();  // From then on each step has a copy to show, which the one before asked for.
  Steps(20);
  const int before = display_.shows;
  Steps(4, 1ms);
  EXPECT_EQ(display_.shows, before);
  Steps(4, 1ms);  // Up to two of these eight lie within the period of pictures.
  EXPECT_GT(display_.shows, before) << "but not for ever";
}

TEST_F(MonitorOfStage, ThatCannotBeShownIsLeftAloneForAMinute) {
  display_.fault = std::errc::invalid_argument;
  Steps(500);
  EXPECT_EQ(display_.calls, 1);
  display_.fault = {};
  Steps(3000);
  EXPECT_GT(display_.shows, 0);
}

TEST_F(MonitorOfStage, OwesWhatABusyDisplayCouldNotShow) {
  Steps(20);
  display_.fault = std::errc::device_or_resource_busy;
  DrawAFrame();
  const int calls = display_.calls;
  Steps(20);
  EXPECT_GT(display_.calls, calls + 1) << "it is asked again";
  display_.fault = {};
  const int before = display_.shows;
  Steps(5);
  EXPECT_GT(display_.shows, before);
}

TEST_F(MonitorOfStage, AsksForTheLipsPictureOnlyWhileThereIsADisplay) {
  plugged_ = false;
  Steps(10);
  EXPECT_FALSE(std::filesystem::exists(LipFile()));
  plugged_ = true;
  Steps(1);
  EXPECT_TRUE(std::filesystem::exists(LipFile()));
  plugged_ = false;
  Steps(1);
  EXPECT_FALSE(std::filesystem::exists(LipFile()));
}

TEST_F(MonitorOfStage, ShowsTheLipsPictureUntilTheCameraIsSilent) {
  Steps(20);
  const monitor::Box& place = PageOf().lip_picture;
  EXPECT_EQ(display_.CountBright(place, 60), 0);
  board::LipPictureWriter lips(LipFile());
  ASSERT_TRUE(lips.IsDue(clock_.now()));
  lips.Write({2, 1, clock_.now(), {99, 99, 99, 0, 99, 99, 99, 0}});
  Steps(20);
  EXPECT_GT(display_.CountBright(place, 60), 1000);
  Steps(150);
  EXPECT_EQ(display_.CountBright(place, 60), 0) << "an old picture is no picture";
}

TEST_F(MonitorOfStage, IsDrawnWholeWhenTheStatusHasGivenItBack) {
  Steps(20);
  plugged_ = false;
  Steps(1);
  std::ranges::fill(display_.picture, std::uint8_t{0});
  plugged_ = true;
  Steps(4);
  EXPECT_GT(display_.CountBright({0, 0, kWide_px, kHigh_px}, 8), kWide_px * kHigh_px / 2);
}

TEST(MonitorTimeOfDay, IsEmptyWhereTheClockCannotBeBelieved) {
  EXPECT_EQ(TimeOfDay(0), "");
  EXPECT_EQ(TimeOfDay(kEvening).size(), 8U);
}

}  // namespace
}  // namespace kaori::stage
