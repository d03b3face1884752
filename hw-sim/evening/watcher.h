// Looks, while an evening plays, whether what its running order expects comes in time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "appliance/core/board/board.h"
#include "appliance/core/show/show.h"
#include "hw-sim/evening/running_order.h"
#include "hw-sim/evening/verdict.h"

namespace kaori::sim {

// Borrows all three, which outlive it. One thread.
class Watcher {
 public:
  // `file` is the running order's name, for sentences.
  Watcher(const RunningOrder& order, const show::Show& show, std::string file)
      : order_(order),
        show_(show),
        file_(std::move(file)),
        failed_(order.faults.size()),
        looked_(failed_.size()) {}

  // Begins what is expected from now on: to be called before anything happens at this moment. `now` is since
  // the beginning.
  void Begin(Duration now, const board::Board& board, const ShowSeen& seen);
  // Ends what has come, and what has not come in time.
  void Look(Duration now, const board::Board& board, const ShowSeen& seen);
  // Something of a fault, or else of the evening, is wrong for another reason.
  void Fail(int line, int fault, const std::string& what);

  // Writes cues, faults and what is wrong by `now`.
  void Report(Duration now, Verdict& into) const;

 private:
  // An expectation whose time has begun and is not over, with the counters as they stood at its beginning.
  struct Open {
    const Expectation* expectation;
    Since since;
  };
  // True: it is over, whichever way.
  bool IsOver(const Open& open, Duration now, const board::Board& board, const ShowSeen& seen);
  static bool IsCall(const Condition& condition);

  const RunningOrder& order_;
  const show::Show& show_;
  std::string file_;
  std::size_t next_ = 0;
  std::vector<Open> open_;
  // By fault: something of it is wrong; something of it was seen.
  std::vector<bool> failed_, looked_;
  std::uint64_t cues_ = 0, missed_ = 0;
  std::vector<std::string> wrong_;
};

}  // namespace kaori::sim
