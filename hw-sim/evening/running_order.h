// The running order of an evening: what operators do (a scenario), what goes wrong, and what must be seen for
// either.
//
// clang-format off
//   at 10s line go tap                          any line of a scenario (hw-sim/scenario/reader.h)
//   at 10s expect cue 2 within 0.1s             true at some moment from there on; a time of 0 is refused
//   at 10s keep cue 2 for 3s                    true at every moment of it
//   at 60s fault "the camera's cable is out"    what follows in the file, up to the next fault or scene, is of this fault
//   at 60s call goto 14                         what a page calls: goto, standby, level, letgo, load (hw-sim/monitor)
//   at 60s flood 40                             so many calls of a page between two frames
//   at 60s tear dial-box 3                      the first three bytes of a report alone; of HID devices
//   at 60s garbage keyboard 5                   so many bytes that are no report of it
//   at 60s end stage                            and start; of stage, input, lips
//   at 60s board remove                         or cut, or overwrite: what befalls the board's file
//   at 60s disk fill                            what the show log is written to is full, and free again: disk free
//   at 60s freeze 3s                            the whole machine does nothing
// clang-format on
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "appliance/core/show/show.h"
#include "drivers/base/result.h"
#include "hw-sim/evening/condition.h"
#include "hw-sim/rehearsal/rehearsal.h"
#include "hw-sim/scenario/scenario.h"
#include "hw-sim/scenario/tokenizer.h"

namespace kaori::sim {

// Of no fault.
inline constexpr int kNoFault = -1;

// One line "expect" or "keep". All times count from the beginning of the evening.
struct Expectation {
  Duration at{};
  // Within it, or for so long.
  Duration time{};
  // Must hold at every moment.
  bool keep = false;
  Condition condition;
  int line = 0;
  // Of RunningOrder::faults.
  int fault = kNoFault;
};

// What befalls the box, or what a page calls, besides what operators do with devices.
struct Incident {
  enum class Kind : std::uint8_t {
    kCall,
    kFlood,
    kTear,
    kGarbage,
    kEnd,
    kStart,
    kBoardRemove,
    kBoardCut,
    kBoardOverwrite,
    kDiskFill,
    kDiskFree,
    kFreeze
  } kind{};
  Duration at{};
  // The call.
  std::string words;
  // Of kTear and kGarbage.
  DevicePort port{};
  // Bytes, or calls.
  int count = 0;
  // Of kEnd and kStart.
  Program program{};
  // Of kFreeze.
  Duration length{};
  int line = 0;
};

// One line "fault": a name for people, and the moment from which the evening must cope with it.
struct Fault {
  Duration at{};
  std::string name;
  int line = 0;
};

// A plain value: it outlives the watcher and the incidents, which borrow from it.
struct RunningOrder {
  Scenario play;
  // By time, as are the next two.
  std::vector<Incident> incidents;
  std::vector<Expectation> expectations;  //
  // In the order of the file.
  std::vector<Fault> faults;
  // When all of it is over.
  Duration length{};
};

struct RunningOrderRead {
  // Of all lines that could be read.
  RunningOrder order;
  // By line; with any, the order is not to be played.
  std::vector<Problem> problems;
};

// Pure. Cues and levels are those of the show.
RunningOrderRead ReadRunningOrder(std::string_view text, const show::Show& show);

// Reads a file; blocks for the disk. Errors: those of the file; invalid_argument with every problem
// described, and where there is no line, by which an evening would be played that nobody wants.
Result<RunningOrder> LoadRunningOrder(const std::string& path, const show::Show& show);

// Leaves what begins and is over by then; `length` is to be a moment at which no fault is on.
void Shorten(RunningOrder& order, Duration length);

}  // namespace kaori::sim
