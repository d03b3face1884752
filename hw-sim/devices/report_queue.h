// Changes on their way into reports: merged within a millisecond, but never so that an edge is lost.
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <optional>

#include "drivers/base/clock.h"

namespace kaori::sim {

// How fast a real device at full speed can report: once in a frame of USB (USB 2.0, 5.7.4).
inline constexpr Duration kReportPeriod = std::chrono::milliseconds(1);

// A host that is stopped for good must not eat memory: beyond this many reports, edges merge after all.
inline constexpr std::size_t kMaxWaitingReports = 1024;

// State is the report as a struct. `at_rest_next` makes the state from which the next report starts: what a
// report says once, such as turns, is 0 in it, what stands, such as buttons, is kept. A device changes the
// state that waits, and a link takes it out when it is due. One thread. A state in which nothing happens has
// no report: a device at rest is silent, as real ones with an idle rate of 0 are (HID 1.11, 7.2.4).
template <class State>
class ReportQueue {
 public:
  // The function must be pure; it is called for each report that is made.
  explicit ReportQueue(State (*at_rest_next)(const State&)) : next_from_(at_rest_next) {}

  // The state to change. `would_merge(last, back)` says whether the change would wipe out one that
  // waits: then the state begins a report of its own. The reference holds until the next call.
  template <class WouldMerge>
  State& Change(Time now, WouldMerge would_merge) {
    if (waiting_.empty()) {
      Append(now);
    } else if (hosted_ && waiting_.size() < kMaxWaitingReports) {
      // What the report before the last one says, which may have left already.
      const State& before = waiting_.size() > 1 ? waiting_[waiting_.size() - 2].state : sent_;
      if (would_merge(before, waiting_.back().state)) Append(now);
    }
    return waiting_.back().state;
  }

  // When the next report may leave; nothing while none waits.
  std::optional<Time> next_due() const {
    if (waiting_.empty()) return std::nullopt;
    return waiting_.front().due;
  }

  // The oldest report that is due at `now`; one in kReportPeriod at most.
  std::optional<State> Next(Time now) {
    if (waiting_.empty() || waiting_.front().due > now) return std::nullopt;
    sent_ = waiting_.front().state;
    free_at_ = now + kReportPeriod;
    waiting_.pop_front();
    return sent_;
  }

  // The newest state, sent or not.
  const State& newest() const { return waiting_.empty() ? sent_ : waiting_.back().state; }

  // Whether a host listens: without one all changes share one report.
  void set_hosted(bool hosted) { hosted_ = hosted; }
  // Drops what waits; what stands, stands.
  void Forget() {
    sent_ = next_from_(newest());
    waiting_.clear();
  }

 private:
  // A report that waits. Due times rise by kReportPeriod at least.
  struct Waiting {
    // No earlier than that: a link may come later.
    Time due;
    State state;
  };

  // Adds a report that is due no sooner than its place in the line allows.
  void Append(Time now) {
    // Reports keep their distance also when they gather faster than they may leave.
    const Time after_last = waiting_.empty() ? free_at_ : waiting_.back().due + kReportPeriod;
    waiting_.push_back({std::max(now, after_last), next_from_(newest())});
  }

  State (*next_from_)(const State&);
  // The state that the last report said.
  State sent_{};
  // The oldest first; the last one may still change.
  std::deque<Waiting> waiting_;
  // When the next report may leave, after the last one.
  Time free_at_{};
  // Nobody reads: one report gathers all.
  bool hosted_ = false;
};

}  // namespace kaori::sim
