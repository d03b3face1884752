#include "appliance/programs/input/line_inputs.h"

#include <algorithm>

#include "appliance/core/board/lines.h"
#include "drivers/base/log.h"
#include "drivers/base/long_call.h"

namespace kaori::input {
namespace {

constexpr int kEdgesAtOnce = 256;  // A line that bounces without end must not keep the others waiting.
// How often lines that are not there are asked for.
constexpr Duration kLineRetry = std::chrono::seconds(1);
// One failed transfer is harmless on USB; so many in a row are a dead chip. Two that are further apart than this are
// not in a row: lines that are polled tell only every 40 ms.
constexpr int kFaultsToLoseLines = 25;
constexpr Duration kFaultsApart = std::chrono::seconds(1);

}  // namespace

using board::SourceState;

LineInputs::LineInputs(const board::Board& board, board::Writer<board::Lines> writer, board::Caller caller,
                       ports::GpioOpener open, const Clock& clock, std::uint32_t wired)
    : writer_(std::move(writer)),
      caller_(std::move(caller)),
      open_(std::move(open)),
      clock_(clock),
      value_(board.Read<board::Lines>().value),
      source_(board.Read<board::Lines>().source) {
  value_.wired = wired;
}

// Edges before levels that settle by time: a change within the bounce of an earlier one is settled here once
// the line has been quiet long enough.
void LineInputs::Step(Time now) {
  if (open_ && !lines_ && now >= retry_at_) Open(now);
  if (lines_) HandleEdges(now);
  if (lines_) SettleAll(now);
}

// A chip that is missing is asked for every second and logged once for each cause, since a box without foot
// switches is a box all the same. One on USB that does not answer blocks for seconds, and all input with it.
void LineInputs::Open(Time now) {
  ExpectLongCall();
  const Time asked = clock_.now();
  auto lines = open_();
  const auto levels = lines ? (*lines)->Levels() : tl::unexpected(lines.error());
  if (lines && !levels) lines->reset();
  const Time answered = clock_.now();
  retry_at_ = answered + PauseAfter(answered - asked, kLineRetry);
  if (!levels) {
    const std::errc before = std::exchange(logged_, levels.error().cause);
    if (before != logged_)
      LogWarning("{}; the show goes on without the GPIO lines, which are tried again",
                 levels.error().message());
    // Pulled while the program was away: the second failure says that it is not only late.
    if (before != std::errc{} && source_ == SourceState::kLive) Release(now);
    return;
  }
  logged_ = {};
  lines_ = std::move(*lines);
  shown_tally_.reset();
  ++generation_;
  faults_ = 0;
  has_edges_ = false;
  Begin(*levels, now);
}

// The switches as they stand when the lines appear. After a restart (the section is still live) differences
// are pushes that happened meanwhile; after an absence they are not.
void LineInputs::Begin(std::uint32_t levels, Time now) {
  levels_ = levels;
  if (source_ != SourceState::kLive)
    value_.active = levels_;  // What is held when the lines appear was not pushed.
  SettleAll(now);
  Write(now, SourceState::kLive);
}

// An edge carries the kernel's time of the interrupt, which is the stamp on the board. Edges of lines that
// the board does not have are passed over.
void LineInputs::HandleEdges(Time now) {
  for (int i = 0; i < kEdgesAtOnce; ++i) {
    const auto edge = lines_->ReadEdge();
    if (!edge) {
      if (edge.error().cause != std::errc::resource_unavailable_try_again)
        return HandleFault(edge.error(), now);
      if (has_edges_) ReadLevels(now);
      return;
    }
    has_edges_ = true;
    if (edge->line >= changed_at_.size()) continue;
    const std::uint32_t bit = 1U << edge->line;
    levels_ = edge->active ? levels_ | bit : levels_ & ~bit;
    Settle(edge->line, std::min(edge->at, now));
  }
}

// The kernel queues 16 edges for each line (linux/gpio.h, event_buffer_size) and drops later ones. Without a
// look at the levels a dropped release would leave a foot switch held.
void LineInputs::ReadLevels(Time now) {
  const auto levels = lines_->Levels();
  if (!levels) return HandleFault(levels.error(), now);
  faults_ = 0;
  has_edges_ = false;
  levels_ = *levels;
}

// What was not read is read at the next step: the kernel, or the line that is polled, still has it.
void LineInputs::HandleFault(const Error& error, Time now) {
  if (now - fault_at_ > kFaultsApart) faults_ = 0;
  fault_at_ = now;
  if (error.cause == std::errc::no_such_device || ++faults_ == kFaultsToLoseLines) HandleLoss(error, now);
}

// Also lines without an edge since the last step: their time of holding may be over now.
void LineInputs::SettleAll(Time now) {
  for (std::uint32_t line = 0; line < changed_at_.size(); ++line) Settle(line, now);
}

// Debouncing: the first edge counts at once, so that GO has no delay, and the line is then held for kBounce
// whatever it does. Where it ends up in the other state, SettleAll finds the difference after that time.
void LineInputs::Settle(std::uint32_t line, Time at) {
  const std::uint32_t bit = 1U << line;
  if (((levels_ ^ value_.active) & bit) == 0 || at - changed_at_[line] < kBounce) return;
  changed_at_[line] = at;
  value_.active ^= bit;
  const bool pushed = (value_.active & bit) != 0;
  if (pushed && line < value_.pushes.size()) ++value_.pushes[line];
  Write(at, SourceState::kLive);
  const auto call = board::CueCallOf(static_cast<board::Line>(line));
  if (pushed && call)
    caller_.Make({.at = at,
                  .verb = board::CallVerb::kCue,
                  .subject = *call,
                  .source = board::CallSource::kFootSwitch});
}

// A chip that is gone is noticed when it is read. Where no output is wired the driver refuses, and that is
// ignored as well.
void LineInputs::SetTally(bool lit) {
  if (!lines_ || shown_tally_ == lit) return;
  const auto driven = lines_->Drive(0, lit);
  const bool later = !driven && driven.error().cause == std::errc::resource_unavailable_try_again;
  if (!later) shown_tally_ = lit;
}

// Whoever watches the chip's descriptor learns from the generation that it is closed.
void LineInputs::HandleLoss(const Error& error, Time now) {
  LogWarning("{}; all GPIO lines count as released", error.message());
  ExpectLongCall();
  lines_.reset();
  ++generation_;
  retry_at_ = clock_.now() + kLineRetry;
  Release(now);
}

// A foot switch that is gone must not stay trodden. The stage decides what lost lines mean for a blackout.
void LineInputs::Release(Time now) {
  levels_ = value_.active = 0;
  Write(now, SourceState::kStale);
}

void LineInputs::Write(Time at, SourceState source) {
  source_ = source;
  writer_.Write(value_, at, source);
}

}  // namespace kaori::input
