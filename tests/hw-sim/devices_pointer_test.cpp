// The simulated tablet, at the wire: which reports an operator's actions make, and when.
#include <gtest/gtest.h>

#include <limits>

#include "hw-sim/devices/pointer.h"

namespace kaori::sim {
namespace {

class SimulatedPointer : public ::testing::Test {
 protected:
  SimulatedPointer() { pointer.HostCame(); }

  // All reports that leave until nothing waits.
  std::vector<wire::PointerReport> Drain() {
    std::vector<wire::PointerReport> reports;
    while (const auto due = pointer.next_due()) {
      if (*due > clock.now()) clock.Advance(*due - clock.now());
      const auto report = pointer.NextReport(clock.now());
      if (!report || report->size() != wire::kPointerReportBytes) break;
      reports.push_back(
          wire::DecodePointer(std::span<const std::uint8_t, wire::kPointerReportBytes>(*report)));
    }
    return reports;
  }

  ManualClock clock;
  std::vector<OperatorAction> seen;
  DeviceContext context{clock, [this](const OperatorAction& action) { seen.push_back(action); }};
  Pointer pointer{context};
};

using Reports = std::vector<wire::PointerReport>;

TEST_F(SimulatedPointer, TellsItsPlaceFromEdgeToEdge) {
  pointer.Move(0, 0);
  EXPECT_EQ(Drain(), (Reports{{.x = 0, .y = 0}}));
  pointer.Move(1, 0.25);
  EXPECT_EQ(Drain(), (Reports{{.x = 65535, .y = 16384}}));
}

TEST_F(SimulatedPointer, StopsAtTheEdgesAndHeedsNoNumberThatIsNone) {
  pointer.Move(7, -7);
  EXPECT_EQ(pointer.x(), 1);
  EXPECT_EQ(pointer.y(), 0);
  pointer.Move(std::numeric_limits<double>::quiet_NaN(), 0.5);
  EXPECT_EQ(pointer.x(), 1);
  EXPECT_EQ(pointer.y(), 0.5);
}

TEST_F(SimulatedPointer, MovesWithinAMillisecondShareAReport) {
  for (int n = 1; n <= 10; ++n) pointer.Move(n / 10.0, 0.5);
  EXPECT_EQ(Drain(), (Reports{{.x = 65535}}));
}

// A drag that is quicker than the wire still begins and ends where it did.
TEST_F(SimulatedPointer, AButtonGoesDownAndUpAtItsPlace) {
  pointer.Move(0, 0);
  pointer.Push(0);
  pointer.Move(1, 0);
  pointer.Release(0);
  pointer.Move(1, 1);
  EXPECT_EQ(Drain(), (Reports{{.buttons_down = 1, .x = 0, .y = 0},
                              {.buttons_down = 0, .x = 65535, .y = 0},
                              {.buttons_down = 0, .x = 65535, .y = 65535}}));
}

TEST_F(SimulatedPointer, AWheelKeepsPartsOfANotchForTheNextTurn) {
  int notches = 0;
  for (int n = 0; n < 64; ++n) {
    pointer.Roll(0.125);
    for (const auto& report : Drain()) notches += report.wheel;
  }
  EXPECT_EQ(notches, 8);
  pointer.Roll(-300);
  for (const auto& report : Drain()) notches += report.wheel;
  EXPECT_EQ(notches, -292) << "more than a report carries";
}

TEST_F(SimulatedPointer, HasThreeButtons) {
  for (const int button : {-1, 0, 1, 2, 3, 99}) pointer.Push(button);
  EXPECT_EQ(pointer.buttons_down(), 7);
}

TEST_F(SimulatedPointer, AHostThatComesHearsWhereItStands) {
  EXPECT_TRUE(Drain().empty()) << "it has not moved";
  pointer.Move(0.5, 1);
  pointer.Roll(3);
  Drain();
  pointer.HostLeft();
  pointer.HostCame();
  EXPECT_EQ(Drain(), (Reports{{.y = 65535}})) << "but not what it was told before";
}

TEST_F(SimulatedPointer, TheWatcherSeesEveryHandThatChangesSomething) {
  pointer.Move(0.25, 0.75);
  pointer.Move(0.25, 0.75);
  pointer.Push(1);
  pointer.Push(1);
  pointer.Roll(-2);
  EXPECT_EQ(seen, (std::vector<OperatorAction>{{DevicePort::kPointer, Verb::kMove, 0, 0.25, 0.75},
                                               {DevicePort::kPointer, Verb::kPush, 1, 0, 0},
                                               {DevicePort::kPointer, Verb::kRoll, 0, -2, 0}}));
}

}  // namespace
}  // namespace kaori::sim
