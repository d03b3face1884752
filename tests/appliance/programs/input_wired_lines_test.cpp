// Which GPIO lines a box has, for those who ask whether each of them works.
#include <gtest/gtest.h>

#include "appliance/programs/input/line_inputs.h"
#include "appliance/programs/input/line_roles.h"
#include "tests/appliance/core/board_file.h"

namespace kaori::input {
namespace {

// Nobody touches its switches.
class RestingLines final : public ports::GpioLines {
 public:
  int pollable() const override { return -1; }
  Result<std::uint32_t> Levels() override { return 0U; }
  Result<ports::GpioEdge> ReadEdge() override {
    return Fail(std::errc::resource_unavailable_try_again, "read an edge");
  }
  Result<void> Drive(std::uint32_t, bool) override { return {}; }
};

TEST(WiredLines, AreToldOnTheBoard) {
  const board::BoardFile file;
  const board::Board board = file.Open();
  const ManualClock clock;
  LineInputs lines(
      board, board.AcquireWriter<board::Lines>().value(),
      board::Caller::Acquire(board, board::CallWriter::kInput).value(),
      []() -> Result<std::unique_ptr<ports::GpioLines>> { return std::make_unique<RestingLines>(); }, clock,
      0b0101);
  EXPECT_EQ(board.Read<board::Lines>().value.wired, board::kEveryLine)
      << "until it is known all of them may be";
  lines.Step(Time{} + std::chrono::seconds(100));
  EXPECT_EQ(board.Read<board::Lines>().value.wired, 0b0101U);
}

TEST(LineRolesOf, AChipAreNamedAndNeedNotAllBeThere) {
  const auto all = ParseLineRoles("go=0,blackout=1,service=2,presence=3,tally=4").value();
  for (std::uint32_t n = 0; n < 4; ++n) EXPECT_EQ(all.inputs[n], n);
  EXPECT_EQ(all.tally, 4U);
  const auto pushed = ParseLineRoles("back=5,panic=6").value();
  EXPECT_EQ(pushed.inputs[static_cast<std::size_t>(board::Line::kBack)], 5U);
  EXPECT_EQ(pushed.inputs[static_cast<std::size_t>(board::Line::kPanic)], 6U);
  const auto some = ParseLineRoles("tally=0,presence=17").value();
  EXPECT_EQ(some.tally, 0U);
  EXPECT_FALSE(some.inputs[0]);
  EXPECT_EQ(some.inputs[3], 17U);
}

TEST(LineRolesOf, AChipAreRefusedWhereTheyMakeNoSense) {
  for (const char* wrong : {"", "go", "go=", "go=x", "go=-1", "go=64", "go=0,", ",go=0", "stop=1",
                            "go=0,go=1", "go=1,tally=1", "go=0 ", "go=0x1"})
    EXPECT_FALSE(ParseLineRoles(wrong)) << wrong;
}

// Otherwise the program would wake for a closed descriptor again and again.
}  // namespace
}  // namespace kaori::input
