#include "drivers/base/start_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <utility>

#include "drivers/base/log.h"
#include "drivers/base/number.h"
#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::service {
namespace {

// Four times the patience is 40 s for the fastest machine, and four minutes for a first step.
constexpr int kMostDoublings = 2;
// A day: a file that says more is torn.
constexpr std::int64_t kMostFirst_ms = 86'400'000;

// What is known of the starts before this one.
struct Before {
  int in_vain = 0;   // In a row, up to now.
  Duration first{};  // What the first step of a whole one took; 0: there was none.
};

// "1 420": one in vain, and 420 ms. What is missing or torn says nothing.
Before ReadBefore(const std::string& file) {
  const std::string text = ReadFile(file).value_or("");
  const std::size_t space = std::min(text.find(' '), text.size());
  const auto in_vain = ParseNumber<int>(std::string_view(text).substr(0, space));
  const auto first_ms =
      ParseNumber<std::int64_t>(std::string_view(text).substr(std::min(space + 1, text.size())));
  if (!in_vain || !first_ms || *first_ms < 0 || *first_ms > kMostFirst_ms) return {};
  return {std::clamp(*in_vain, 0, kMostDoublings), std::chrono::milliseconds(*first_ms)};
}

void Warn(const Result<void>& told) {
  if (!told) LogWarning("{}", told.error().message());
}

void Note(const std::string& file, const Before& now) {
  const auto first = std::chrono::ceil<std::chrono::milliseconds>(now.first);
  Warn(WriteWholeFile(file, {AsBytes(fmt::format("{} {}", now.in_vain, first.count()))}));
}

}  // namespace

StartWatch::StartWatch(const Clock& clock, std::string starts)
    : clock_(clock), starts_(std::move(starts)), watchdog_(Watchdog::Wanted()), last_(clock.now()) {
  Before before;
  if (watchdog_) {
    longest_ = watchdog_->limit();
    before = ReadBefore(starts_);
    patience_ = 1 << before.in_vain;
  }
  const bool is_known = before.first > Duration();
  Allow(is_known ? std::max(before.first * kPatientSteps, kLeast) : kFirstStep, is_known);
  if (watchdog_) Note(starts_, {before.in_vain + 1, before.first});
}

void StartWatch::Step() {
  const Time now = clock_.now();
  const Duration took = now - std::exchange(last_, now);
  if (first_ == Duration()) first_ = took;
  slowest_ = std::max(slowest_, took);
  Allow(std::max(slowest_ * kPatientSteps, kLeast), true);
}

void StartWatch::Ready() {
  Warn(Tell("READY=1"));
  if (watchdog_) Note(starts_, {0, first_});
}

// The first step on an unknown machine may be longer than what the unit's watchdog allows.
void StartWatch::Allow(Duration limit, bool is_watched) {
  limit_ = limit * patience_;
  if (watchdog_ && is_watched) limit_ = std::min(limit_, longest_);
  Warn(ExtendStart(limit_));
  if (watchdog_ && is_watched) Warn(watchdog_->BeatWithin(limit_));
}

}  // namespace kaori::service
