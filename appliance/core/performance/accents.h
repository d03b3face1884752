// What the voice does to brows and head: she means what she says.
#pragma once

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/life_state.h"

namespace kaori::performance {

struct Accent {
  float brow = 0;           // Raises the brows, 0..0.35.
  float nod_pitch_rad = 0;  // Negative: the head nods.
};

// Moves the accents on by dt_s with the voice on the board. A voice that rises by 6 dB within 100 ms raises
// the brows for 0.3 s, at most once in 0.8 s; the end of a phrase is a nod of 3 degrees. What has begun is
// carried to its end.
Accent Accentuate(AccentLife& life, const board::Stamped<board::Voice>& voice, float dt_s);

}  // namespace kaori::performance
