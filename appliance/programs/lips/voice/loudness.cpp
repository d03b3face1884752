#include "appliance/programs/lips/voice/loudness.h"

#include <algorithm>
#include <cmath>

namespace kaori::voice {

// Summed up in double: a second of quiet sound is thousands of tiny squares.
float Level_db(std::span<const float> samples) {
  double power = 0;
  for (const float sample : samples) power += static_cast<double>(sample) * static_cast<double>(sample);
  if (samples.empty() || !(power > 0)) return kSilent_db;
  const double mean = power / static_cast<double>(samples.size());
  return std::max(kSilent_db, static_cast<float>(10 * std::log10(mean)));
}

// The level follows exponentially, faster up than down: a consonant opens the gate at once, and a pause
// within a word does not shut it. `hold` counts from the last time at which it was loud.
bool Gate::Accept(float level_db, Time at, Duration length) {
  const float now_db = std::isnan(level_db) ? kSilent_db : std::max(level_db, kSilent_db);
  const Duration slowness = now_db > level_db_ ? settings_.rise : settings_.fall;
  const double share = 1 - std::exp(-Seconds(length) / std::max(Seconds(slowness), 1e-6));
  level_db_ += static_cast<float>(share) * (now_db - level_db_);
  if (level_db_ >= settings_.opens_db) open_ = true;
  if (level_db_ >= settings_.shuts_db) loud_at_ = at;
  if (open_ && at - loud_at_ > settings_.hold) open_ = false;
  return open_;
}

}  // namespace kaori::voice
