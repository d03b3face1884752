#include "drivers/base/silence_log.h"

#include <utility>

#include "drivers/base/log.h"

namespace kaori {
namespace {

// Long enough for a log that stays readable, short enough that a
// technician who watches it sees the fault go on.
constexpr Duration kQuiet = std::chrono::minutes(1);

}  // namespace

// Silences that follow soon are counted instead, and told with the next one that is said.
void SilenceLog::Silent(Duration length, Time now) {
  said_ = now >= quiet_until_;
  if (!said_) {
    ++unsaid_;
    return;
  }
  quiet_until_ = now + kQuiet;
  const int more = std::exchange(unsaid_, 0);
  const std::string often = more > 0 ? fmt::format(", as {} times since it was said last", more) : "";
  LogWarning("{}: silent for {} ms{}; {}", source_, length / std::chrono::milliseconds(1), often,
             consequence_);
}

void SilenceLog::Speaks() {
  if (std::exchange(said_, false)) Log("{}: live", source_);
}

}  // namespace kaori
