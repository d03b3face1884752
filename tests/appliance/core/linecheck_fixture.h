// A line check over a board that a test moves.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "appliance/core/board/lines.h"
#include "appliance/core/linecheck/items.h"
#include "appliance/core/linecheck/line_check.h"
#include "tests/appliance/core/performance_fixture.h"

namespace kaori::linecheck {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
using board::CheckedItem;
using board::CheckedKind;
using board::CheckedState;
using board::SourceState;

inline constexpr std::uint32_t kLeft = 0, kBox = 2;

class LineCheckTest : public ::testing::Test {
 protected:
  LineCheckTest() {
    show_.buttons = {};
    for (const std::size_t button : {0, 1, 2, 6}) show_.buttons[button] = {show::CallKind::kFace, 0};
    board_.surface = {{}, now_, SourceState::kLive};
    for (auto& stick : board_.sticks) stick = {{}, now_, SourceState::kLive};
    board_.keys = {{}, now_, SourceState::kLive};
    board_.lines = {{.active = 1U << unsigned(board::Line::kService)}, now_, SourceState::kLive};
    board_.lips = {{.height = 0.3F, .quality = 1}, now_, SourceState::kLive};
    board_.voice = {{}, now_, SourceState::kLive};
    sound_ = {{}, now_, SourceState::kLive};
  }

  void Begin() { check_.Begin(ItemsFor(show_, devices_, board_, 2), {board_, sound_, 3}, now_); }
  // `move` is called before each frame with the time since the first.
  template <class Move>
  void Run(Duration time, Move move) {
    for (Duration t{}; t < time; t += performance::kFrame) {
      now_ += performance::kFrame;
      ++board_.lips.value.frames;
      board_.voice.value.blocks += 2;
      move(Seconds(t));
      check_.Look({board_, sound_, screens_}, now_);
    }
  }
  void Run(Duration time) {
    Run(time, [](double) {});
  }
  const CheckedItem* Find(CheckedKind kind, std::uint32_t device, std::uint32_t number) const {
    for (const CheckedItem& item : board::ItemsOf(check_.result()))
      if (item.kind == kind && item.device == device && item.number == number) return &item;
    return nullptr;
  }
  CheckedState StateOf(CheckedKind kind, std::uint32_t number = 0, std::uint32_t device = 0) const {
    const CheckedItem* item = Find(kind, device, number);
    EXPECT_NE(item, nullptr);
    return item == nullptr ? CheckedState::kUnseen : item->state;
  }
  CheckedState Axis(show::Control control) const {
    return StateOf(CheckedKind::kAxis, static_cast<std::uint32_t>(control), kLeft);
  }
  // As a person does it in a second: to one end, over to the other, and back.
  static float ThereAndBack(double t) {
    return static_cast<float>(std::sin(2 * std::numbers::pi * std::min(t, 1.0)));
  }

  show::Show show_ = performance::SmallShow();
  std::vector<std::uint8_t> devices_{2, 0, 1};  // As the usual roles say.
  board::Snapshot board_;
  board::Stamped<board::Sound> sound_;
  std::uint32_t screens_ = 3;
  Time now_ = Time{} + 100s;
  LineCheck check_;
};

}  // namespace kaori::linecheck
