#include "hw-sim/console/dial_values.h"

#include <algorithm>
#include <utility>

namespace kaori::console {
namespace {

// Buttons and keys without a group fill nothing: no dial names an empty group.
bool Fills(const DialLabel& dial, const std::string& group) {
  return std::ranges::find(dial.filled_by, group) != dial.filled_by.end();
}

}  // namespace

// Which buttons and keys fill a dial is worked out once: their labels do not change while the page is open.
DialValues::DialValues(const Labels& labels) {
  for (std::size_t n = 0; n < dials_.size(); ++n) {
    Dial& dial = dials_[n];
    dial.label = labels.dials[n];
    dial.value = dial.label.start;
    for (std::size_t button = 0; button < labels.buttons.size(); ++button) {
      if (Fills(dial.label, labels.buttons[button].group)) dial.filling_buttons[0] |= 1U << button;
      if (Fills(dial.label, labels.second_buttons[button].group)) dial.filling_buttons[1] |= 1U << button;
    }
    for (const KeyLabel& key : labels.keys)
      if (Fills(dial.label, key.group)) dial.filling_keys.push_back(key.usage);
  }
}

void DialValues::Follow(const sim::DialBox& box, const sim::Keyboard& keyboard, std::size_t sheet) {
  const std::uint32_t down = box.buttons_down();
  const std::uint32_t pushed = down & ~std::exchange(buttons_down_, down);
  // A key that is held down counts once: until it was up again it is no push.
  const auto struck = [&](std::uint8_t usage) { return keyboard.held(usage) && !keys_down_[usage]; };
  for (std::size_t n = 0; n < dials_.size(); ++n) {
    Dial& dial = dials_[n];
    if ((pushed & dial.filling_buttons[sheet]) != 0 || std::ranges::any_of(dial.filling_keys, struck))
      dial.value = 1;
    const double turned = box.turned(static_cast<int>(n));
    const double by = (turned - std::exchange(dial.turned, turned)) * dial.label.per_turn;
    // std::clamp wants the ends in order; labels may be wrong.
    dial.value = std::clamp(dial.value + by, dial.label.low, std::max(dial.label.low, dial.label.high));
  }
  // Only after all dials have looked: one key may fill several.
  for (const Dial& dial : dials_)
    for (const std::uint8_t usage : dial.filling_keys) keys_down_[usage] = keyboard.held(usage);
}

std::optional<double> DialValues::value(int dial) const {
  const Dial& asked = dials_[static_cast<std::size_t>(dial)];
  return asked.label.has_value() ? std::optional(asked.value) : std::nullopt;
}

}  // namespace kaori::console
