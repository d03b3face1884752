// Which GPIO lines a box has, for those who ask whether each of them works.
#include <gtest/gtest.h>

#include "appliance/programs/input/line_inputs.h"
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
  LineInputs lines(
      board, board.AcquireWriter<board::Lines>().value(),
      board::Caller::Acquire(board, board::CallWriter::kInput).value(),
      []() -> Result<std::unique_ptr<ports::GpioLines>> { return std::make_unique<RestingLines>(); }, 0b0101);
  EXPECT_EQ(board.Read<board::Lines>().value.wired, 0xFU) << "until it is known all of them may be";
  lines.Step(Time{} + std::chrono::seconds(100));
  EXPECT_EQ(board.Read<board::Lines>().value.wired, 0b0101U);
}

}  // namespace
}  // namespace kaori::input
