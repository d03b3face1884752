// Starts the box's own first program from a disk of the bench, and leaves the agent behind in the guest.
#pragma once

#include <string>
#include <vector>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::agent {

// "name=value" on the kernel's command line; empty where it is not there.
std::string OnCommandLine(const std::string& command_line, const std::string& name);

// The roots that the agent keeps open.
struct Roots {
  UniqueFd box;    // The box's root, as its own programs see it.
  UniqueFd bench;  // The bench's disk.
};

// Run as the kernel's first program. Mounts the box's root, forks, and in the first process makes that root
// the machine's and becomes the program that the command line names (kaori.root=, kaori.rootfstype=,
// kaori.init=): from there on the machine is what it is without a bench. Returns in the agent, whose own
// root stays the bench's disk.
Result<Roots> StartTheBox();

}  // namespace kaori::agent
