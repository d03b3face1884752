#include "hw-sim/evening/watcher.h"

#include <fmt/format.h>

namespace kaori::sim {

// A cue that is called, or a call that must be refused.
// Only such conditions count as cues of the evening: others say how the box stands.
bool Watcher::IsCall(const Condition& condition) {
  return condition.kind == Condition::Kind::kCue || condition.kind == Condition::Kind::kRefused;
}

// A cue that is on before it is called says nothing of the call.
void Watcher::Begin(Duration now, const board::Board& board, const ShowSeen& seen) {
  for (; next_ < order_.expectations.size() && order_.expectations[next_].at <= now; ++next_) {
    const Expectation& expectation = order_.expectations[next_];
    const Open open{&expectation, SinceNow(board, seen)};
    open_.push_back(open);
    if (expectation.keep || !IsCall(expectation.condition)) continue;
    ++cues_;
    if (expectation.condition.kind != Condition::Kind::kCue ||
        !Holds(expectation.condition, open.since, board, seen))
      continue;
    ++missed_;
    Fail(expectation.line, expectation.fault, expectation.condition.words + " is on before it is called");
    open_.pop_back();
  }
}

// Every open expectation is looked at once a step; there are few at a time.
void Watcher::Look(Duration now, const board::Board& board, const ShowSeen& seen) {
  std::erase_if(open_, [&](const Open& open) { return IsOver(open, now, board, seen); });
}

bool Watcher::IsOver(const Open& open, Duration now, const board::Board& board, const ShowSeen& seen) {
  const Expectation& expectation = *open.expectation;
  const bool holds = Holds(expectation.condition, open.since, board, seen);
  const bool in_time = now < expectation.at + expectation.time;
  if (holds == expectation.keep && in_time)
    return false;  // To be kept and kept, or expected and not there yet.
  // From here on the expectation is over, and its fault has been looked at, whatever came of it.
  if (expectation.fault != kNoFault) looked_[static_cast<std::size_t>(expectation.fault)] = true;
  if (holds) return true;
  if (!expectation.keep && IsCall(expectation.condition)) ++missed_;
  const std::string instead = Instead(expectation.condition, board, show_);
  Fail(expectation.line, expectation.fault,
       fmt::format("{} {} {:.2f} s{}{}", expectation.condition.words,
                   expectation.keep ? "was not kept for" : "did not come within", Seconds(expectation.time),
                   instead.empty() ? "" : "; ", instead));
  return true;
}

// The form FILE:LINE is the one that editors open.
void Watcher::Fail(int line, int fault, const std::string& what) {
  if (fault != kNoFault) failed_[static_cast<std::size_t>(fault)] = true;
  wrong_.push_back(fmt::format("{}:{}: {}", file_, line, what));
}

// A fault of which nothing was expected is not answered. One that was not over when somebody stopped the
// evening does not count.
void Watcher::Report(Duration now, Verdict& into) const {
  std::vector<bool> over(order_.faults.size());
  for (std::size_t i = 0; i < over.size(); ++i) over[i] = order_.faults[i].at <= now;
  // A fault is over when the last of its expectations has had its time.
  for (const Expectation& one : order_.expectations)
    if (one.fault != kNoFault && one.at + one.time > now) over[static_cast<std::size_t>(one.fault)] = false;
  into.cues += cues_;
  into.missed_cues += missed_;
  into.wrong.insert(into.wrong.end(), wrong_.begin(), wrong_.end());
  for (std::size_t i = 0; i < order_.faults.size(); ++i) {
    if (!over[i] && !failed_[i]) continue;
    ++into.faults;
    if (looked_[i] && !failed_[i]) continue;
    ++into.unanswered_faults;
    into.wrong.push_back(fmt::format("{}:{}: the fault is not answered: {}", file_, order_.faults[i].line,
                                     order_.faults[i].name));
  }
}

}  // namespace kaori::sim
