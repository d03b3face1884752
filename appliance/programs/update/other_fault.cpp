#include "appliance/programs/update/other_fault.h"

#include <unistd.h>

#include "appliance/core/board/board.h"
#include "appliance/programs/update/kernel_log.h"
#include "appliance/programs/update/looks.h"
#include "appliance/programs/update/trial.h"
#include "drivers/base/folder.h"
#include "drivers/base/read_file.h"
#include "drivers/base/run_program.h"

namespace kaori::update {
namespace {

constexpr std::size_t kMostWord_bytes = std::size_t{4} << 10U;
constexpr auto kLongestWord = std::chrono::seconds(20);  // Of systemctl, beside a busy machine.

// Frames of all the stages of this start; a board that is not there yet, or that no stage has written, has none.
bool HasShownAFace(const std::string& path) {
  const auto board = board::Board::Open(path);
  return board && board->Read<board::StageStatus>().value.frames > 0;
}

// What the service manager says of a unit's starts; nothing where it does not say.
std::string StartsOf(const FaultPlaces& places, const char* unit) {
  return OutputOf({places.systemctl, "show", "--property=NRestarts,ActiveEnterTimestampMonotonic", unit},
                  kMostWord_bytes, kLongestWord)
      .value_or("");
}

// A program of the operators' that ends again and again may do so over a device, which no other system would help; beside a block
// that the disk has spoilt it is the system.
std::string SpoiltProgram(const FaultPlaces& places, Time now) {
  for (const char* unit : {"kaori-input.service", "kaori-lips.service"}) {
    const std::string starts = StartsOf(places, unit);
    if (!EndsAgainAndAgain(starts) || RunsOn(starts, now)) continue;
    const auto log = ReadKernelLog(places.journalctl);
    const Reason fault = log ? DiskFault(*log) : Reason{};
    return fault.empty() ? "" : std::string(unit) + " ends again and again, and " + fault.english;
  }
  return {};
}

}  // namespace

std::string FaultOfSystem(const FaultPlaces& places, Time now) {
  if (IsThere(places.no_show)) {
    const std::string reason = ReadFile(places.no_show).value_or("");
    return "no show can be played: " + reason.substr(0, reason.find('\n'));
  }
  if (HasShownAFace(places.board)) return SpoiltProgram(places, now);
  return EndsAgainAndAgain(StartsOf(places, "kaori-stage.service"))
             ? "the stage ends again and again, and has shown no face"
             : "";
}

std::string AwaitLastingFault(const FaultPlaces& places) {
  LastingFault lasting;
  while (true) {
    const Time now = SteadyClock().now();
    std::string fault = FaultOfSystem(places, now);
    if (lasting.Lasts(!fault.empty(), now)) return fault;
    ::sleep(1);
  }
}

}  // namespace kaori::update
