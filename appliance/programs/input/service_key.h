// Tells the service manager of the key switch: a file that is there while the key is on. Units that are for
// service alone start by it, and udev lets sticks in by it.
#pragma once

#include <filesystem>

#include "appliance/core/board/board.h"
#include "appliance/core/board/lines.h"

namespace kaori::input {

// One thread. Begins with the file away, whatever was there.
class ServiceKey {
 public:
  // `file` is in memory; empty: nobody is told.
  explicit ServiceKey(std::filesystem::path file);
  ~ServiceKey();
  ServiceKey(const ServiceKey&) = delete;
  ServiceKey& operator=(const ServiceKey&) = delete;

  // Makes or removes the file where the key has been turned. A chip that is gone counts as a key that is off.
  // A file that cannot be made is logged once.
  void Step(const board::Stamped<board::Lines>& lines);

 private:
  std::filesystem::path file_;
  bool on_ = false;
};

}  // namespace kaori::input
