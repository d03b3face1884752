#include "hw-sim/evening/verdict.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace kaori::sim {
namespace {

// Memory of the first ten minutes tells nothing, since caches fill in that time.
constexpr double kCachesFill_h = 10.0 / 60;
// A line through fewer samples follows single steps of the allocator.
constexpr std::size_t kLeastSamples = 10;
// What each act brings for the first time stays in memory: over less than an hour its steps are no slope.
constexpr double kLeastSpan_h = 1;
// Over a week of playing without a stop this is 11 MB.
constexpr double kMostSlope_kb_per_h = 64;
// Over an evening of two hours this is 36 MB.
constexpr double kMostLog_kb_per_min = 300;
// Kilobytes of the log are of 1000 bytes, as disks are sold; those of memory are of 1024, as Linux counts.
constexpr double kBytesPerKb = 1000;
// Of each whole evening.
// These say that the running order is still the full one: a shortened file must not pass as an evening.
constexpr std::uint64_t kLeastCues = 60, kLeastFaults = 15;
constexpr double kLeastMinutes = 100;

double LogPerMinute_kb(const Verdict& verdict) {
  return verdict.minutes > 0 ? static_cast<double>(verdict.log_bytes) / kBytesPerKb / verdict.minutes : 0;
}

}  // namespace

void Add(const Verdict& evening, Verdict& to) {
  // The evening's own time begins at 0: it goes on where the evenings before it ended.
  for (const MemoryAt& at : evening.memory) to.memory.push_back({at.hours + to.minutes / 60, at.resident_kb});
  // Files that stay open add up over all evenings: the first beginning is compared with the last end.
  if (to.evenings == 0) to.open_files_start = evening.open_files_start;
  to.open_files_end = evening.open_files_end;
  to.evenings += evening.evenings;
  to.minutes += evening.minutes;
  to.seconds += evening.seconds;
  to.processor_seconds += evening.processor_seconds;
  to.stopped = to.stopped || evening.stopped;
  for (const auto count :
       {&Verdict::cues, &Verdict::missed_cues, &Verdict::go_sent, &Verdict::go_played, &Verdict::go_refused,
        &Verdict::faults, &Verdict::unanswered_faults, &Verdict::frames, &Verdict::replay_bits_differ,
        &Verdict::pictures, &Verdict::pictures_drawn, &Verdict::wrong_pictures, &Verdict::log_bytes,
        &Verdict::log_parts_lost, &Verdict::log_parts_allowed, &Verdict::frame_path_allocations})
    to.*count += evening.*count;
  to.wrong.insert(to.wrong.end(), evening.wrong.begin(), evening.wrong.end());
}

std::vector<std::string> WhatIsWrong(const Verdict& verdict) {
  std::vector<std::string> wrong = verdict.wrong;
  const auto bound = [&wrong](bool good, std::string sentence) {
    if (!good) wrong.push_back(std::move(sentence));
  };
  bound(verdict.missed_cues == 0, fmt::format("{} cues were missed", verdict.missed_cues));
  bound(verdict.unanswered_faults == 0,
        fmt::format("{} faults were not answered", verdict.unanswered_faults));
  bound(verdict.replay_bits_differ == 0,
        fmt::format("{} frames show something else when they play again", verdict.replay_bits_differ));
  bound(verdict.minutes <= 0 || verdict.frames > 0, "the log has no frame that could play again");
  // A full disk loses parts of the log with their pictures; half of them must be there to be compared.
  bound(2 * verdict.pictures >= verdict.pictures_drawn,
        fmt::format("{} pictures were drawn, and the log has {} of them", verdict.pictures_drawn,
                    verdict.pictures));
  bound(verdict.wrong_pictures == 0, fmt::format("{} pictures are wrong", verdict.wrong_pictures));
  bound(verdict.frame_path_allocations == 0,
        fmt::format("frames allocated memory {} times", verdict.frame_path_allocations));
  bound(verdict.log_parts_lost <= verdict.log_parts_allowed,
        fmt::format("{} parts of the log are lost, and {} may be", verdict.log_parts_lost,
                    verdict.log_parts_allowed));
  bound(verdict.open_files_end == verdict.open_files_start,
        fmt::format("{} files are open at the end, and {} were at the beginning", verdict.open_files_end,
                    verdict.open_files_start));
  bound(LogPerMinute_kb(verdict) <= kMostLog_kb_per_min,
        fmt::format("the log takes {:.0f} KB a minute", LogPerMinute_kb(verdict)));
  const auto evenings = static_cast<std::uint64_t>(std::max(verdict.evenings, 1));
  bound(!verdict.whole || verdict.minutes >= kLeastMinutes * static_cast<double>(evenings),
        fmt::format("{} evenings have {:.0f} minutes", evenings, verdict.minutes));
  bound(!verdict.whole || verdict.cues >= kLeastCues * evenings,
        fmt::format("{} evenings have {} cues", evenings, verdict.cues));
  bound(!verdict.whole || verdict.faults >= kLeastFaults * evenings,
        fmt::format("{} evenings have {} faults", evenings, verdict.faults));
  bound(MemorySlope_kb_per_h(verdict) <= kMostSlope_kb_per_h,
        fmt::format("memory grows by {:.0f} KB an hour", MemorySlope_kb_per_h(verdict)));
  return wrong;
}

double MemorySlope_kb_per_h(const Verdict& verdict) {
  // Of several evenings the first one is left out as a whole: their mean length says where it ended.
  const double from_h = verdict.evenings > 1 ? verdict.minutes / 60 / verdict.evenings : kCachesFill_h;
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const MemoryAt& at : verdict.memory) {
    if (at.hours < from_h) continue;
    n += 1;
    x += at.hours;
    y += at.resident_kb;
    xx += at.hours * at.hours;
    xy += at.hours * at.resident_kb;
  }
  // The slope is (n Σxy - Σx Σy) / (n Σx² - (Σx)²), with x in hours and y in KB.
  const double spread = n * xx - x * x;
  const bool long_enough = !verdict.memory.empty() && verdict.memory.back().hours - from_h >= kLeastSpan_h;
  return n < kLeastSamples || !long_enough || spread <= 0 ? 0 : (n * xy - x * y) / spread;
}

json::Object ToJson(const Verdict& verdict) {
  return {{"good", IsGood(verdict)},
          {"evenings", verdict.evenings},
          {"stopped", verdict.stopped},
          {"minutes", verdict.minutes},
          {"cues", verdict.cues},
          {"missed_cues", verdict.missed_cues},
          {"go_sent", verdict.go_sent},
          {"go_played", verdict.go_played},
          {"go_refused", verdict.go_refused},
          {"faults", verdict.faults},
          {"unanswered_faults", verdict.unanswered_faults},
          {"frames", verdict.frames},
          {"replay_bits_differ", verdict.replay_bits_differ},
          {"pictures", verdict.pictures},
          {"wrong_pictures", verdict.wrong_pictures},
          {"frame_path_allocations", verdict.frame_path_allocations},
          // One digit behind the point is more than the measurement holds.
          {"rss_slope_kb_per_h", std::round(MemorySlope_kb_per_h(verdict) * 10) / 10},
          {"open_files_start", verdict.open_files_start},
          {"open_files_end", verdict.open_files_end},
          {"log_kb_per_min", std::round(LogPerMinute_kb(verdict) * 10) / 10},
          {"log_parts_lost", verdict.log_parts_lost},
          {"log_parts_allowed", verdict.log_parts_allowed},
          {"seconds", std::round(verdict.seconds * 10) / 10},
          {"processor_seconds", std::round(verdict.processor_seconds * 10) / 10},
          {"wrong", json::ListOf(WhatIsWrong(verdict))}};
}

}  // namespace kaori::sim
