// Measures how old the lips and the voice are when the frame that shows them is presented.
#pragma once

#include <cstdint>

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/state.h"
#include "drivers/base/clock.h"
#include "drivers/ports/scanout.h"

namespace kaori::stage {

// Pure: time is in the arguments. One frame at a time is on its way to the screen. The lip program delays the
// voice by what is measured here (StageStatus::mouth_lag), so that the loudspeaker is in time with the mouth.
// One thread; allocates nothing.
class MouthClock {
 public:
  // To be called when frame `frame` has been handed to the screen; it shows what stood on `board`.
  void Present(std::uint64_t frame, const board::Snapshot& board, const performance::State& state);

  // To be called when it is presented; of other frames nothing is known. Ages are those at flip.at, the
  // beginning of scan-out.
  void Flip(const ports::Flip& flip);

  // Writes the means over what was presented since the last call. To be called about once a second.
  void Report(board::StageStatus& into);

 private:
  // A sum and a count over one period of Report; durations in nanoseconds do not overflow within it.
  struct Mean {
    Duration sum{};
    std::int64_t count = 0;
    void Add(Duration age);
    Duration mean() const { return count > 0 ? sum / count : Duration{}; }
  };
  std::uint64_t frame_ = 0;
  Time lips_at_{}, voice_at_{};  // What the frame on its way shows; Time{}: none.
  performance::State shown_;     // The mouth that it shows.
  Mean lips_, voice_, mouth_;
};

}  // namespace kaori::stage
