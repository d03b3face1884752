// Cables that are pulled, simulators that end, and reports that are damaged.
#include <array>
#include <filesystem>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "hw-sim/devices/stick_pod.h"
#include "tests/appliance/programs/input_fixture.h"
#include "tests/appliance/programs/input_owned_fixture.h"

namespace kaori::input {
namespace {

using board::SourceState;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr std::uint8_t kKeyA = 0x04;

class Cables : public InputFixture {};
class BadReports : public InputFixture {};

// Two equal sticks, of which the one at the later port is listed first, as it happens when a box starts.
class LateStick : public OwnedDevices {
 protected:
  LateStick() {
    PlugIn("1-3", at_3_);
    Start();
  }
  // Whether the stick at port 1-2 is the left one and the other the right one.
  bool AreInOrder() {
    at_2_.Move(-1, 0);
    at_3_.Move(1, 0);
    Play(milliseconds(20));
    return Board().sticks[0].value.x < -0.9F && Board().sticks[1].value.x > 0.9F;
  }
  const sim::DeviceContext context_{clock_, {}};
  sim::StickPod at_2_{sim::DevicePort::kStickLeft, context_};
  sim::StickPod at_3_{sim::DevicePort::kStickLeft, context_};
};

TEST_F(LateStick, AtTheLowerPortIsTheLeftOneAllTheSame) {
  Play(seconds(9));
  PlugIn("1-2", at_2_);
  Play(milliseconds(50));
  EXPECT_EQ(service_->attached_devices(), 2);
  EXPECT_TRUE(AreInOrder());
  EXPECT_EQ(Board().sticks[0].source, SourceState::kLive);
}

TEST_F(LateStick, TakesNoRoleFromOneThatIsPlayed) {
  at_3_.Move(0.5F, 0);
  Play(milliseconds(50));
  PlugIn("1-2", at_2_);
  Play(milliseconds(50));
  at_3_.Move(-1, 0);
  at_2_.Move(1, 0);
  Play(milliseconds(20));
  EXPECT_LT(Board().sticks[0].value.x, -0.9F);
  EXPECT_GT(Board().sticks[1].value.x, 0.9F);
}

TEST_F(LateStick, TakesNoRoleFromOneWhoseButtonWasPushed) {
  at_3_.Push(2);
  Play(milliseconds(50));
  at_3_.Release(2);
  Play(milliseconds(50));
  PlugIn("1-2", at_2_);
  Play(milliseconds(50));
  EXPECT_FALSE(AreInOrder());
}

TEST_F(LateStick, OfTheEveningTakesTheRoleThatIsFree) {
  Play(seconds(11));
  PlugIn("1-2", at_2_);
  Play(milliseconds(50));
  EXPECT_EQ(service_->attached_devices(), 2);
  EXPECT_FALSE(AreInOrder());
}

TEST_F(Cables, OfDevicesThatAreGoneAfterARestartMakeTheirSectionsStale) {
  KillService();
  ASSERT_TRUE(rig_->Unplug("keyboard"));
  Play(milliseconds(5));
  StartService();
  Play(milliseconds(100));
  EXPECT_EQ(Board().keys.source, SourceState::kLive) << "the device may yet be found";
  Play(milliseconds(500));
  EXPECT_EQ(Board().keys.source, SourceState::kStale);
  EXPECT_EQ(Board().surface.source, SourceState::kLive);
}

TEST_F(Cables, AreFoundAgainTwoHundredTimesWithNoSwapAndNoLeak) {
  const auto open_files = [] {
    return std::distance(std::filesystem::directory_iterator("/proc/self/fd"), {});
  };
  const std::array<const char*, 5> ports{"dial-box", "stick-left", "stick-right", "keyboard", "pointer"};
  const auto files_before = open_files();
  std::mt19937 random(200);
  for (int round = 0; round < 200; ++round) {
    const char* port = ports[random() % ports.size()];
    ASSERT_TRUE(rig_->Unplug(port));
    Play(milliseconds(random() % 3));
    ASSERT_TRUE(rig_->Plug(port));
    rig_->left_stick().Move(-1, 0);
    rig_->right_stick().Move(1, 0);
    Play(milliseconds(20));
    ASSERT_EQ(service_->attached_devices(), 5) << "round " << round << ", " << port;
    rig_->left_stick().Move(-1, 0.01F * static_cast<float>(round % 50));
    rig_->right_stick().Move(1, 0.01F * static_cast<float>(round % 50));
    Play(milliseconds(3));
    ASSERT_LT(Board().sticks[0].value.x, -0.9F) << "round " << round;
    ASSERT_GT(Board().sticks[1].value.x, 0.9F) << "round " << round;
  }
  EXPECT_EQ(open_files(), files_before);
}

TEST_F(Cables, MayBePulledWithTheWholeSimulator) {
  rig_->dial_box().Turn(0, 1);
  Play(milliseconds(5));
  rig_.reset();
  for (int i = 0; i < 20; ++i) {
    clock_.Advance(milliseconds(10));
    service_->Step();
  }
  EXPECT_EQ(service_->attached_devices(), 0);
  EXPECT_EQ(Board().surface.value.counts[0], 256);
  rig_ = sim::Rig::Open({.folder = links()}, clock_).value();
  Play(milliseconds(500));
  EXPECT_EQ(service_->attached_devices(), 5);
  EXPECT_EQ(Board().surface.value.counts[0], 256);
}

TEST_F(BadReports, TornShortLongAndUnknownOnesChangeNothing) {
  rig_->dial_box().Turn(0, 1);
  rig_->left_stick().Move(0.5F, 0.5F);
  rig_->keyboard().Press(kKeyA);
  Play(milliseconds(5));
  const board::Snapshot before = Board();
  for (const char* port : {"dial-box", "stick-left", "keyboard"}) {
    ASSERT_TRUE(rig_->SendTorn(port, 3));
    ASSERT_TRUE(rig_->SendRaw(port, std::vector<std::uint8_t>(1, 0xFF)));
    ASSERT_TRUE(rig_->SendRaw(port, std::vector<std::uint8_t>(64, 0xFF)));
    ASSERT_TRUE(rig_->SendRaw(port, std::vector<std::uint8_t>(4000, 0x55)));
  }
  Play(milliseconds(20));
  const board::Snapshot after = Board();
  EXPECT_EQ(after.surface.value.counts, before.surface.value.counts);
  EXPECT_EQ(after.surface.value.pushes, before.surface.value.pushes);
  EXPECT_EQ(after.sticks[0].value.x, before.sticks[0].value.x);
  EXPECT_EQ(after.keys.value.pushes, before.keys.value.pushes);
  EXPECT_EQ(service_->attached_devices(), 5) << "no device is detached for it";
  rig_->dial_box().Turn(0, 1);
  Play(milliseconds(5));
  EXPECT_EQ(Board().surface.value.counts[0], 512) << "and good reports count again";
}

TEST_F(BadReports, ADeviceThatVanishesInTheMiddleOfOneComesBack) {
  rig_->dial_box().Turn(0, 1);
  Play(milliseconds(5));
  for (int round = 1; round <= 20; ++round) {
    ASSERT_TRUE(rig_->VanishInReport("dial-box", static_cast<std::size_t>(round)));
    Play(milliseconds(3));
    EXPECT_EQ(Board().surface.source, SourceState::kStale);
    EXPECT_EQ(Board().surface.value.counts[0], 256 * round);
    ASSERT_TRUE(rig_->Plug("dial-box"));
    Play(milliseconds(50));
    rig_->dial_box().Turn(0, 1);
    Play(milliseconds(3));
    EXPECT_EQ(Board().surface.value.counts[0], 256 * (round + 1));
  }
}

}  // namespace
}  // namespace kaori::input
