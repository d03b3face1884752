// A fixture: foot switches on a GPIO chip that can be pulled, and the lines of the board.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "appliance/core/board/lines.h"
#include "appliance/programs/input/line_inputs.h"
#include "tests/appliance/core/board_file.h"

namespace kaori::input {

// The contacts of foot switches, and a chip that can be pulled; it outlives the lines.
struct FakeChip {
  std::uint32_t levels = 0;
  std::deque<ports::GpioEdge> edges;
  int failing_edges = 0, failing_levels = 0;  // So many transfers fail.
  bool there = true;
  int fd = -1;
  int opened = 0;
  Duration answers_after{};  // How long an opening blocks.
  std::vector<bool> lamp;    // What output 0 was told.
  bool lamp_waits = false;   // It cannot be told now.
};

class FakeLines final : public ports::GpioLines {
 public:
  explicit FakeLines(FakeChip& chip) : chip_(chip) {}
  int pollable() const override { return chip_.fd; }
  Result<std::uint32_t> Levels() override {
    if (!chip_.there) return Fail(std::errc::no_such_device, "read lines");
    if (chip_.failing_levels > 0) return --chip_.failing_levels, Fail(std::errc::io_error, "read lines");
    return chip_.levels;
  }
  Result<ports::GpioEdge> ReadEdge() override {
    if (!chip_.there) return Fail(std::errc::no_such_device, "read lines");
    if (chip_.failing_edges > 0) return --chip_.failing_edges, Fail(std::errc::io_error, "read lines");
    if (chip_.edges.empty()) return Fail(std::errc::resource_unavailable_try_again, "read lines");
    const ports::GpioEdge edge = chip_.edges.front();
    chip_.edges.pop_front();
    return edge;
  }
  Result<void> Drive(std::uint32_t, bool lit) override {
    if (chip_.lamp_waits) return Fail(std::errc::resource_unavailable_try_again, "drive a line");
    chip_.lamp.push_back(lit);
    return {};
  }

 private:
  FakeChip& chip_;
};

class LinesFixture : public ::testing::Test {
 protected:
  LinesFixture() : board_(file_.Open()) { Start(); }

  void Start() {
    service_.reset();
    service_.emplace(board_, board_.AcquireWriter<board::Lines>().value(),
                     board::Caller::Acquire(board_, board::CallWriter::kInput).value(), Opener(), clock_);
    service_->Step(clock_.now());
  }
  ports::GpioOpener Opener() {
    return [this]() -> Result<std::unique_ptr<ports::GpioLines>> {
      ++chip_.opened;
      clock_.Advance(chip_.answers_after);
      if (!chip_.there) return Fail(std::errc::no_such_device, "open GPIO chip");
      return std::make_unique<FakeLines>(chip_);
    };
  }
  // A contact changes now, and the kernel queues the edge.
  void Contact(std::uint32_t line, bool active) {
    chip_.levels = active ? chip_.levels | (1U << line) : chip_.levels & ~(1U << line);
    chip_.edges.push_back({clock_.now(), line, active});
  }
  void Wait(Duration time) {
    for (Duration t{}; t < time; t += std::chrono::milliseconds(1)) {
      clock_.Advance(std::chrono::milliseconds(1));
      service_->Step(clock_.now());
    }
  }
  board::Stamped<board::Lines> Read() const { return board_.Read<board::Lines>(); }

  board::BoardFile file_;
  board::Board board_;
  FakeChip chip_;
  ManualClock clock_;
  std::optional<LineInputs> service_;
};

}  // namespace kaori::input
