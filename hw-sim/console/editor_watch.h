// Whether the show's needles are open: no report tells; who stands by the box knows who pressed Tab.
#pragma once

#include <cstdint>

namespace kaori::console {

// Guesses what the stage does with Tab by the rules that the stage follows: it begins with its
// needles shut; it died when the screen lost it with the cable still in. A guess that is wrong is
// put right by the next start of the stage.
class EditorWatch {
 public:
  static constexpr std::uint8_t kTab = 0x2B;  // Usage of HID page 7.

  // What can be seen from outside, at one moment.
  struct Seen {
    bool tab_held = false;
    bool keyboard_heard = false;  // A program has the keyboard open,
    bool screen_drawn = false;    // and another one the screen.
    bool screen_plugged = true;
  };

  // Compares with the call before; some 100 calls a second see every push.
  void Follow(const Seen& now);

  // Whether the stage shows them, as far as one can tell from outside.
  bool open() const { return open_; }

 private:
  bool open_ = false;
  Seen before_;
};

}  // namespace kaori::console
