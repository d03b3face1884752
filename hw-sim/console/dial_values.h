// Where the dials' values stand, as the show counts them: dials have no end, their values have.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "hw-sim/console/labels.h"
#include "hw-sim/devices/dial_box.h"
#include "hw-sim/devices/keyboard.h"

namespace kaori::console {

// Of the dial box.
inline constexpr int kDialCount = 8;

// Watches the simulated controls from the outside, as somebody who stands by the box, and
// begins with the values with which a show opens. No report tells them: a show that went on
// while the simulator was away knows better. The numbers on the page are therefore a help for
// people, and nothing that plays depends on them.
class DialValues {
  // Copies the labels. Buttons and keys that fill a dial are found by their groups.
 public:
  explicit DialValues(const Labels& labels);

  // Looks at what was done since the last call; some 100 calls a second see every push. A call puts
  // pushed dials to 1 first and then adds what was turned, within the dial's ends. `sheet` is the one that
  // the buttons have now, 0 or 1.
  void Follow(const sim::DialBox& box, const sim::Keyboard& keyboard, std::size_t sheet);

  // Where the dial stands, in the label's unit; nothing where the label tells
  // of no value. `dial` is 0 to 7.
  std::optional<double> value(int dial) const;

 private:
  // A dial's value, and what of the box changes it.
  struct Dial {
    DialLabel label;
    double value = 0;
    double turned = 0;  // All turns, at the last call.
    // By the sheet; bit n: button n puts this dial to 1.
    std::array<std::uint32_t, 2> filling_buttons{};
    // The usages of the keys that put it to 1.
    std::vector<std::uint8_t> filling_keys{};
  };

  std::array<Dial, kDialCount> dials_;
  // As at the last call: a push is a button that was not down before.
  std::uint32_t buttons_down_ = 0;
  std::array<bool, 256> keys_down_{};
};

}  // namespace kaori::console
