#include "appliance/input/line_desk.h"

#include "drivers/base/log.h"

namespace kaori::input {
namespace {

constexpr int kEdgesAtOnce = 256;  // A line that bounces for ever must not keep the others waiting.

}  // namespace

LineDesk::LineDesk(const board::Board& board, board::Writer<board::Lines> writer, ports::GpioLines* lines)
    : writer_(std::move(writer)), lines_(lines), value_(board.Read<board::Lines>().value) {}

void LineDesk::Step(Time now) {
  if (lines_ == nullptr) return;
  if (!begun_) Begin(now);
  for (int i = 0; lines_ != nullptr && i < kEdgesAtOnce; ++i) {
    const auto edge = lines_->ReadEdge();
    if (edge) {
      TakeEdge(*edge);
      continue;
    }
    if (edge.error().cause != std::errc::resource_unavailable_try_again) Lose(edge.error(), now);
    return;
  }
}

void LineDesk::Begin(Time now) {
  begun_ = true;
  const auto levels = lines_->Levels();
  if (!levels) return Lose(levels.error(), now);
  value_.active = *levels;
  Write(now, board::SourceState::kLive);
}

void LineDesk::TakeEdge(const ports::GpioEdge& edge) {
  if (edge.line >= 32) return;
  const std::uint32_t bit = 1U << edge.line;
  const bool was_active = (value_.active & bit) != 0;
  if (edge.active && !was_active && edge.line < value_.pushes.size()) ++value_.pushes[edge.line];
  value_.active = edge.active ? value_.active | bit : value_.active & ~bit;
  Write(edge.at, board::SourceState::kLive);
}

void LineDesk::Lose(const Error& error, Time now) {
  Log("{}; the lines are released", error.message());
  lines_ = nullptr;
  value_.active = 0;
  Write(now, board::SourceState::kStale);
}

void LineDesk::Write(Time at, board::SourceState source) {
  writer_.Write(value_, at, source);
}

}  // namespace kaori::input
