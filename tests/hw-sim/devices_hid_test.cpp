// The simulated HID devices, at the wire: which reports an operator's actions make, and when.
#include <gtest/gtest.h>

#include <array>

#include "hw-sim/devices/dial_box.h"
#include "hw-sim/devices/keyboard.h"
#include "hw-sim/devices/stick_pod.h"

namespace kaori::sim {
namespace {

using namespace std::chrono_literals;

class SimulatedDevices : public ::testing::Test {
 protected:
  // All reports that leave until nothing waits, however long it takes.
  std::vector<Report> Drain(HidDevice& device) {
    std::vector<Report> reports;
    while (const auto due = device.next_due()) {
      if (*due > clock.now()) clock.Advance(*due - clock.now());
      auto report = device.NextReport(clock.now());
      if (!report) break;
      reports.push_back(std::move(*report));
    }
    return reports;
  }
  static wire::DialBoxReport Box(const Report& bytes) {
    return wire::DecodeDialBox(std::span<const std::uint8_t, wire::kDialBoxReportBytes>(bytes));
  }
  static wire::StickPodReport Stick(const Report& bytes) {
    return wire::DecodeStickPod(std::span<const std::uint8_t, wire::kStickPodReportBytes>(bytes));
  }

  ManualClock clock;
  std::vector<OperatorAction> seen;
  DeviceContext context{clock, [this](const OperatorAction& action) { seen.push_back(action); }};
};

TEST_F(SimulatedDevices, ADialKeepsPartsOfACountForTheNextTurn) {
  DialBox box(context);
  box.HostCame();
  int counts = 0;
  for (int n = 0; n < 1000; ++n) {
    box.Turn(2, 0.001);
    for (const Report& report : Drain(box)) counts += Box(report).turned[2];
  }
  EXPECT_EQ(counts, 256);
}

TEST_F(SimulatedDevices, TurnsWithinAMillisecondShareAReport) {
  DialBox box(context);
  box.HostCame();
  box.Turn(0, 0.25);
  box.Turn(0, 0.25);
  box.Turn(7, -0.5);
  const auto reports = Drain(box);
  ASSERT_EQ(reports.size(), 1u);
  EXPECT_EQ(Box(reports[0]).turned[0], 128);
  EXPECT_EQ(Box(reports[0]).turned[7], -128);
}

TEST_F(SimulatedDevices, AWildTurnIsSplitSoThatNoCountIsLost) {
  DialBox box(context);
  box.HostCame();
  box.Turn(0, 300);
  std::int64_t counts = 0;
  for (const Report& report : Drain(box)) counts += Box(report).turned[0];
  EXPECT_EQ(counts, 300 * 256);
}

TEST_F(SimulatedDevices, AButtonThatGoesDownAndUpAtOnceMakesTwoReportsAMillisecondApart) {
  DialBox box(context);
  box.HostCame();
  box.Push(8);
  box.Release(8);
  const auto first = box.NextReport(clock.now());
  ASSERT_TRUE(first);
  EXPECT_EQ(Box(*first).buttons_down, 1u << 8);
  EXPECT_FALSE(box.NextReport(clock.now()));
  clock.Advance(999us);
  EXPECT_FALSE(box.NextReport(clock.now()));
  clock.Advance(1us);
  const auto second = box.NextReport(clock.now());
  ASSERT_TRUE(second);
  EXPECT_EQ(Box(*second).buttons_down, 0u);
}

TEST_F(SimulatedDevices, ButtonsOfAChordShareAReport) {
  DialBox box(context);
  box.HostCame();
  box.Push(1);
  box.Push(2);
  const auto reports = Drain(box);
  ASSERT_EQ(reports.size(), 1u);
  EXPECT_EQ(Box(reports[0]).buttons_down, 6u);
}

TEST_F(SimulatedDevices, NothingChangedMeansNoReport) {
  DialBox box(context);
  StickPod stick(DevicePort::kStickLeft, context);
  Keyboard keyboard(context);
  for (HidDevice* device : std::initializer_list<HidDevice*>{&box, &stick, &keyboard}) device->HostCame();
  box.Release(3);
  stick.Move(0, 0);
  stick.Hat(-1);
  keyboard.Release(0x2C);
  EXPECT_FALSE(box.next_due() || stick.next_due() || keyboard.next_due());
  EXPECT_TRUE(seen.empty());
}

TEST_F(SimulatedDevices, NumbersThatNoHandCanDoAreIgnored) {
  DialBox box(context);
  StickPod stick(DevicePort::kStickLeft, context);
  box.Turn(8, 1);
  box.Turn(-1, 1);
  box.Turn(0, std::numeric_limits<double>::quiet_NaN());
  box.Turn(0, std::numeric_limits<double>::infinity());
  box.Push(32);
  stick.Hat(8);
  stick.Push(12);
  stick.Move(std::numeric_limits<float>::quiet_NaN(), 0);
  EXPECT_FALSE(box.next_due() || stick.next_due());
  EXPECT_TRUE(seen.empty());
}

TEST_F(SimulatedDevices, LampsAreWhatTheLastOutputReportSaid) {
  DialBox box(context);
  box.HandleOutput(std::array<std::uint8_t, 5>{0, 0x01, 0, 0, 0x80});
  EXPECT_EQ(box.lamps(), 0x80000001u);
  box.HandleOutput(std::array<std::uint8_t, 3>{0, 0xFF, 0xFF});           // Short,
  box.HandleOutput(std::array<std::uint8_t, 5>{9, 0xFF, 0xFF, 0xFF, 0});  // and of another report id.
  EXPECT_EQ(box.lamps(), 0x80000001u);
  box.PowerCycle();
  EXPECT_EQ(box.lamps(), 0u);
}

TEST_F(SimulatedDevices, AKeyboardsLightsAreWhatTheLastOutputReportSaid) {
  Keyboard keyboard(context);
  keyboard.HandleOutput(std::array<std::uint8_t, 2>{0, 0xE2});
  EXPECT_EQ(keyboard.lights(), 0x02u) << "caps lock, and no padding";
  keyboard.HandleOutput(std::array<std::uint8_t, 1>{0});
  keyboard.HandleOutput(std::array<std::uint8_t, 2>{7, 0x01});
  EXPECT_EQ(keyboard.lights(), 0x02u);
  keyboard.PowerCycle();
  EXPECT_EQ(keyboard.lights(), 0u);
}

TEST_F(SimulatedDevices, AStickPushedForwardsIsNegativeYOnTheWire) {
  StickPod stick(DevicePort::kStickRight, context);
  stick.HostCame();
  stick.Move(0.5F, 1);
  stick.Slide(1);
  const auto reports = Drain(stick);
  ASSERT_EQ(reports.size(), 1u);
  EXPECT_NEAR(Stick(reports[0]).x, 16384, 3) << "as fine as the converter";
  EXPECT_EQ(Stick(reports[0]).y, -32767);
  EXPECT_EQ(Stick(reports[0]).slider, 65535);
}

TEST_F(SimulatedDevices, AStickStopsAtItsStops) {
  StickPod stick(DevicePort::kStickLeft, context);
  stick.Move(7, -7);
  EXPECT_EQ(stick.x(), 1);
  EXPECT_EQ(stick.y(), -1);
}

TEST_F(SimulatedDevices, AHostThatComesHearsWhatIsHeld) {
  StickPod stick(DevicePort::kStickLeft, context);
  stick.Move(0.4F, 0);
  stick.Push(3);
  stick.Release(3);
  stick.HostCame();
  const auto reports = Drain(stick);
  ASSERT_EQ(reports.size(), 1u);
  EXPECT_EQ(Stick(reports[0]).buttons_down, 0);
  stick.HostLeft();
  stick.HostCame();
  EXPECT_EQ(Drain(stick), reports);
}

TEST_F(SimulatedDevices, WithoutPowerTurnsAreLostButHeldButtonsAreHeld) {
  DialBox box(context);
  box.HostCame();
  box.Turn(0, 1);
  box.Push(5);
  box.HostLeft();
  box.PowerCycle();
  box.HostCame();
  const auto reports = Drain(box);
  ASSERT_EQ(reports.size(), 1u);
  EXPECT_EQ(Box(reports[0]).turned[0], 0);
  EXPECT_EQ(Box(reports[0]).buttons_down, 1u << 5);
}

TEST_F(SimulatedDevices, AHostThatNeverReadsDoesNotEatMemory) {
  DialBox box(context);
  box.HostCame();
  for (int n = 0; n < 100'000; ++n) {
    box.Push(0);
    box.Release(0);
  }
  EXPECT_LE(Drain(box).size(), kMaxWaitingReports);
}

TEST_F(SimulatedDevices, EveryKeyOfTenIsReported) {
  Keyboard keyboard(context);
  keyboard.HostCame();
  for (std::uint8_t usage = 0x04; usage < 0x0E; ++usage) keyboard.Press(usage);
  const auto reports = Drain(keyboard);
  ASSERT_EQ(reports.size(), 1u);
  const auto report =
      wire::DecodeKeyboard(std::span<const std::uint8_t, wire::kKeyboardReportBytes>(reports[0]));
  for (std::uint8_t usage = 0x04; usage < 0x0E; ++usage) EXPECT_TRUE(report.held(usage));
}

TEST_F(SimulatedDevices, TheWatcherSeesEveryHandThatChangesSomething) {
  DialBox box(context);
  box.Turn(1, 0.4);
  box.Push(9);
  box.Push(9);
  EXPECT_EQ(seen, (std::vector<OperatorAction>{{DevicePort::kDialBox, Verb::kTurn, 1, 0.4, 0},
                                               {DevicePort::kDialBox, Verb::kPush, 9, 0, 0}}));
}

}  // namespace
}  // namespace kaori::sim
