// Plays a show log again, as pictures of any size, or only to see whether it is the same.
#pragma once

#include <memory>
#include <string>

#include "appliance/core/showlog/log_file.h"
#include "drivers/base/options.h"
#include "drivers/base/result.h"
#include "hw-sim/rehearsal/outputs.h"

namespace kaori::sim {

struct LogPlayOptions {
  std::string log, pack;
  // The box's folder of expressions; empty: none were made there.
  std::string own;
  // "19:43:10"; empty: from the beginning.
  std::string at;
  // 0: to the end.
  double length_s = 0;
  // Nothing is drawn where neither a film nor pictures are wanted.
  OutputOptions output;
  // How finely: of stage::IsQualityWish.
  std::string quality = "basic";
};

// How a stretch of a log played.
struct LogPlayed {
  std::uint64_t frames = 0;
  // Frames that do not show what they showed then.
  std::uint64_t differ = 0;
  // Times of day.
  std::string from, until;
  std::string first_difference;
};

// Blocks until all is played and written. What of the log is spoilt is named in the program's log, and the
// rest is played. The film is silent: a log has no sound. Errors: those of the log, the pack and the outputs;
// kInput: the log is of another show, or has nothing at that time.
Result<LogPlayed> PlayLog(const LogPlayOptions& options);

}  // namespace kaori::sim
