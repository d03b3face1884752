// The contract of ports::GpioLines. That no call blocks shows in that the tests end.
#pragma once

#include <gtest/gtest.h>

#include "drivers/base/clock.h"
#include "drivers/ports/gpio_lines.h"
#include "tests/contracts/contract.h"

namespace kaori::contracts {

// Two inputs and one output, and the switches and the lamp that are wired to them.
class GpioSubject : public AnySubject {
 public:
  virtual ports::GpioLines& lines() = 0;
  virtual void Switch(std::uint32_t line, bool active) = 0;
  // Whether the lamp is lit, or unlit, within the time that a thread may take.
  virtual bool LampBecomes(bool lit) = 0;
  virtual void Unplug() = 0;

  ManualClock clock;
};

class GpioLinesContract : public Contract<GpioSubject> {
 protected:
  ports::GpioLines& lines() { return subject_->lines(); }

  // The next edge, awaited as a program does: a descriptor may wake the program for nothing.
  Result<ports::GpioEdge> Await() {
    auto edge = lines().ReadEdge();
    for (int n = 0; n < 50 && Cause(edge) == std::errc::resource_unavailable_try_again; ++n) {
      if (!IsReadable(lines().pollable(), kLongestWait_ms)) break;
      edge = lines().ReadEdge();
    }
    return edge;
  }
};

TEST_P(GpioLinesContract, LevelsTellWhichInputsAreActive) {
  const auto none = lines().Levels();
  ASSERT_TRUE(none) << none.error().message();
  EXPECT_EQ(*none, 0U);
  subject_->Switch(1, true);
  ASSERT_TRUE(Await());
  EXPECT_EQ(*lines().Levels(), 2U);
}

TEST_P(GpioLinesContract, SaysTryAgainWhileThereIsNoEdge) {
  EXPECT_EQ(Cause(lines().ReadEdge()), std::errc::resource_unavailable_try_again);
}

TEST_P(GpioLinesContract, GivesEachEdgeOnceWithItsLineItsStateAndItsTime) {
  for (const std::uint32_t line : {0U, 1U}) {
    for (const bool active : {true, false}) {
      subject_->clock.Advance(std::chrono::milliseconds(100));
      subject_->Switch(line, active);
      const auto edge = Await();
      ASSERT_TRUE(edge) << edge.error().message();
      EXPECT_EQ(edge->line, line);
      EXPECT_EQ(edge->active, active);
      EXPECT_EQ(edge->at, subject_->clock.now());
      EXPECT_EQ(Cause(lines().ReadEdge()), std::errc::resource_unavailable_try_again);
    }
  }
}

TEST_P(GpioLinesContract, DrivesItsOutputAndRefusesOneThatItDoesNotHave) {
  EXPECT_TRUE(subject_->LampBecomes(false)) << "outputs start inactive";
  ASSERT_TRUE(lines().Drive(0, true));
  EXPECT_TRUE(subject_->LampBecomes(true));
  ASSERT_TRUE(lines().Drive(0, false));
  EXPECT_TRUE(subject_->LampBecomes(false));
  EXPECT_EQ(Cause(lines().Drive(1, true)), std::errc::invalid_argument);
}

TEST_P(GpioLinesContract, SaysNoSuchDeviceEverAfterItsChipWasUnplugged) {
  subject_->Unplug();
  EXPECT_EQ(Cause(Await()), std::errc::no_such_device);
  for (int n = 0; n < 2; ++n) {
    EXPECT_EQ(Cause(lines().Levels()), std::errc::no_such_device);
    EXPECT_EQ(Cause(lines().Drive(0, true)), std::errc::no_such_device);
    EXPECT_EQ(Cause(Await()), std::errc::no_such_device);
  }
}

}  // namespace kaori::contracts
