// The stage's part in the lesson of a turn: it says on the board what a person turned, and hears the answer.
#pragma once

#include <functional>
#include <optional>

#include "appliance/core/board/board.h"

namespace kaori::input {

class TurnLesson {
 public:
  explicit TurnLesson(const board::Board& board)
      : board_(board), writer_(board.AcquireWriter<board::Learn>().value()) {}

  // That the dial, numbered from 0, went `counts` of the board in one turn. Nothing: kaori-input did not answer within `step`.
  std::optional<board::LearnCall> Keep(std::uint32_t dial, std::uint32_t counts, Time now,
                                       const std::function<void()>& step) {
    const std::uint32_t before = Calls().count;
    writer_.Write({.phase = board::LearnPhase::kKeeping,
                   .found = {.kind = board::CheckedKind::kDial, .device = 2, .number = dial},
                   .turn_counts = counts,
                   .turn_lesson = ++lesson_},
                  now, board::SourceState::kLive);
    step();
    if (Calls().count == before) return std::nullopt;
    return static_cast<board::LearnCall>(Calls().newest[before % board::Calls::kKept].subject);
  }

 private:
  board::Calls Calls() const {
    return board_.Read<board::Calls>(static_cast<int>(board::CallWriter::kInput)).value;
  }

  const board::Board& board_;
  board::Writer<board::Learn> writer_;
  std::uint32_t lesson_ = 0;
};

}  // namespace kaori::input
