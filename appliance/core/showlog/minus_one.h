// An evening once more, without one of its operators: who plays instead is live.
#pragma once

#include <bitset>
#include <string_view>

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/state.h"
#include "appliance/core/show/show.h"
#include "appliance/core/showlog/log_file.h"
#include "appliance/core/showlog/replay.h"
#include "drivers/base/result.h"

namespace kaori::showlog {

// One thread. Reads no file once it is open, and allocates nothing in Lay.
class MinusOne {
 public:
  // The evening from `at` on, without what was done on the device of `role` (a stick, or the dial box with
  // its buttons). A role "lips", where the show calls none so, is that of lips and voice. `log` and `show`
  // outlive it; the show is the one that was played, with the roles of the box. Takes as long as playing up
  // to half a minute without drawing. Errors: kInput: there is no such role, nobody played it then, or the
  // log has nothing at that time.
  static Result<MinusOne> Open(const LogFile& log, const show::Show& show, Time at, std::string_view role);

  // The evening's first frame is presented at this time: what the show stood in before it. What that has seen
  // are the counters of the evening's board; those of a live dial box are taken as they are found. To be
  // called once, before Lay.
  const performance::State& Begin(Time presented_at);

  // Lays the evening over the live board of the frame that is presented at this time. What is laid keeps its
  // age. False where the evening is over or its log has a gap: nothing is laid then, and the board's counters
  // are others than before: what has been seen is what the live board says (performance::SeenOn).
  bool Lay(Time presented_at, board::Snapshot& board);

 private:
  // By the order of ForSections: true for what is live.
  using Sections = std::bitset<FrameTimes::kSections>;

  MinusOne(const LogFile& log, const show::Show& show) : replay_(log, show) {}
  static Result<Sections> LiveSections(const show::Show& show, const performance::State& state,
                                       std::string_view role);

  Replay replay_;  // Has read the frame that is laid next, and made those before the beginning alone.
  performance::State state_;  // Before that beginning.
  Sections live_;
  board::Snapshot laid_;
  Duration later_{};  // Of this play than the evening.
  bool over_ = false;
};

}  // namespace kaori::showlog
