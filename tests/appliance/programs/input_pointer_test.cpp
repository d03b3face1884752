// What a mouse or a tablet does to the board, through report bytes.
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/appliance/programs/input_fixture.h"

namespace kaori::input {
namespace {

using board::SourceState;
using std::chrono::milliseconds;
using ::testing::FloatNear;

class Pointer : public InputFixture {};

TEST_F(Pointer, PositionButtonsAndWheelReachTheBoard) {
  rig_->pointer().Move(0.25, 0.75);
  rig_->pointer().Push(0);
  rig_->pointer().Roll(3);
  Play(milliseconds(5));
  const auto pointer = Board().pointer;
  EXPECT_EQ(pointer.source, SourceState::kLive);
  EXPECT_THAT(pointer.value.x, FloatNear(0.25F, 1e-4F));
  EXPECT_THAT(pointer.value.y, FloatNear(0.75F, 1e-4F));
  EXPECT_EQ(pointer.value.buttons_down, 1U);
  EXPECT_EQ(pointer.value.wheel, 3);
  rig_->pointer().Release(0);
  rig_->pointer().Push(2);
  Play(milliseconds(5));
  EXPECT_EQ(Board().pointer.value.buttons_down, 4U);
  EXPECT_THAT(Board().pointer.value.pushes, ::testing::ElementsAre(1U, 0U, 1U));
}

TEST_F(Pointer, AClickBetweenTwoReadsIsCounted) {
  rig_->pointer().Push(0);
  rig_->pointer().Release(0);
  Play(milliseconds(5));
  EXPECT_EQ(Board().pointer.value.buttons_down, 0U);
  EXPECT_EQ(Board().pointer.value.pushes[0], 1U);
}

TEST_F(Pointer, ABoxWithoutOneServesTheOtherDevices) {
  KillService();
  ASSERT_TRUE(rig_->Unplug("pointer"));
  board::BoardFile other;
  const board::Board fresh = other.Open();
  const auto bus = hid::LocalHidBus::Watch(links()).value();
  InputService service(fresh, InputWriters::Acquire(fresh).value(), {.buses = {bus.get()}, .lines = {}}, {},
                       clock_);
  for (int ms = 0; ms < 1000; ++ms) {
    clock_.Advance(milliseconds(1));
    rig_->Pump();
    service.Step();
  }
  EXPECT_EQ(service.attached_devices(), 4);
  EXPECT_EQ(board::ReadAll(fresh).pointer.source, SourceState::kAbsent);
  EXPECT_EQ(board::ReadAll(fresh).keys.source, SourceState::kLive);
}

TEST_F(Pointer, StaysWhereItWasWhenTheCableIsPulledAndReleasesItsButtons) {
  rig_->pointer().Move(0.9, 0.1);
  rig_->pointer().Push(0);
  rig_->pointer().Roll(-4);
  Play(milliseconds(5));
  ASSERT_TRUE(rig_->Unplug("pointer"));
  Play(milliseconds(5));
  EXPECT_EQ(Board().pointer.source, SourceState::kStale);
  EXPECT_THAT(Board().pointer.value.x, FloatNear(0.9F, 1e-4F));
  EXPECT_EQ(Board().pointer.value.buttons_down, 0U);
  rig_->pointer().Release(0);
  ASSERT_TRUE(rig_->Plug("pointer"));
  Play(milliseconds(50));
  EXPECT_EQ(Board().pointer.source, SourceState::kLive);
  EXPECT_THAT(Board().pointer.value.x, FloatNear(0.9F, 1e-4F));
  rig_->pointer().Roll(1);
  Play(milliseconds(5));
  EXPECT_EQ(Board().pointer.value.wheel, -3) << "notches add up over plugs";
}

TEST_F(Pointer, GoesOnWhenTheProgramIsKilledWithItsButtonHeld) {
  rig_->pointer().Move(0.3, 0.6);
  rig_->pointer().Push(0);
  rig_->pointer().Roll(5);
  Play(milliseconds(5));
  KillService();
  Play(milliseconds(100));
  StartService();
  Play(milliseconds(600));
  EXPECT_THAT(Board().pointer.value.x, FloatNear(0.3F, 1e-4F));
  EXPECT_EQ(Board().pointer.value.wheel, 5);
  EXPECT_EQ(Board().pointer.value.buttons_down, 1U) << "it is still held";
  EXPECT_EQ(Board().pointer.value.pushes[0], 1U) << "and was pushed once, not twice";
}

TEST_F(Pointer, TornAndForeignReportsChangeNothing) {
  rig_->pointer().Move(0.3, 0.6);
  Play(milliseconds(5));
  for (const std::size_t bytes : {1U, 3U, 5U}) ASSERT_TRUE(rig_->SendTorn("pointer", bytes));
  ASSERT_TRUE(rig_->SendRaw("pointer", std::vector<std::uint8_t>(64, 0xFF)));
  Play(milliseconds(20));
  EXPECT_THAT(Board().pointer.value.x, FloatNear(0.3F, 1e-4F));
  EXPECT_EQ(Board().pointer.value.buttons_down, 0U);
  EXPECT_EQ(Board().pointer.source, SourceState::kLive);
}

TEST_F(Pointer, SettingsNameItsPortAndItsSpeed) {
  const std::string path = (file_.folder() / "input.toml").string();
  std::ofstream(path) << "[pointer]\nport = \"1-4.5\"\ncounts_across = 3200\n";
  const auto settings = ReadSettings(path);
  ASSERT_TRUE(settings) << settings.error().message();
  EXPECT_EQ(settings->pointer_port, "1-4.5");
  EXPECT_EQ(settings->pointer.counts_across, 3200);
  EXPECT_EQ(settings->pointer.counts_down, decode::PointerSettings{}.counts_down);
  std::ofstream(path) << "[pointer]\ncounts_down = 0\n";
  EXPECT_FALSE(ReadSettings(path)) << "a mouse that moves to the edge at once";
}

}  // namespace
}  // namespace kaori::input
