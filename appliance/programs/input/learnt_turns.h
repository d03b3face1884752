// How many counts one turn of a device's dials has, where the box has learnt it from a turn that a person made.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "drivers/base/result.h"
#include "drivers/ports/hid_channel.h"

namespace kaori::input {

// A hand stops within a hundredth or two of a turn: counts that are within 4 percent of what encoders usually have
// are that, and others stay as they are. Pure.
int UsualCounts(int counts);

// Kept in a file of the box:
//   [[device]]
//   usb = "2580:0007"              0000:0000 of what is not on USB
//   name = "Midi Fighter Twister"
//   counts_per_turn = 96
// Two equal devices have equal encoders, so that the socket does not count. One thread.
class LearntTurns {
 public:
  // Reads the file, once; blocks for the disk. One that is missing says nothing; what is wrong in it is logged, and
  // counts for nothing. Empty: nothing is kept.
  explicit LearntTurns(std::filesystem::path file);

  // 0: never learnt.
  int CountsOf(const ports::HidIdentity& identity) const;
  // From now on, and after the next start. Blocks for the disk: it is done in service alone, when somebody has
  // agreed to it. Errors: those of WriteWholeFile, and
  //   operation_not_supported  this box keeps nothing
  // and what was learnt before counts then.
  Result<void> Keep(const ports::HidIdentity& identity, int counts);

 private:
  struct Device {
    std::string usb;
    std::string name;
    int counts = 0;
  };
  static Device DeviceOf(const ports::HidIdentity& identity);

  std::filesystem::path file_;
  std::vector<Device> devices_;
};

}  // namespace kaori::input
