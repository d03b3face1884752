// What came of an evening, and whether that is good.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/json.h"

namespace kaori::sim {

// What a program has in use at a moment of its evenings.
struct MemoryAt {
  // Of simulated time.
  double hours = 0;
  double resident_kb = 0;
};

// All counts are of the evening, or of all evenings that were added.
struct Verdict {
  int evenings = 0;
  // Of simulated time.
  double minutes = 0;
  std::uint64_t cues =
      // Calls of which something was expected: a cue that is on, or a GO that is refused.
      0;
  std::uint64_t missed_cues = 0;
  std::uint64_t go_sent = 0, go_played = 0, go_refused = 0;
  std::uint64_t faults = 0, unanswered_faults = 0;
  // That the log has.
  std::uint64_t frames = 0;
  // Of these, those that show something else when they play again.
  std::uint64_t replay_bits_differ = 0;
  // That were drawn, and drawn again from the log.
  std::uint64_t pictures = 0;
  // On the evening itself; lost parts of the log have some of them.
  std::uint64_t pictures_drawn = 0;
  // Another picture from the log, or not black in a blackout.
  std::uint64_t wrong_pictures = 0;
  std::uint64_t log_bytes = 0;
  // Chunks of which a full disk kept nothing,
  std::uint64_t log_parts_lost = 0;
  // and how many it may have been.
  std::uint64_t log_parts_allowed = 0;
  std::uint64_t frame_path_allocations = 0;
  // Descriptors of the whole process, simulated devices and programs together.
  int open_files_start = 0, open_files_end = 0;
  // Of real time, for all of it,
  double seconds = 0;
  // and of the processor, which other programs of the machine do not lengthen.
  double processor_seconds = 0;
  bool stopped = false;
  // Each evening was played to its end: bounds of its length and of its counts hold too.
  bool whole = false;
  std::vector<MemoryAt> memory;
  std::vector<std::string>
      // A sentence for each thing that is not as it must be, with its line in the file.
      wrong;
};

// Adds another evening behind those before it.
void Add(const Verdict& evening, Verdict& to);

// All of `wrong`, and a sentence for each figure beyond its bound. How long it took is the machine's, and has
// none.
std::vector<std::string> WhatIsWrong(const Verdict& verdict);
inline bool IsGood(const Verdict& verdict) {
  return WhatIsWrong(verdict).empty();
}

// By least squares over the samples after the first ten minutes, in which caches fill; 0 with less than ten
// of them, or where they span less than an hour: memory then grows by steps, as each act shows something for
// the first time. Of several evenings, the samples after the first one.
double MemorySlope_kb_per_h(const Verdict& verdict);

// As out/evening.json and out/soak.json have it.
json::Object ToJson(const Verdict& verdict);

}  // namespace kaori::sim
