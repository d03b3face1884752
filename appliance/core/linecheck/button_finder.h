// Which button a person pushes: learn mode asks for one, as ControlFinder does for controls that move.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "appliance/core/board/line_check.h"
#include "appliance/core/board/snapshot.h"
#include "appliance/core/linecheck/trace.h"
#include "appliance/core/show/call.h"
#include "drivers/base/clock.h"

namespace kaori::linecheck {

// Looks at the buttons of the dial box and of both sticks. The first push begins half a second of looking; the button is found
// when no other one was pushed in it, and it not more than three times. One that chatters as no finger does
// counts for nothing. The search goes on. One thread; time is an argument and does not go back. Allocates nothing.
class ButtonFinder {
 public:
  void Begin(const board::Snapshot& board, Time now);
  // To be called once a frame.
  void Look(const board::Snapshot& board, Time now);

  // The button that was found last.
  const std::optional<board::CheckedItem>& found() const { return found_; }
  // Two were pushed together, and none was found; until the next is.
  bool ambiguous() const { return ambiguous_; }
  // The first one that chatters.
  std::optional<board::CheckedItem> restless() const;
  // When anything was found, or was ambiguous, last.
  Time changed_at() const { return changed_at_; }

 private:
  // How often a button was pushed since the last decision; 0 of one that chatters.
  std::uint32_t PushesOf(std::size_t button) const {
    return noisy_[button] ? 0 : contacts_[button].pushes() - decided_[button];
  }
  void Decide(Time now);

  std::array<Contact, show::kAllButtonCount> contacts_{};
  std::array<bool, show::kAllButtonCount> noisy_{};             // Since it began.
  std::array<std::uint32_t, show::kAllButtonCount> decided_{};  // Pushes of which it was decided.
  std::optional<Time> decides_at_;
  std::optional<board::CheckedItem> found_;
  bool ambiguous_ = false;
  Time changed_at_{};
};

}  // namespace kaori::linecheck
