// Which control a person moves: learn mode asks for one, without knowing the device.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "appliance/core/board/line_check.h"
#include "appliance/core/board/snapshot.h"
#include "appliance/core/linecheck/trace.h"
#include "drivers/base/clock.h"

namespace kaori::linecheck {

// Looks at every axis of both sticks and at every dial. A control counts once it has rested for 0.3 s: what
// jitters, creeps or was held when the search began is not what is meant. The first that then moves by three
// tenths of its way (a dial: of half a turn) within two seconds begins half a second of looking, at whose end
// the one that moved furthest is found, if it moved clearly further than every other. The search goes on:
// the next control that is moved is found in its place. One thread; time is an argument and does not go
// back. Allocates nothing.
class ControlFinder {
 public:
  // Begins anew: nothing is found, and nothing has rested.
  void Begin(const board::Snapshot& board, Time now);
  // To be called once a frame.
  void Look(const board::Snapshot& board, Time now);

  // The control that was found last: an axis or a dial, with how far it went in `low` and `high`.
  const std::optional<board::CheckedItem>& found() const { return found_; }
  // Two controls moved alike, and none was found; until the next is.
  bool ambiguous() const { return ambiguous_; }
  // A control that has not rested in the last two seconds though it counts for nothing; the first of them.
  std::optional<board::CheckedItem> restless(Time now) const;
  // When anything was found, or was ambiguous, last.
  Time changed_at() const { return changed_at_; }

 private:
  static constexpr std::size_t kAxes = 6, kDials = 8, kCandidates = 2 * kAxes + kDials;
  struct Candidate {
    board::CheckedItem item;
    Way way;
    bool rested = false;            // It counts.
    Time waits_since{};             // For its rest, while it does not.
    std::optional<Time> left_at{};  // When it left the place where it rested.
  };
  void Wait(Candidate& candidate, float at, Time now) const;
  void Follow(Candidate& candidate, const board::Snapshot& board, Time now) const;
  void Decide(Time now);

  std::array<Candidate, kCandidates> candidates_{};
  std::array<std::int32_t, kDials> counts_{};  // Of the dials when it began.
  std::optional<Time> decides_at_;
  std::optional<board::CheckedItem> found_;
  bool ambiguous_ = false;
  Time changed_at_{};
};

}  // namespace kaori::linecheck
