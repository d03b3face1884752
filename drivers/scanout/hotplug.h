// The kernel's word that something was plugged into a graphics card, or pulled.
#pragma once

#include <span>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::scanout {

// Whether a uevent, as the kernel sends it, speaks of a screen that came or went.
bool SpeaksOfScreens(std::span<const char> uevent);

// Some cards notice by themselves what is plugged into them, others only when they are asked; all of them say
// that it is time to ask.
class Hotplug {
 public:
  // Listens from now on. Errors: those of socket(2), as where a sandbox forbids it.
  static Result<Hotplug> Open();
  Hotplug() = default;  // Deaf.

  // Whether there was word since this was asked last. Does not wait.
  bool Heard();

 private:
  explicit Hotplug(UniqueFd socket) : socket_(std::move(socket)) {}

  UniqueFd socket_;
};

}  // namespace kaori::scanout
