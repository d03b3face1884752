#include "firmware/surface/button_log.h"

namespace kaori::surface {

// States wait in a ring until reports have told them. One more is kept only where a button would otherwise
// lose an edge; without a host nobody waits for edges, and the newest state is enough.
void ButtonLog::Note(std::uint32_t pressed, bool hosted) {
  if (pressed == newest()) return;
  if (count_ == 0) return Append(pressed);
  const std::uint32_t last = newest();
  const std::uint32_t before = count_ > 1 ? at(count_ - 2) : told_;
  // A button that changes again would wipe out the edge that waits.
  const bool again = ((before ^ last) & (last ^ pressed)) != 0;
  if (again && hosted && count_ < kStates) return Append(pressed);
  states_[(first_ + count_ - 1) % kStates] = pressed;
  if (pressed == before) --count_;
}

void ButtonLog::Append(std::uint32_t pressed) {
  states_[(first_ + count_) % kStates] = pressed;
  ++count_;
}

// The oldest state that was not told. Without one things stand as they were told.
std::uint32_t ButtonLog::Next() {
  if (count_ == 0) return told_;
  told_ = at(0);
  first_ = (first_ + 1) % kStates;
  --count_;
  return told_;
}

// States that no host fetched are dropped, for they were meant for one that has gone. One report with the
// newest state takes their place; where all buttons are up and nothing waited, none is needed.
void ButtonLog::Restart() {
  const std::uint32_t pressed = newest();
  const bool waits = !empty();
  told_ = 0;
  count_ = 0;
  if (pressed != 0 || waits) Append(pressed);
}

}  // namespace kaori::surface
