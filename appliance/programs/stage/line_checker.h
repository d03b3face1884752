// The line check as the stage runs it: who begins and ends it, and what of the board is left for the show
// meanwhile.
#pragma once

#include <cstdint>
#include <optional>

#include "appliance/core/board/board.h"
#include "appliance/core/board/snapshot.h"
#include "appliance/core/linecheck/line_check.h"
#include "appliance/core/performance/input_events.h"
#include "appliance/core/performance/state.h"
#include "appliance/core/show/show.h"
#include "drivers/ports/scanout.h"

namespace kaori::stage {

// A check begins by a call or by the key Home while the service key is on, and again by either. It ends by a
// call, by Home or Escape, when the service key is turned off, and when nothing has been moved for two
// minutes: a box that was left in the middle of a check must play the show. Enter or a call says that all
// lamps were lit.
//
// While it runs the show gets nothing of what people do: no press, no dial, no stick, no key, no lips and no
// voice, and of calls on the board PANIC and BLACKOUT alone. The face rests, breathes, and does not follow.
class LineChecker {
 public:
  // Borrows the writer.
  explicit LineChecker(board::Writer<board::LineCheck>& writer) : writer_(writer) {}

  // Of one frame. `screen` is null where there is none.
  struct Frame {
    const board::Board& board;
    const board::Snapshot& live;  // What people do,
    const board::Snapshot&
        snapshot;  // and what the show gets, where an evening from the log plays some of them.
    const show::Show& show;
    const performance::State& state;
    const ports::Scanout* screen = nullptr;
    Time now{};
  };
  // Handles the check's calls and keys, takes out of `events` what the show is not to have, and gives what is
  // left of the board for it; that holds until the next call. Writes how the check stands on the board, and a
  // line into the log when it begins and ends. Allocates only in a frame in which a check begins or ends, and
  // once a second while it runs.
  const board::Snapshot& Step(const Frame& frame, performance::InputEvents& events);

  bool running() const { return check_.running(); }
  std::uint32_t lamps(Time now) const { return check_.lamps(now); }

 private:
  enum class Wish : std::uint8_t { kNone, kBegin, kEnd };
  // What was asked for in this frame; the newest counts. Says that the lamps were lit, where somebody says
  // so.
  Wish ReadWish(performance::InputEvents& events, Time now);
  void Begin(const Frame& frame);
  void End(const char* why);
  void Look(const Frame& frame);
  // Of the outputs of the screen, which are asked for once a second.
  std::uint32_t ScreensOf(const Frame& frame);
  // Takes out of what is left of the board all that people move.
  void Withhold();

  board::Writer<board::LineCheck>& writer_;
  linecheck::LineCheck check_;
  board::Snapshot left_;  // Of the board, in a frame in which a check runs.
  board::Stamped<board::Sound> sound_;
  std::uint32_t screens_ = 0;
  std::size_t screen_count_ = 0;
  std::optional<Time> screens_at_;
};

}  // namespace kaori::stage
