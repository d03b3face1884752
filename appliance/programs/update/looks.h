// What is looked at while a system is tried: its picture, its programs, and whether its disk holds what it should.
// Each gives what is wrong; empty: nothing. No file is read here.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "appliance/programs/update/reason.h"
#include "drivers/base/clock.h"

namespace kaori::update {

// How far a face that breathes may be from its still: mean difference of 255 steps, as when the image's disk is tried.
inline constexpr double kMostApart = 12;

// The stage's picture and the pictures of which one is expected, all as PPM files. 600 places are compared, in units of
// the picture's height from its middle, so that screens of different widths compare.
Reason PictureFault(std::string_view shown, const std::vector<std::string_view>& expected);

// Whether a program that was started anew since the box was switched on is a fault. It is one of a version; a system that is
// tried because the other one shows no face is kept with it, since to give way would be to show none.
enum class Restarts : std::uint8_t { kAreFaults, kAreNone };

// Tells whether the screen still takes new frames, from one look to the next: the stage's canvas goes on without a screen, and its
// picture would stay that of the face. One thread.
class ShownFrames {
 public:
  // A machine whose processor draws for others too may take seconds for a frame.
  static constexpr Duration kLongestStill = std::chrono::seconds(20);

  // `flipped_at` is when the newest frame came onto the screen, as the stage has it on the board; the clock's beginning where none did.
  Reason Fault(Time flipped_at, Time now);

 private:
  Time flipped_at_{};
  Time changed_at_{};  // The clock's beginning, where none came yet.
};

// What `systemctl show --property=Id,ActiveState,NRestarts` says of so many units: each has to run, and none was started anew.
Reason ProgramsFault(std::string_view shown, std::size_t units, Restarts restarts);

// What `systemctl show --property=NRestarts,ActiveEnterTimestampMonotonic` says of one unit: whether it was started anew twice or
// more; and whether it has run on for ten seconds at `now`, which whatever ends again and again never does: the number of its starts
// stands for ever.
bool EndsAgainAndAgain(std::string_view shown);
bool RunsOn(std::string_view shown, Time now);

// The kernel's log: dm-verity names each block that is not what the root's hash says.
Reason DiskFault(std::string_view kernel_log);

}  // namespace kaori::update
