// What the contract of GpioLines leaves to its implementations: several
// lines at a time, lines that are not wired, and chips without interrupts.
#include <gtest/gtest.h>
#include <poll.h>

#include <tuple>
#include <vector>

#include "drivers/gpio/chip_lines.h"
#include "tests/drivers/gpio_fake_chip.h"

namespace kaori::gpio {
namespace {

class ChipLinesTest : public ::testing::Test {
 protected:
  Result<std::unique_ptr<ChipLines>> Request(const Wiring& wiring) {
    return ChipLines::Request(std::make_unique<tests::FakeChip>(chip_, clock_), wiring);
  }
  static Time At(int ms) { return Time{} + std::chrono::milliseconds(ms); }

  ManualClock clock_;
  tests::FakeChipState chip_;
};

TEST_F(ChipLinesTest, GivesTheEdgesOfAllLinesInTheOrderOfTime) {
  const auto lines = Request({.inputs = {{.offset = 7}, {.offset = 3}}}).value();
  const auto readable = [&] {
    pollfd state{.fd = lines->pollable(), .events = POLLIN, .revents = 0};
    return ::poll(&state, 1, 0) > 0;
  };
  chip_.Switch(7, true, At(20));
  chip_.Switch(7, false, At(40));
  chip_.Switch(3, true, At(10));
  chip_.Switch(3, false, At(30));
  for (const auto& [ms, line, active] : std::vector<std::tuple<int, std::uint32_t, bool>>{
           {10, 1, true}, {20, 0, true}, {30, 1, false}, {40, 0, false}}) {
    EXPECT_TRUE(readable());
    const auto edge = lines->ReadEdge();
    ASSERT_TRUE(edge) << edge.error().message();
    EXPECT_EQ(edge->at, At(ms));
    EXPECT_EQ(edge->line, line);
    EXPECT_EQ(edge->active, active);
  }
  EXPECT_FALSE(readable());
}

TEST_F(ChipLinesTest, ALineThatIsNotWiredIsNeverRequestedAndNeverActive) {
  const auto lines = Request({.inputs = {{.wired = false}, {.offset = 3}}});
  ASSERT_TRUE(lines) << lines.error().message();
  EXPECT_EQ(chip_.requested, 1);
  chip_.Switch(3, true, At(1));
  EXPECT_EQ(*(*lines)->Levels(), 2U);
  EXPECT_EQ((*lines)->ReadEdge()->line, 1U);
}

TEST_F(ChipLinesTest, EveryLineIsRequestedOrNone) {
  EXPECT_FALSE(Request({.inputs = {{.offset = 1}, {.offset = 99}}}));
  EXPECT_EQ(chip_.requested, 0);
  EXPECT_FALSE(Request({.inputs = std::vector<LineWiring>(33)}));
}

TEST_F(ChipLinesTest, APolledSwitchThatWasClosedBeforeItsLevelWasReadIsNoEdge) {
  chip_.has_interrupts = false;
  const auto lines = Request({.inputs = {{.offset = 3}}}).value();
  chip_.Switch(3, true, At(1));
  EXPECT_EQ(*lines->Levels(), 1U);
  for (int polls = 0; polls < 2; ++polls) {
    pollfd state{.fd = lines->pollable(), .events = POLLIN, .revents = 0};
    EXPECT_EQ(::poll(&state, 1, 10'000), 1);
    EXPECT_FALSE(lines->ReadEdge());
  }
}

TEST(GpioChip, ThatIsNotThereIsNoSuchDevice) {
  const ManualClock clock;
  const auto lines = OpenLines("gpiochip-of-nobody", {}, clock);
  ASSERT_FALSE(lines);
  EXPECT_EQ(lines.error().cause, std::errc::no_such_device);
  EXPECT_EQ(lines.error().attempt, "open GPIO chip gpiochip-of-nobody");
}

}  // namespace
}  // namespace kaori::gpio
