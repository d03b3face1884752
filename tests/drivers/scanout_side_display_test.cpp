// Screens that are the status display or the monitor: beside the show's screens, and never in their way.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "tests/drivers/scanout_fixture.h"

namespace kaori::scanout {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in milliseconds.
using tests::FakeCard;
using tests::ModeOf;

constexpr int kWidth_px = 320, kHeight_px = 200;

class StatusScreen : public tests::Screens {
 protected:
  StatusScreen() {
    preferences_.status_connector = "HDMI-A-2";
    card_.PlugIn(0);
    card_.PlugIn(1, {ModeOf(kWidth_px, kHeight_px)});
  }
  Result<void> ShowRows(KmsScreen& screen, int first, int end) {
    return screen.status_display()->Show(picture_, std::array{ports::DisplayArea{0, first, kWidth_px, end}});
  }
  Result<void> ShowAll(KmsScreen& screen) { return ShowRows(screen, 0, kHeight_px); }
  const std::vector<std::uint8_t>& buffer() const { return card_.dumb_buffers.begin()->second; }
  std::uint32_t StatusPlane() const { return FakeCard::kFirstPlane + 1; }

  std::vector<std::uint8_t> picture_ = std::vector<std::uint8_t>(std::size_t{kWidth_px} * kHeight_px * 4);
};

TEST_F(StatusScreen, IsNoPartOfThePicture) {
  const auto screen = Open();
  EXPECT_EQ(size_px_, std::pair(640, 480));
  ASSERT_NE(screen->status_display(), nullptr);
  EXPECT_EQ(screen->status_display()->width_px(), kWidth_px);
  EXPECT_EQ(screen->status_display()->height_px(), kHeight_px);
  ASSERT_EQ(screen->outputs().size(), 2U);
  EXPECT_EQ(ports::Describe(screen->outputs()[1]), "HDMI-A-2 320 x 200 at 60 Hz, shows the status");
}

TEST_F(StatusScreen, IsNamedByItsNumberToo) {
  preferences_.status_connector = "2";
  EXPECT_NE(Open()->status_display(), nullptr);
}

TEST_F(StatusScreen, AloneBelongsToTheShow) {
  card_.Pull(0);
  const auto screen = Open();
  EXPECT_EQ(size_px_, std::pair(kWidth_px, kHeight_px));
  EXPECT_EQ(screen->status_display(), nullptr);
}

TEST_F(StatusScreen, AndTheMonitorAreTwoScreensBesideTheShow) {
  card_.PlugIn(2);
  preferences_.monitor_connector = "HDMI-A-3";
  const auto screen = Open();
  EXPECT_EQ(size_px_, std::pair(640, 480)) << "which has the first one for itself";
  ASSERT_NE(screen->monitor_display(), nullptr);
  ASSERT_NE(screen->status_display(), nullptr);
  EXPECT_EQ(screen->monitor_display()->width_px(), 640);
  ASSERT_EQ(screen->outputs().size(), 3U);
  EXPECT_EQ(ports::Describe(screen->outputs()[2]),
            "HDMI-A-3 640 x 480 at 60 Hz, shows the operators' monitor");
}

TEST_F(StatusScreen, ThatIsTheMonitorTooIsTheMonitor) {
  preferences_.monitor_connector = "2";
  const auto screen = Open();
  EXPECT_NE(screen->monitor_display(), nullptr);
  EXPECT_EQ(screen->status_display(), nullptr);
}

TEST_F(StatusScreen, LeavesTheShowItsLastScreenWhereAllAreNamed) {
  preferences_.monitor_connector = "HDMI-A-1";
  const auto screen = Open();
  EXPECT_NE(screen->monitor_display(), nullptr);
  EXPECT_EQ(size_px_, std::pair(kWidth_px, kHeight_px));
}

TEST_F(StatusScreen, WhoseLinkFailedIsSetUpAnew) {
  const auto screen = Open();
  ASSERT_TRUE(Frame(*screen));
  ASSERT_TRUE(ShowAll(*screen));
  card_.Blank(clock_.now());
  const int before = card_.modesets;
  card_.connectors[1].link_is_bad = true;
  card_.hotplug = true;
  ASSERT_TRUE(Frames(*screen, 300ms));
  EXPECT_TRUE(screen->status_display()->fresh()) << "it wants its whole picture";
  ASSERT_TRUE(ShowAll(*screen));
  card_.Blank(clock_.now());
  EXPECT_FALSE(card_.connectors[1].link_is_bad);
  EXPECT_EQ(card_.modesets, before + 1);
  ASSERT_TRUE(Frames(*screen, 20s));
  EXPECT_FALSE(screen->status_display()->fresh()) << "once";
}

TEST_F(StatusScreen, WhoseNameNoScreenHasIsNone) {
  preferences_.status_connector = "DP-7";
  const auto screen = Open();
  EXPECT_EQ(screen->status_display(), nullptr);
  EXPECT_EQ(size_px_, std::pair(640 + kWidth_px, 480));
}

TEST_F(StatusScreen, ShowsItsRowsAsTheCardWantsThem) {
  const auto screen = Open();
  picture_[0] = 10, picture_[1] = 20, picture_[2] = 30;  // Left below: R, G, B.
  ASSERT_TRUE(ShowAll(*screen));
  const std::size_t pitch = buffer().size() / kHeight_px;
  const std::uint8_t* const pixel = buffer().data() + (kHeight_px - 1) * pitch;
  EXPECT_EQ(pixel[0], 30);
  EXPECT_EQ(pixel[1], 20);
  EXPECT_EQ(pixel[2], 10);
  EXPECT_EQ(card_.Value(card_.connectors[1].id, "CRTC_ID"), FakeCard::kFirstCrtc + 1);
}

TEST_F(StatusScreen, CopiesOnlyTheAreasThatItIsGiven) {
  const auto screen = Open();
  std::ranges::fill(picture_, std::uint8_t{9});
  const std::array areas{ports::DisplayArea{10, 50, 20, 52}, ports::DisplayArea{0, 60, 1, 61}};
  const int before = card_.commits;
  ASSERT_TRUE(screen->status_display()->Show(picture_, areas));
  EXPECT_EQ(std::ranges::count(buffer(), std::uint8_t{9}), (10 * 2 + 1) * 3);
  EXPECT_EQ(card_.commits, before + 1) << "and shows them together";
}

TEST_F(StatusScreen, APictureOfAnotherSizeIsRefused) {
  const auto screen = Open();
  picture_.pop_back();
  EXPECT_EQ(ShowAll(*screen).error().cause, std::errc::invalid_argument);
  picture_.push_back(0);
  EXPECT_EQ(ShowRows(*screen, 0, kHeight_px + 1).error().cause, std::errc::invalid_argument);
  EXPECT_EQ(ShowRows(*screen, 5, 4).error().cause, std::errc::invalid_argument);
}

TEST_F(StatusScreen, NoFrameOfTheShowWaitsForIt) {
  const auto screen = Open();
  ASSERT_TRUE(Frame(*screen));
  const int before = card_.commits;
  ASSERT_TRUE(screen->Acquire());
  ASSERT_TRUE(ShowAll(*screen));
  ASSERT_TRUE(screen->Present(++frame_));
  EXPECT_EQ(ShowAll(*screen).error().cause, std::errc::device_or_resource_busy)
      << "its own flip is still to come";
  card_.Blank(clock_.now());
  ASSERT_TRUE(screen->ReadFlip());
  EXPECT_TRUE(ShowAll(*screen)) << "and then it shows";
  EXPECT_EQ(card_.commits, before + 3);
}

TEST_F(StatusScreen, IsNotTurnedOffByTheFirstPictureOfTheShow) {
  card_.state_[{StatusPlane(), "FB_ID"}] = 7;
  card_.state_[{FakeCard::kFirstCrtc + 1, "ACTIVE"}] = 1;
  card_.framebuffers = {7};
  const auto screen = Open();
  ASSERT_TRUE(Frame(*screen));
  EXPECT_EQ(card_.Value(FakeCard::kFirstCrtc + 1, "ACTIVE"), 1U);
  EXPECT_TRUE(card_.framebuffers.contains(7)) << "it stands there until the display has something to show";
  ASSERT_TRUE(ShowAll(*screen));
  EXPECT_TRUE(card_.framebuffers.contains(7));
  card_.Blank(clock_.now());
  ASSERT_TRUE(ShowAll(*screen));
  EXPECT_FALSE(card_.framebuffers.contains(7));
}

TEST_F(StatusScreen, ThatIsPulledDisturbsNobodyAndIsBackWhenItIsPluggedIn) {
  auto screen = Open();
  ASSERT_TRUE(Frames(*screen, 1s));
  card_.Pull(1);
  ASSERT_TRUE(Frames(*screen, 1s));
  card_.PlugIn(1, {ModeOf(kWidth_px, kHeight_px)});
  EXPECT_EQ(Frames(*screen, 1s).error().cause, std::errc::no_such_device) << "to be opened anew";
  screen = Open();
  EXPECT_NE(screen->status_display(), nullptr);
}

TEST_F(StatusScreen, LeavesNothingBehindButItsPicture) {
  auto screen = Open();
  ASSERT_TRUE(ShowAll(*screen));
  screen.reset();
  EXPECT_TRUE(card_.dumb_buffers.empty());
  EXPECT_TRUE(card_.mode_blobs.empty());
  EXPECT_EQ(card_.framebuffers.size(), 1U);
}

}  // namespace
}  // namespace kaori::scanout
