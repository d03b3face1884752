// Whether the show's needles are open: no report tells; who stands by the box knows who pressed Tab.
#pragma once

#include <cstdint>

namespace kaori::console {

// A stage begins with its needles shut; it died when the screen lost it with the cable still in.
class EditorWatch {
 public:
  static constexpr std::uint8_t kTab = 0x2B;  // Usage of HID page 7.

  struct Seen {
    bool tab_held = false;
    bool keyboard_heard = false;  // A program has the keyboard open,
    bool screen_drawn = false;    // and another one the screen.
    bool screen_plugged = true;
  };

  // Some 100 calls a second see every push.
  void Follow(const Seen& now);

  bool open() const { return open_; }

 private:
  bool open_ = false;
  Seen before_;
};

}  // namespace kaori::console
