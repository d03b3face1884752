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

// Whether a unit was started anew twice or more; false where the service manager does not say.
bool Ends(const FaultPlaces& places, const char* unit) {
  const auto shown =
      OutputOf({places.systemctl, "show", "--property=NRestarts", unit}, kMostWord_bytes, kLongestWord);
  return shown && EndsAgainAndAgain(*shown);
}

// A program of the operators' that ends again and again may do so over a device, which no other system would help; beside a block
// that the disk has spoilt it is the system.
std::string SpoiltProgram(const FaultPlaces& places) {
  for (const char* unit : {"kaori-input.service", "kaori-lips.service"}) {
    if (!Ends(places, unit)) continue;
    const auto log = ReadKernelLog(places.journalctl);
    const Reason fault = log ? DiskFault(*log) : Reason{};
    return fault.empty() ? "" : std::string(unit) + " ends again and again, and " + fault.english;
  }
  return {};
}

}  // namespace

std::string FaultOfSystem(const FaultPlaces& places) {
  if (IsThere(places.no_show)) {
    const std::string reason = ReadFile(places.no_show).value_or("");
    return "no show can be played: " + reason.substr(0, reason.find('\n'));
  }
  if (HasShownAFace(places.board)) return SpoiltProgram(places);
  return Ends(places, "kaori-stage.service") ? "the stage ends again and again, and has shown no face" : "";
}

std::string AwaitLastingFault(const FaultPlaces& places) {
  LastingFault lasting;
  while (true) {
    std::string fault = FaultOfSystem(places);
    if (lasting.Lasts(!fault.empty(), SteadyClock().now())) return fault;
    ::sleep(1);
  }
}

}  // namespace kaori::update
