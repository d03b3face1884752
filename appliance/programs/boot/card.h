// A graphics card as the first program finds it: lights its screens with one picture, by the kernel's
// plainest calls.
#pragma once

#include <vector>

#include "appliance/programs/boot/still.h"

namespace kaori::boot {

// A screen that is lit: which of the card's controllers shows it, and the picture.
struct Lit {
  unsigned controller = 0;
  unsigned framebuffer = 0;
};

// One card's open file; the pictures stay on its screens for as long as it is open and nothing else is shown.
class Card {
 public:
  // None, as a number below 0, where it cannot be opened.
  explicit Card(const char* path);
  ~Card();
  Card(const Card&) = delete;
  Card& operator=(const Card&) = delete;

  // Shows the still on every screen that is plugged in, in the mode that the screen prefers. What fails stays
  // dark.
  std::vector<Lit> Light(const Still& still) const;

  // Lets the next program that opens the card show pictures. Ours stay until it does.
  void GiveWay() const;

  // Whether any of the pictures is still shown.
  bool Shows(const std::vector<Lit>& pictures) const;

 private:
  int fd_;
};

}  // namespace kaori::boot
