// The box's programs that play all evening, as its service manager tells of them: whether one has ended meanwhile.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "drivers/base/result.h"
#include "hw-sim/hil/protocols.h"

namespace kaori::hil {

// A unit of the service manager that runs one program.
struct BoxProgram {
  // "kaori-stage".
  std::string name;
  // The number of its process; 0: it does not run.
  int process = 0;
  // How often the service manager has started it again by itself, since somebody last started it.
  int restarts = 0;
  friend bool operator==(const BoxProgram&, const BoxProgram&) = default;
};

// The stage, the fd keeper, input and lips. Blocks until the agent answers, two minutes at most. Errors: as
// AgentProtocol::Ask; io_error, the service manager does not tell of all of them.
Result<std::vector<BoxProgram>> LookAtPrograms(AgentProtocol& agent);

// What "systemctl show -p Id,MainPID,NRestarts UNIT..." says: lines NAME=VALUE in any order, an empty line between two units.
// What else it says is passed over. Pure.
std::vector<BoxProgram> ReadPrograms(std::string_view said);

// Says which of the programs that ran before has ended since, as "kaori-input has ended meanwhile and was started again"; empty
// where none has. One that did not run before and runs now has only been started. Pure.
std::string EndedSince(const std::vector<BoxProgram>& before, const std::vector<BoxProgram>& now);

}  // namespace kaori::hil
