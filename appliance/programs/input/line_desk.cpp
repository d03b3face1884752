#include "appliance/programs/input/line_desk.h"

#include <algorithm>

#include "drivers/base/log.h"

namespace kaori::input {
namespace {

constexpr int kEdgesAtOnce = 256;  // A line that bounces for ever must not keep the others waiting.
constexpr Duration kLineDeskRetry = std::chrono::seconds(1);

}  // namespace

using board::SourceState;

LineDesk::LineDesk(const board::Board& board, board::Writer<board::Lines> writer, ports::GpioOpener open)
    : writer_(std::move(writer)),
      open_(std::move(open)),
      value_(board.Read<board::Lines>().value),
      source_(board.Read<board::Lines>().source) {}

void LineDesk::Step(Time now) {
  if (open_ && !lines_ && now >= retry_at_) Open(now);
  if (lines_) HandleEdges(now);
  if (lines_) SettleAll(now);
}

void LineDesk::Open(Time now) {
  retry_at_ = now + kLineDeskRetry;
  auto lines = open_();
  if (!lines) {
    if (std::exchange(logged_, lines.error().cause) != lines.error().cause)
      LogWarning("{}; playing without these lines, and trying again", lines.error().message());
    return;
  }
  logged_ = {};
  lines_ = std::move(*lines);
  tally_.reset();
  ++generation_;
  Begin(now);
}

void LineDesk::Begin(Time now) {
  const auto levels = lines_->Levels();
  if (!levels) return Lose(levels.error(), now);
  told_ = *levels;
  if (source_ != SourceState::kLive) value_.active = told_;  // What is held as the lines come was not pushed.
  SettleAll(now);
  Write(now, SourceState::kLive);
}

void LineDesk::HandleEdges(Time now) {
  bool any = false;
  for (int i = 0; i < kEdgesAtOnce; ++i) {
    const auto edge = lines_->ReadEdge();
    if (!edge) {
      if (edge.error().cause != std::errc::resource_unavailable_try_again) return Lose(edge.error(), now);
      if (any) LookAtLevels(now);
      return;
    }
    any = true;
    if (edge->line >= changed_at_.size()) continue;
    const std::uint32_t bit = 1U << edge->line;
    told_ = edge->active ? told_ | bit : told_ & ~bit;
    Settle(edge->line, std::min(edge->at, now));
  }
}

// The kernel keeps 16 edges of a line and drops later ones: without this a dropped release would hold a foot
// switch down.
void LineDesk::LookAtLevels(Time now) {
  const auto levels = lines_->Levels();
  if (!levels) return Lose(levels.error(), now);
  told_ = *levels;
}

void LineDesk::SettleAll(Time now) {
  for (std::uint32_t line = 0; line < changed_at_.size(); ++line) Settle(line, now);
}

void LineDesk::Settle(std::uint32_t line, Time at) {
  const std::uint32_t bit = 1U << line;
  if (((told_ ^ value_.active) & bit) == 0 || at - changed_at_[line] < kBounce) return;
  changed_at_[line] = at;
  value_.active ^= bit;
  if ((value_.active & bit) != 0 && line < value_.pushes.size()) ++value_.pushes[line];
  Write(at, SourceState::kLive);
}

// A lamp that cannot be lit is none: a chip that is gone says so when it is read.
void LineDesk::Light(bool tally) {
  if (!lines_ || tally_ == tally) return;
  tally_ = tally;
  static_cast<void>(lines_->Drive(0, tally));
}

void LineDesk::Lose(const Error& error, Time now) {
  LogWarning("{}; the lines are released", error.message());
  lines_.reset();
  ++generation_;
  retry_at_ = now + kLineDeskRetry;
  told_ = value_.active = 0;
  Write(now, SourceState::kStale);
}

void LineDesk::Write(Time at, SourceState source) {
  source_ = source;
  writer_.Write(value_, at, source);
}

}  // namespace kaori::input
