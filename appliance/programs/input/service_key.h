// Tells the service manager of the key switch: a file that is there while the key is on. Units that are for
// service alone start by it, and udev authorises sticks by it.
#pragma once

#include <filesystem>
#include <string>

#include "appliance/core/board/board.h"
#include "appliance/core/board/lines.h"
#include "drivers/base/clock.h"

namespace kaori::input {

// The file outlives the program, so that a program that is started anew while somebody brings in an update does not end
// that: how the key stood counts until its line is heard, or for kUnheard, over all starts since. One thread.
class ServiceKey {
 public:
  static constexpr Duration kUnheard = std::chrono::seconds(10);
  // How long the program has run when the box's start counts as over. A bridge to GPIO lines that comes for the first time
  // later was not there when power came, and kaori-usb keeps it out: the key may hang at it.
  static constexpr Duration kStart = std::chrono::seconds(60);

  // To be made before anything that may fail: a program that never comes further takes the file away all the same. `file` is in memory;
  // empty: nobody is told. `now` is of the machine's steady clock, whose times the file may hold.
  ServiceKey(std::filesystem::path file, Time now);

  // Makes or removes the file where the key has been turned. What the board has from before this program began is not heard. A chip that is
  // gone counts as a key that is off. A file that cannot be made is logged once. Once the start is over the file "started"
  // says so beside it.
  void Step(const board::Stamped<board::Lines>& lines, Time now);

 private:
  void SayStarted(Time now);
  void Write(const std::string& unheard_since) const;
  void Remove() const;

  std::filesystem::path file_;
  Time began_{};
  bool on_ = false;
  // The line has not been heard yet, and how the key stood counts until then.
  bool is_unheard_ = true;
  Time until_{};
  bool has_started_ = false;
};

}  // namespace kaori::input
